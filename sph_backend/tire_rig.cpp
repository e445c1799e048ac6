#include "sph_backend/tire_rig.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "sph_backend/checkpoint_hdf5.h"
#include "sph_backend/rolling_history.h"
#include "sph_backend/rolling_run.h"
#include "sph_backend/rolling_step.h"
#include "sph_backend/snapshot_vtu.h"

namespace apc::sph {
namespace {

/// A reason to end the run early, or nothing.
bool failed(const RollingRun& run, RollingResult& result) {
  const double kinetic = run.bed.energy.kinetic, compaction = largest_compaction(run.bed);
  if (!std::isfinite(kinetic) || !std::isfinite(run.contact.force_z) || !(compaction <= 0.985)) {
    result.state = RunState::unstable;
    result.message = concat("unstable at ", run.bed.time, " s: compaction ", compaction, ", kinetic energy ", kinetic,
                            " J. Try a smaller cfl or a finer spacing.");
    return true;
  }
  // A transient may pass the limit; nothing can be measured on a tire that has bottomed.
  if (run.tire.rigid || run.history.vertical.empty() ||
      run.history.deflection.back() < run.setup.tire.bottoming_deflection)
    return false;
  result.state = RunState::tire_overloaded;
  result.message = concat("tire bottomed: deflection ", run.history.deflection.back() / units::in, " in, load ",
                          run.history.vertical.back() / units::lbf, " lbf at ", run.history.distance.back() / units::in,
                          " in of travel");
  return true;
}

void finish(const RollingRun& run, RollingResult& result) {
  sum_up(run, result);
  result.rut_left = run.setup.bed_depth - surface_behind(run);
  const GasState gas = gas_state(run.tire);
  result.gas_pressure = gas.pressure, result.gas_volume_change = gas.volume_change;
  const BedState state = inspect(run.bed);
  result.compaction = state.compaction;
  result.partition_min = state.partition_min, result.partition_mean = state.partition_mean;
  result.bytes_per_particle = state.bytes_per_particle;
  result.particles = run.bed.alive, result.steps = static_cast<double>(run.bed.steps);
  result.particle_steps = static_cast<double>(run.bed.particle_steps);
  result.history = run.history;
  result.shape = shape_behind(run);
  const Particles& p = run.bed.particles;
  const Slice slice = settled_slice(run);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.id[i] < 0 || p.x[i] < slice.from || p.x[i] >= 0.5 * (slice.from + slice.to)) continue;
    const double s = p.stretch[i];
    result.section_y.push_back(p.y[i]), result.section_z.push_back(p.z[i]);
    result.section_compaction.push_back(1.0 - 1.0 / (s * s * s));
  }
}

}  // namespace

const char* name_of(RunState state) {
  switch (state) {
    case RunState::steady:
      return "steady";
    case RunState::did_not_settle:
      return "did_not_settle";
    case RunState::tire_overloaded:
      return "tire_overloaded";
    default:
      return "unstable";
  }
}

double recommended_spacing(const TireShape& tire, double bed_depth) {
  const double narrow = 5.0 * units::in, wide = 16.0 * units::in;
  const double share = std::clamp((tire.width - narrow) / (wide - narrow), 0.0, 1.0);
  return std::min(tire.width / (6.0 + 2.0 * share), bed_depth / 5.0);
}

RollingCase completed(const RollingCase& given) {
  RollingCase c = given;
  using units::in;
  const double radius = 0.5 * c.tire.diameter;
  require(c.speed > 0.0, "speed ", c.speed, " m/s: a rolling run needs a positive speed.");
  require(c.spacing > 0.0, "spacing ", c.spacing / in, " in: must be positive.");
  require(c.bed_depth >= 4.0 * c.spacing * 0.999, "bed depth ", c.bed_depth / in, " in is less than four particles of ",
          c.spacing / in, " in. Choose a spacing of at most ", c.bed_depth / (4 * in), " in.");
  require(c.penetration > 0.0, "penetration ", c.penetration / in, " in: must be positive.");
  require(c.penetration <= c.tire.diameter, "penetration ", c.penetration / in, " in exceeds the tire's diameter ",
          c.tire.diameter / in, " in.");
  require(std::abs(c.fall) <= 0.1, "fall ", c.fall, ": a wheel sinks or rises by at most 0.1 per length of way.");
  const auto fill = [](double& value, double otherwise) {
    if (value <= 0.0) value = otherwise;
  };
  const double touch =
      c.penetration < radius ? std::sqrt(radius * radius - std::pow(radius - c.penetration, 2)) : radius;
  fill(c.bed_half_width, (0.5 + c.bed_margin) * c.tire.width);
  fill(c.ahead, touch + std::max(0.35 * radius, 5.0 * c.spacing));
  fill(c.behind, std::max(radius, 8.0 * c.spacing));
  fill(c.press_speed, std::clamp(0.6 * c.speed, 4.0, 15.0));
  fill(c.accelerate_distance, 0.5 * radius);
  fill(c.window, radius);
  fill(c.longest, 10.0 * radius);
  return c;
}

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Files that a run leaves on its way.
class Recorder {
 public:
  Recorder(const RollOptions& options, const RollingRun& run)
      : options_(options),
        series_(options.snapshots),
        distance_(options.snapshot_distance > 0.0 ? options.snapshot_distance : 0.5 * run.radius()) {}

  void snapshot(const RollingRun& run) {
    if (options_.snapshots.empty() || travel(run, run.bed.time) < next_) return;
    series_.write(run);
    next_ = travel(run, run.bed.time) + distance_;
  }

  /// The run goes on from a checkpoint: so does the series.
  void resume(const RollingRun& run) {
    if (options_.snapshots.empty()) return;
    const double last = series_.resume(run.bed.time);
    if (last >= 0.0) next_ = travel(run, last) + distance_;
  }

  void checkpoint(const RollingRun& run, bool now) {
    if (options_.checkpoint.empty() || (!now && seconds_since(saved_) < options_.checkpoint_every_s)) return;
    save_checkpoint(run, options_.checkpoint);
    saved_ = Clock::now();
  }

 private:
  /// Way of the axle; while pressing, the way down.
  static double travel(const RollingRun& run, double time) {
    const AxleState axle = run.path.at(time);
    return axle.x + run.path.start_height - axle.z;
  }

  const RollOptions& options_;
  SnapshotSeries series_;
  double distance_, next_ = 0.0;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace

RollingResult roll(const RollingCase& given, const RollOptions& options) {
  const auto begin = Clock::now();
  RollingRun run = start_run(completed(given), options.threads);
  const bool resumed = !options.checkpoint.empty() && std::filesystem::exists(options.checkpoint);
  if (resumed) load_checkpoint(run, options.checkpoint);
  const RollingCase& setup = run.setup;
  RollingResult result;
  result.state = RunState::did_not_settle;
  const double end = setup.transient() + setup.longest;
  std::size_t judged = run.history.drag.size();
  Recorder recorder(options, run);
  if (resumed) recorder.resume(run);
  while (true) {
    step(run);
    recorder.snapshot(run);
    if (judge(setup, run.history, run.internal, judged, result)) break;
    if (run.bed.steps % 50 != 0) continue;
    if (failed(run, result)) break;
    const AxleState axle = run.path.at(run.bed.time);
    if (axle.x > end) break;
    const bool stop = options.stop && options.stop();
    recorder.checkpoint(run, stop);
    if (stop) throw Interrupted();
    if (options.progress)
      options.progress(0.3 * std::min(1.0, run.bed.time / run.path.press_time) + 0.7 * axle.x / end,
                       axle.x <= 0.0 ? "pressing" : "rolling");
  }
  if (!options.checkpoint.empty()) std::filesystem::remove(options.checkpoint);
  finish(run, result);
  conclude(run.setup, result);
  result.wall_s = seconds_since(begin);
  result.particle_steps_per_s = result.particle_steps / result.wall_s;
  return result;
}

}  // namespace apc::sph
