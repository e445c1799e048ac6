#include "sph_backend/fem/fem_rig.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "sph_backend/fem/mesh_block.h"
#include "sph_backend/rolling_run.h"
#include "sph_backend/rolling_step.h"

namespace apc::sph::fem {
namespace {

/// A type of this file, so that its follow() is found.
struct FemRun : RollingRunOf<Mesh> {};

void follow(FemRun& run, const AxleState& axle) {
  const Columns c = window_columns(run.setup, axle.x);
  if (c.end > run.bed.spec.first_column + run.bed.active_end ||
      c.first > run.bed.spec.first_column + run.bed.active_first)
    set_active(run.bed, c.first, c.end);
}

FemRun start(const RollingCase& setup, const Elements& elements) {
  FemRun run;
  start_tire(run, setup);
  MeshSpec spec;
  spec.foam = setup.foam, spec.size = setup.spacing, spec.depth = setup.bed_depth;
  spec.half_width = setup.bed_half_width, spec.outer_wall = setup.outer_wall, spec.hold_bottom = setup.hold_bottom;
  spec.integration = elements.integration, spec.hourglass = elements.hourglass;
  spec.hourglass_factor = elements.hourglass_factor, spec.cfl = elements.cfl;
  const Columns first = window_columns(setup, 0.0);
  const Columns last = window_columns(setup, setup.transient() + setup.longest + setup.spacing);
  spec.first_column = first.first, spec.columns = last.end + 1 - first.first;
  run.bed = make_mesh(spec);
  set_active(run.bed, first.first, first.end);
  return run;
}

bool failed(const FemRun& run, RollingResult& result) {
  if (run.bed.inverted > 0 || !std::isfinite(run.bed.energy.kinetic)) {
    result.state = RunState::unstable;
    result.message = concat(run.bed.inverted, " elements turned inside out at ", run.bed.time, " s, after ",
                            run.path.at(run.bed.time).x / units::in, " in of travel");
    return true;
  }
  if (run.tire.rigid || run.history.vertical.empty() ||
      run.history.deflection.back() < run.setup.tire.bottoming_deflection)
    return false;
  result.state = RunState::tire_overloaded;
  result.message = concat("tire bottomed: deflection ", run.history.deflection.back() / units::in, " in");
  return true;
}

/// Elements of one slice behind the tire: centres and compaction.
void cut_section(const FemRun& run, RollingResult& result) {
  const Mesh& m = run.bed;
  const double at = run.path.at(m.time).x - 0.55 * 0.5 * run.setup.tire.diameter;
  const int points = m.points();
  for (int ix = m.active_first; ix < m.active_end; ++ix)
    for (int iy = 0; iy < m.ny; ++iy)
      for (int iz = 0; iz < m.nz; ++iz) {
        double centre[3] = {};
        for (const std::size_t n : corner_nodes(m, ix, iy, iz))
          for (int a = 0; a < 3; ++a) centre[a] += m.x[a][n] / corners;
        if (std::abs(centre[0] - at) > run.setup.spacing) continue;
        double volume = 0.0, volume0 = 0.0;
        for (int p = 0; p < points; ++p) {
          volume += m.volume[points * m.element(ix, iy, iz) + p];
          volume0 += m.volume0[points * m.element(ix, iy, iz) + p];
        }
        result.section_y.push_back(centre[1]), result.section_z.push_back(centre[2]);
        result.section_compaction.push_back(1.0 - volume / volume0);
      }
}

void finish(const FemRun& run, RollingResult& result) {
  sum_up(run, result);
  result.compaction = largest_compaction(run.bed);
  result.particles = static_cast<double>(run.bed.active_end - run.bed.active_first) * run.bed.ny * run.bed.nz;
  result.steps = static_cast<double>(run.bed.steps);
  result.particle_steps = static_cast<double>(run.bed.element_steps);
  result.history = run.history;
  cut_section(run, result);
}

}  // namespace

RollingResult roll(const RollingCase& given, const Elements& elements, const RollOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  RollingCase wider = given;
  // The sheet behind the wheel springs back for a while; held too early, it would push against the tire.
  if (wider.behind <= 0.0) wider.behind = 1.05 * wider.tire.diameter;
  FemRun run = start(completed(wider), elements);
  const RollingCase& setup = run.setup;
  RollingResult result;
  result.state = RunState::did_not_settle;
  const double end = setup.transient() + setup.longest;
  std::size_t judged = 0;
  while (true) {
    step_tire_and_foam(run);
    if (failed(run, result) || judge(setup, run.history, run.internal, judged, result)) break;
    if (run.bed.steps % 50 != 0) continue;
    const double x = run.path.at(run.bed.time).x;
    if (x > end) break;
    if (options.stop && options.stop()) throw Interrupted();
    if (options.progress)
      options.progress(0.3 * std::min(1.0, run.bed.time / run.path.press_time) + 0.7 * x / end,
                       x <= 0.0 ? "pressing" : "rolling");
  }
  finish(run, result);
  conclude(setup, result);
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.particle_steps_per_s = result.particle_steps / result.wall_s;
  return result;
}

}  // namespace apc::sph::fem
