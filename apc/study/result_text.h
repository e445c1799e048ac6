/// A Result as one line of text and back, bit for bit (hexadecimal floating point); the history is left out.
#pragma once

#include <string>
#include <vector>

#include "apc/simulation/result.h"

namespace apc::study {

std::string to_text(const simulation::Result&);
/// InputError when the text was not made by `to_text` of this version.
simulation::Result result_from(const std::string& text);

/// Numbers as text and back, bit for bit.
std::string to_text(const std::vector<double>&);
std::vector<double> numbers_from(const std::string& text);

}  // namespace apc::study
