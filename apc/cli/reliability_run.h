/// The reliability of a design, from files to a finished record: what `apc reliability` and the Python binding do.
#pragma once

#include <functional>

#include "apc/cli/of_design.h"
#include "apc/report/reliability_record.h"

namespace apc::cli {

struct ReliabilityAsk {
  OfDesign of;
  std::string scatter;  ///< apc-scatter/1 file; empty = estimates
  long samples = 1000;  ///< over all cases together
  long seed = 1;
  std::string command;  ///< for the manifest
  /// Told now and then: samples finished of all, and the case at work.
  std::function<void(double finished, double all, const std::string& name)> progress;
};

/// Finished samples are kept in the folder `of.out`, per case. Throws InputError, Interrupted.
report::ReliabilityRecord run_reliability(const ReliabilityAsk&);

}  // namespace apc::cli
