/// The tables of an overrun's page.
#pragma once

#include <string>

#include "apc/report/record.h"

namespace apc::report {

std::string headline_cards(const OverrunRecord&);
std::string gear_table(const OverrunRecord&);
std::string energy_table(const OverrunRecord&);
std::string coverage_table(const OverrunRecord&);
std::string inputs_table(const OverrunRecord&);
std::string manifest_table(const OverrunRecord&);

}  // namespace apc::report
