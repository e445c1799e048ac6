/// Numbers in the learning's files: five digits, and a unit where there is one.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace apc::learning {

std::string short_number(double value);

/// `value` (SI) as a number, or as a text in `unit` where that is not empty: 0.36, "12 m".
nlohmann::ordered_json quantity(double value, const std::string& unit);

}  // namespace apc::learning
