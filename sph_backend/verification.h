/// The published convergence study (M. Barsotti, Comparison of FEM and SPH for Modeling a Crushable Foam Aircraft
/// Arrestor Bed) as runs of this solver, each quantity beside the published converged value.
///
///   platen_1d  12 × 12 × 24 in specimen to 85 %, energy RMSE (table 2)
///   roller_2d  rigid roller 44.5 in, 16 in deep in 24 in, 1,418 in/s, plane strain; per unit of width (table 3)
///   tire_3d    H44.5x16.5-21, 16 in in 24 in, 12 in half-width with a symmetry plane outside, half model (table 4)
/// The study does not print friction, spin, entry and measuring window. Ours: roller frictionless and free, tire free
/// with the friction given; entry by pressing; mean of two windows of travel R each after settling. No constant is
/// tuned to the tables.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sph_backend/convergence.h"

namespace apc::sph {

enum class Study { platen_1d, roller_2d, tire_3d };
/// InputError for any other name, listing the three.
Study study_of(const std::string& name);
const char* name_of(Study);

struct StudyOptions {
  double friction = -1.0;  ///< negative: 0 for the roller, 0.3 for the tire
  double alpha = 0.1;
  double cfl = 0.25;
  unsigned threads = 1;
  std::function<void(double share, const std::string& remark)> progress;
  std::function<bool()> stop;
};

struct Quantity {
  std::string name, unit;
  double value = 0.0;
  double reference = 0.0;      ///< published converged SPH value; NaN when there is none
  double reference_fem = 0.0;  ///< published converged FEM value; NaN when there is none
  double difference() const { return value / reference - 1.0; }
};

struct Verification {
  Study study = Study::platen_1d;
  double spacing = 0.0;
  std::string symmetry;  ///< "half", "full", "unit width"
  std::string state;     ///< of the run: steady …
  std::vector<Quantity> quantities;
  double energy_residual = 0.0, viscous_share = 0.0, spin_ratio = 0.0, rut_depth = 0.0, compaction = 0.0,
         partition = 1.0;
  double particles = 0.0, steps = 0.0, particle_steps_per_s = 0.0, wall_s = 0.0;
};
Verification verify(Study, double spacing, const StudyOptions& = {});

/// One quantity over the sizes.
struct QuantityConvergence {
  Quantity finest;
  std::vector<double> values;
  PowerFit fit;
  GridConvergence gci;  ///< valid only for three sizes
};
struct Convergence {
  Study study = Study::platen_1d;
  std::vector<double> sizes;
  std::vector<Verification> runs;
  std::vector<QuantityConvergence> quantities;
};
/// Published sizes are 4, 2, 1 in (platen, roller) and 3, 2, 1 in (tire).
Convergence converge(Study, const std::vector<double>& sizes, const StudyOptions& = {});
std::vector<double> published_sizes(Study);

}  // namespace apc::sph
