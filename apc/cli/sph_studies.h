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

std::string verification_text(const sph::Verification&, report::UnitSystem);
std::string convergence_text(const sph::Convergence&, report::UnitSystem);
std::string verification_json(const sph::Verification&);
std::string convergence_json(const sph::Convergence&);
std::string bench_json(const std::vector<BenchRow>&);

}  // namespace apc::cli
