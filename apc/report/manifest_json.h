/// What every JSON record of ours has in common: how a number that may be missing is written, and where the record
/// comes from.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "apc/report/record.h"

namespace apc::report {

/// JSON knows neither infinity nor NaN: null stands for "there is none".
nlohmann::ordered_json number_or_null(double);

/// {program, command, files: [{role, path, sha256, source}]}.
nlohmann::ordered_json provenance(const Manifest&);

}  // namespace apc::report
