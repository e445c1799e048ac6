/// A finished reliability study with everything its reports need.
#pragma once

#include "apc/reliability/reliability.h"
#include "apc/report/record.h"
#include "apc/report/unit_system.h"

namespace apc::report {

struct ReliabilityRecord {
  std::string design;  ///< name of the bed
  std::vector<std::string> cases;
  std::vector<double> asked_speeds;  ///< m/s, per case
  std::vector<reliability::Reliability> results;
  reliability::Scatter scatter;
  reliability::ExitSpeeds exit_speeds;
  std::string criterion;
  double seconds = 0.0;
  Manifest manifest;
};

std::string reliability_json(const ReliabilityRecord&);
std::string reliability_brief(const ReliabilityRecord&, UnitSystem);
std::string reliability_page(const ReliabilityRecord&);

}  // namespace apc::report
