/// What the file formats mean, key by key, for `apc describe`.
#pragma once

#include <string>
#include <vector>

namespace apc::cli {

/// One key (or column) of a format.
struct KeyNote {
  std::string key;      ///< as it stands in the file; nested keys with dots: "cg.height"
  std::string kind;     ///< "length", "number", "text", "list of lengths"
  std::string need;     ///< "required", or what holds without it: "optional; 0"
  std::string meaning;  ///< one sentence, with sign and reference where they matter
  std::string example;
};

struct FormatNote {
  std::string schema;   ///< "apc-bed/1"
  std::string what;     ///< one sentence
  std::string general;  ///< rules that hold for the whole file
  std::vector<KeyNote> keys;
};

FormatNote describe_aircraft();
FormatNote describe_tire();
FormatNote describe_bed();
FormatNote describe_loads();
FormatNote describe_material();
FormatNote describe_sph();
FormatNote describe_fleet();
FormatNote describe_design();
FormatNote describe_scatter();
FormatNote describe_site();
FormatNote describe_model();
FormatNote describe_manifest();
FormatNote describe_case();
FormatNote describe_run();
FormatNote describe_effect();

std::vector<FormatNote> all_formats();

}  // namespace apc::cli
