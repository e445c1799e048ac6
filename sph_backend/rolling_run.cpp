#include "sph_backend/rolling_run.h"

#include <algorithm>
#include <cmath>

#include "sph_backend/particle_block.h"
#include "sph_backend/rolling_step.h"

namespace apc::sph {
namespace {

constexpr int held_columns = BedSpec{}.held_columns;

}  // namespace

void follow(RollingRun& run, const AxleState& axle) {
  Bed& bed = run.bed;
  const Columns c = window_columns(run.setup, axle.x);
  const int first = c.first - held_columns, end = c.end + held_columns;
  if (end > bed.spec.first_column + bed.spec.columns || first > bed.spec.first_column) move_window(bed, first, end);
}

Columns window_columns(const RollingCase& c, double axle_x) {
  const double press_behind = -c.ahead, roll_behind = axle_x - c.behind;
  return {
      static_cast<int>(std::floor((axle_x <= 0.0 ? press_behind : std::max(press_behind, roll_behind)) / c.spacing)),
      static_cast<int>(std::ceil((axle_x + c.ahead) / c.spacing))};
}

RollingRun start_run(const RollingCase& setup, unsigned threads) {
  RollingRun run;
  start_tire(run, setup, threads);
  BedSpec bed;
  bed.foam = setup.foam;
  bed.spacing = setup.spacing, bed.depth = setup.bed_depth, bed.half_width = setup.bed_half_width;
  bed.outer_wall = setup.outer_wall, bed.hold_bottom = setup.hold_bottom;
  bed.alpha = setup.alpha, bed.beta = setup.beta, bed.cfl = setup.cfl, bed.form = setup.form;
  bed.speed = std::max(setup.speed, setup.press_speed), bed.threads = threads;
  const Columns columns = window_columns(setup, 0.0);
  bed.first_column = columns.first - held_columns;
  bed.columns = columns.end - columns.first + 2 * held_columns;
  run.bed = make_bed(bed);
  shorten_step(run.bed, longest_step(contact_points(run.bed), run.tire, run.law));
  return run;
}

void step(RollingRun& run) { step_tire_and_foam(run); }

double surface_behind(const RollingRun& run) {
  // Highest crushed particle on the centreline in a slice that the tire has left; loose fragments lie above it.
  const Particles& p = run.bed.particles;
  const double dx = run.setup.spacing, at = run.path.at(run.bed.time).x - 0.55 * run.radius();
  double top = -1.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0 || std::abs(p.x[i] - at) > dx || p.y[i] > 0.25 * run.setup.tire.width) continue;
    const double s = p.stretch[i], ratio = 1.0 / (s * s * s);
    if (ratio < 0.7) top = std::max(top, p.z[i] + 0.5 * run.bed.layer * ratio);
  }
  return top < 0.0 ? run.setup.bed_depth : top;
}

}  // namespace apc::sph
