/// Texts and records of `apc sph verify|converge|bench`.
#pragma once

#include <string>
#include <vector>

#include "apc/cli/commands.h"
#include "sph_backend/throughput.h"
#include "sph_backend/verification.h"

namespace apc::cli {

void add_sph_studies(CLI::App& sph, Settings&);

/// One run, or particles and elements beside each other.
std::string verification_text(const std::vector<sph::Verification>&, report::UnitSystem);
std::string span_text(const std::vector<sph::SpanRow>&, report::UnitSystem);
/// One method, or both with a summary beside the paper's tables.
std::string convergence_text(const std::vector<sph::Convergence>&, report::UnitSystem);

/// The first method's record; a second one goes into its key "fem". `command` says how to make it again.
std::string verification_json(const std::vector<sph::Verification>&, const std::vector<sph::SpanRow>&,
                              const std::string& command);
std::string convergence_json(const std::vector<sph::Convergence>&, const std::string& command);
std::string bench_text(const sph::Throughput&);
std::string bench_json(const sph::Throughput&, const std::string& command);

}  // namespace apc::cli
