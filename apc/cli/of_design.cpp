#include "apc/cli/of_design.h"

namespace apc::cli {

LoadedDesign load_design_models(const OfDesign& words) {
  LoadedDesign out;
  out.design = design::load_design(words.design);
  auto loaded = load_fleet_models(
      out.design.fleet, note("design", words.design, out.design.program + ": " + out.design.command), words.choice);
  out.models = std::move(loaded.models), out.files = std::move(loaded.files);
  for (auto& model : out.models) model.bed = out.design.bed;
  return out;
}

}  // namespace apc::cli
