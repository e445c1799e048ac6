/// Texts and records of `apc sph verify|converge|bench`.
#pragma once

#include <string>
#include <vector>

#include "apc/cli/commands.h"
#include "sph_backend/verification.h"

namespace apc::cli {

void add_sph_studies(CLI::App& sph, Settings&);

/// Throughput on a number of threads.
struct BenchRow {
  unsigned threads = 1;
  double particles = 0.0, particle_steps = 0.0, particle_steps_per_s = 0.0, wall_s = 0.0;
};

/// One run, or particles and elements beside each other.
std::string verification_text(const std::vector<sph::Verification>&, report::UnitSystem);
std::string span_text(const std::vector<sph::SpanRow>&, report::UnitSystem);
/// One method, or both with a summary beside the paper's tables.
std::string convergence_text(const std::vector<sph::Convergence>&, report::UnitSystem);

/// The first method's record; a second one goes into its key "fem". `command` says how to make it again.
std::string verification_json(const std::vector<sph::Verification>&, const std::vector<sph::SpanRow>&,
                              const std::string& command);
std::string convergence_json(const std::vector<sph::Convergence>&, const std::string& command);
std::string bench_json(const std::vector<BenchRow>&);

}  // namespace apc::cli
