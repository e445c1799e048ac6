#include "apc/report/manifest_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace apc::report {

using Value = nlohmann::ordered_json;

Value number_or_null(double value) { return std::isfinite(value) ? Value(value) : Value(nullptr); }

Value provenance(const Manifest& manifest) {
  Value out{{"program", manifest.version}, {"command", manifest.command}, {"files", Value::array()}};
  for (const auto& file : manifest.files)
    out["files"].push_back(
        {{"role", file.role}, {"path", file.path}, {"sha256", file.sha256}, {"source", file.source}});
  return out;
}

}  // namespace apc::report
