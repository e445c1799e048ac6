/// The full record of one overrun as JSON, SI numbers; the keys are a contract with other programs.
#pragma once

#include <string>

#include "apc/report/record.h"

namespace apc::report {

std::string result_json(const OverrunRecord&);

}  // namespace apc::report
