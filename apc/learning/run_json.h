/// Reading one run (schema "apc-run/1") with its signals and survey.
#pragma once

#include <map>

#include "apc/learning/measured.h"

namespace apc::learning {

/// Foreign names of a flight recorder: column → quantity, unit and sign ("apc-aliases/1":
/// `{"columns": {"GS [kt]": {"quantity": "speed", "noise": "1 kt"}}, "time": "TIME [s]", "time_offset": "12.4 s"}`).
struct Aliases {
  std::map<std::string, Channel> columns;  ///< by column name without unit
  std::map<std::string, double> factors;   ///< sign or scale to apply, by column name
  std::string time = "time";
  double time_offset = 0.0;  ///< recorder's time at entry, s
};
Aliases load_aliases(const std::filesystem::path&);

/// InputError when the run cannot be read at all. Repairs and dropped channels are remarked.
Run load_run(const std::filesystem::path&, const aircraft::Aircraft&, const bed::Bed&, const Aliases*,
             std::vector<DataRemark>&);

/// Years between two dates "2019-03-01"; NaN when one is malformed.
double years_between(const std::string& from, const std::string& to);

}  // namespace apc::learning
