/// SHA-256 (FIPS 180-4), so that a report names its inputs by content; `sha256sum FILE` gives the same digits.
#pragma once

#include <string>
#include <string_view>

namespace apc::report {

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace apc::report
