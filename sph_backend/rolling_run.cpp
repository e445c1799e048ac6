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

Slice settled_slice(const RollingRun& run) {
  const BedSpec& spec = run.bed.spec;
  const double rear = (spec.first_column + spec.held_columns) * spec.spacing;
  return {rear, rear + 2.0 * spec.spacing};
}

RutShape shape_behind(const RollingRun& run) {
  const Bed& bed = run.bed;
  const Particles& p = bed.particles;
  const AxleState axle = run.path.at(bed.time);
  const Slice slice = settled_slice(run);
  const double dx = run.setup.spacing, way = 0.25 * run.setup.tire.width;
  const double front = (bed.spec.first_column + bed.spec.columns) * dx;
  std::vector<Grain> across, ahead;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0) continue;
    const double s = std::max(1.0f, p.stretch[i]), half = 0.5 * bed.layer / (s * s * s);
    if (p.x[i] >= slice.from && p.x[i] < slice.to) across.push_back({p.y[i], p.z[i] - half, p.z[i] + half});
    if (p.x[i] > axle.x && p.y[i] < way) ahead.push_back({p.x[i], p.z[i] - half, p.z[i] + half});
  }
  RutShape shape = rut_shape(surface_of(std::move(across), 0.0, bed.half_width, dx), {run.tire.outline, axle.z},
                             run.setup.bed_depth, run.setup.penetration);
  shape.behind = axle.x - 0.5 * (slice.from + slice.to);
  shape.bow_wave = -run.setup.bed_depth;
  for (const double height : surface_of(std::move(ahead), axle.x, front, dx).height)
    shape.bow_wave = std::max(shape.bow_wave, height - run.setup.bed_depth);
  return shape;
}

}  // namespace apc::sph
