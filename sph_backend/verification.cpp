#include "sph_backend/verification.h"

#include <limits>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "sph_backend/press_rig.h"
#include "sph_backend/tire_rig.h"

namespace apc::sph {
namespace {

using namespace units;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double lbf_per_in = lbf / in;

Verification verify_platen(double spacing, const StudyOptions& options) {
  PressCase c;
  c.foam = ideal_foam_50psi();
  c.width = c.length = 12.0 * in, c.depth = 24.0 * in, c.spacing = spacing;
  c.alpha = options.alpha, c.cfl = options.cfl, c.threads = options.threads;
  const PressResult r = press(c);
  Verification v;
  v.symmetry = "full", v.state = "done";
  v.quantities.push_back({"energy_rmse", "1", r.energy_rmse, 0.0378, 0.0073});
  v.quantities.push_back({"absorbed_energy", "J", r.work.back(), r.work_exact.back(), none});
  v.energy_residual = r.residual, v.viscous_share = r.viscous / r.work.back(), v.compaction = r.compaction;
  v.particles = r.particles, v.steps = r.steps, v.particle_steps_per_s = r.particle_steps_per_s, v.wall_s = r.wall_s;
  return v;
}

RollingCase published_case(double spacing, const StudyOptions& options) {
  RollingCase c;
  c.foam = ideal_foam_50psi();
  c.tire = {"H44.5x16.5-21", 44.5 * in, 16.5 * in,   21.0 * in, 214.0 * psi,
            44700.0 * lbf,   3.5 * in,  121e3 * lbf, 8.5 * in};
  c.bed_depth = 24.0 * in, c.penetration = 16.0 * in, c.speed = 1418.0 * in, c.spacing = spacing;
  c.alpha = options.alpha, c.cfl = options.cfl;
  c.load_tolerance = 0.01, c.spin_tolerance = 0.005;
  return c;
}

Verification verify_rolling(Study study, double spacing, const StudyOptions& options) {
  RollingCase c = published_case(spacing, options);
  const bool roller = study == Study::roller_2d;
  c.friction = options.friction >= 0.0 ? options.friction : roller ? 0.0 : 0.3;
  c.rigid_roller = roller;
  c.bed_half_width = roller ? 4.0 * spacing : 12.0 * in;
  const RollingResult r = roll(c, {.threads = options.threads,
                                   .progress = options.progress,
                                   .stop = options.stop,
                                   .checkpoint = {},
                                   .snapshots = {}});
  // The roller's loads are those of twice the slab, the tire's of the whole tire: per width, and the modelled half.
  const double share = roller ? 0.5 / c.bed_half_width : 0.5;
  Verification v;
  v.symmetry = roller ? "unit width" : "half", v.state = name_of(r.state);
  const std::string force = roller ? "N/m" : "N", energy = roller ? "J/m^2" : "J/m";
  const double drag = share * r.drag, vertical = share * r.vertical, internal = share * r.internal_energy_rate;
  if (roller) {
    v.quantities.push_back({"vertical", force, vertical, 845.0 * lbf_per_in, 875.0 * lbf_per_in});
    v.quantities.push_back({"drag", force, drag, 1117.0 * lbf_per_in, 1091.0 * lbf_per_in});
    v.quantities.push_back({"internal_energy_rate", energy, internal, none, none});
  } else {
    v.quantities.push_back({"vertical", force, vertical, 10400.0 * lbf, 10730.0 * lbf});
    v.quantities.push_back({"drag", force, drag, 10030.0 * lbf, 8144.0 * lbf});
    v.quantities.push_back({"internal_energy_rate", energy, internal, 7996.0 * lbf, 7591.0 * lbf});
  }
  v.energy_residual = r.residual, v.viscous_share = r.energy.viscosity / r.energy.input();
  v.spin_ratio = r.spin_ratio, v.rut_depth = r.rut_depth, v.compaction = r.compaction, v.partition = r.partition_mean;
  v.particles = r.particles, v.steps = r.steps, v.particle_steps_per_s = r.particle_steps_per_s, v.wall_s = r.wall_s;
  return v;
}

}  // namespace

Study study_of(const std::string& name) {
  for (const Study s : {Study::platen_1d, Study::roller_2d, Study::tire_3d})
    if (name == name_of(s)) return s;
  throw InputError(concat("case ", name, ": unknown. Choose platen_1d, roller_2d or tire_3d."));
}

const char* name_of(Study study) {
  return study == Study::platen_1d ? "platen_1d" : study == Study::roller_2d ? "roller_2d" : "tire_3d";
}

std::vector<double> published_sizes(Study study) {
  return study == Study::tire_3d ? std::vector{3.0 * in, 2.0 * in, 1.0 * in}
                                 : std::vector{4.0 * in, 2.0 * in, 1.0 * in};
}

Verification verify(Study study, double spacing, const StudyOptions& options) {
  require(spacing > 0.0 && spacing <= 6.0 * in, "particle size ", spacing / in, " in: must lie between 0 and 6 in.");
  Verification v =
      study == Study::platen_1d ? verify_platen(spacing, options) : verify_rolling(study, spacing, options);
  v.study = study, v.spacing = spacing;
  return v;
}

Convergence converge(Study study, const std::vector<double>& sizes, const StudyOptions& options) {
  require(sizes.size() >= 3, "a convergence study needs at least three sizes, got ", sizes.size(), ".");
  Convergence c;
  c.study = study, c.sizes = sizes;
  for (const double size : sizes) c.runs.push_back(verify(study, size, options));
  for (std::size_t q = 0; q < c.runs.front().quantities.size(); ++q) {
    QuantityConvergence qc;
    std::size_t finest = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      qc.values.push_back(c.runs[k].quantities[q].value);
      if (sizes[k] < sizes[finest]) finest = k;
    }
    qc.finest = c.runs[finest].quantities[q];
    qc.fit = fit_power(sizes, qc.values);
    if (sizes.size() == 3) qc.gci = grid_convergence(sizes, qc.values);
    c.quantities.push_back(qc);
  }
  return c;
}

}  // namespace apc::sph
