/// The published convergence study (published_study.h) as runs of this solver, by particles or by finite elements, each
/// quantity beside the published converged value.
///
///   platen_1d  12 × 12 × 24 in specimen to 85 %, energy RMSE (table 2)
///   roller_2d  rigid roller 44.5 in, 16 in deep in 24 in, 1,418 in/s, plane strain; per unit of width (table 3)
///   tire_3d    H44.5x16.5-21, 16 in in 24 in, 12 in half-width with a symmetry plane outside, half model (table 4)
///   punch_2d   the rut's wall alone: a rigid face of 8.25 in half-width, 16 in deep in 24 in, plane strain, 24 in
///              half-width, 100 in/s; work over that of crushing its own column (mentioned, not printed, in the study)
///   deck       any rolling run, for its own discretisation error
/// The study does not print friction, spin, entry and measuring window. Ours: roller frictionless and free, tire free
/// with friction 0.3; entry by pressing at rest; mean of two windows of travel R each after settling. `span` varies
/// them. No constant is tuned to the tables.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sph_backend/convergence.h"
#include "sph_backend/energy.h"
#include "sph_backend/fem/fem_press.h"
#include "sph_backend/pair_kernels.h"
#include "sph_backend/published_study.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {

/// InputError for any other name than the four published cases.
Study study_of(const std::string& name);
const char* name_of(Study);
const char* name_of(Method);

struct StudyOptions {
  Method method = Method::sph;
  RollingCase deck;        ///< of Study::deck; its spacing is replaced, the settling tolerances tightened
  fem::Elements elements;  ///< of Method::fem
  double friction = -1.0;  ///< negative: 0 for the roller, 0.3 for the tire
  WheelSpin spin = WheelSpin::free;
  double entry = 0.0;            ///< m; 0 = pressed, else rolled in along this way
  bool outer_wall = true;        ///< of the tire's bed
  bool hold_bottom = true;       ///< of tire and roller
  double tension_cutoff = -1.0;  ///< Pa; negative: 10 psi (the study gives 1 to 50)
  PairForm form = PairForm::mass;
  double alpha = 0.1;
  double cfl = 0.25;
  unsigned threads = 1;
  std::filesystem::path checkpoint;  ///< folder for the checkpoints of particle runs; empty = none
  std::function<void(double share, const std::string& remark)> progress;
  std::function<bool()> stop;
};

struct Quantity {
  std::string name, unit;
  double value = 0.0;
  double reference = 0.0;      ///< published converged value of the same method; NaN when there is none
  double reference_fem = 0.0;  ///< published converged FEM value; NaN when there is none
  double difference() const { return value / reference - 1.0; }
};

struct Verification {
  Study study = Study::platen_1d;
  Method method = Method::sph;
  double spacing = 0.0;
  std::string symmetry;                  ///< "half", "full", "unit width"
  std::string state;                     ///< of the run: steady …
  std::string message;                   ///< why it is not
  std::vector<std::string> assumptions;  ///< what the study does not print, as chosen here
  std::vector<Quantity> quantities;
  std::vector<EnergyTerm> energy;  ///< shares of the work put in
  double energy_residual = 0.0, viscous_share = 0.0, spin_ratio = 0.0, rut_depth = 0.0, compaction = 0.0,
         partition = 1.0;
  double hourglass_share = 0.0;  ///< of the internal energy
  double particles = 0.0, steps = 0.0, particle_steps_per_s = 0.0, wall_s = 0.0;
  double bytes_per_particle = 0.0;  ///< zero when not counted
  double travel = 0.0;              ///< m
  RutShape shape;                   ///< of rolling particle runs; all zero otherwise
};
Verification verify(Study, double spacing, const StudyOptions& = {});

/// One variation of what the study leaves unsaid, and what it moves.
struct SpanRow {
  std::string what;
  Verification run;
};
/// The first row is the case itself.
std::vector<SpanRow> span(Study, double spacing, const StudyOptions& = {});

/// One quantity over the sizes.
struct QuantityConvergence {
  Quantity finest;
  std::vector<double> values;
  PowerFit fit;
  GridConvergence gci;         ///< of the published sizes if they are there, else of the finest three
  std::vector<double> errors;  ///< |φ(h) − φ_ext|/|φ_ext| at each size; empty without a fit
  Published paper;             ///< of the same method
};
struct Convergence {
  Study study = Study::platen_1d;
  Method method = Method::sph;
  std::vector<double> sizes;
  std::vector<Verification> runs;
  std::vector<QuantityConvergence> quantities;
};
/// Published sizes are 4, 2, 1 in (platen, roller, punch) and 3, 2, 1 in (tire).
Convergence converge(Study, const std::vector<double>& sizes, const StudyOptions& = {});
std::vector<double> published_sizes(Study);

}  // namespace apc::sph
