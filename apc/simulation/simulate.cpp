#include "apc/simulation/simulate.h"

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/simulation/prepared.h"
#include "apc/simulation/roll_in.h"

namespace apc::simulation {

const char* text(Outcome outcome) {
  switch (outcome) {
    case Outcome::stopped:
      return "stopped";
    case Outcome::left_bed:
      return "left_bed";
    case Outcome::gear_limit:
      return "gear_limit";
    case Outcome::pitched_over:
      return "pitched_over";
  }
  return "?";
}

namespace {

void fill_energy(const Plant& plant, const std::vector<double>& start, const Ending& end, Result& result) {
  const auto before = stores(plant, start.data()), after = stores(plant, end.state.data());
  double lost = 0.0;
  for (std::size_t i = 0; i < sinks; ++i) {
    result.energy[std::string(sink_names[i])] = end.dissipated[i];
    lost += end.dissipated[i];
  }
  result.energy["kinetic"] = before.kinetic;
  result.energy["kinetic_left"] = after.kinetic;
  result.energy["potential"] = after.potential - before.potential;
  result.energy["oleo_gas"] = after.oleo_gas - before.oleo_gas;
  result.energy["stops"] = after.stops - before.stops;
  result.energy["residual"] = std::abs(before.sum() - after.sum() - lost) / before.kinetic;
}

/// An account that does not close is no result: either a law is not the derivative of its store, or steps were too
/// long.
void judge_energy(const Ending& end, double rtol, Result& result) {
  constexpr double noticeable = 1e-4, useless = 1e-2;
  const double residual = result.energy.at("residual");
  if (residual <= noticeable) return;
  if (!(residual <= useless))
    throw SolveError(concat("the energy account is open by ", residual, " of the motion at entry after ", end.time,
                            " s (at most ", useless, " passes for a result), at ", result.exit_speed, " m/s, ",
                            result.message, ". Try a tighter --rtol than ", rtol, ", or the reference method"),
                     end.time);
  result.warnings.push_back(
      concat("the energy account is open by ", residual, " of the motion at entry: try a tighter --rtol than ", rtol));
}

void fill_ending(const Plant& plant, const Ending& end, Result& result) {
  const double distance = nose_distance(plant, end.state.data());
  result.stop_time = end.time;
  double length = distance;
  if (end.end != End::rest) {
    result.stop_distance = result.runway_distance = std::numeric_limits<double>::quiet_NaN();
    result.exit_speed = cg_speed(plant, end.state.data());
  }
  if (end.end == End::pitched_over) {
    result.outcome = Outcome::pitched_over;
    result.message =
        fmt::format("pitched over: nose {} by {:.0f} deg {:.1f} m ({:.0f} ft) into the bed, at {:.1f} m/s ({:.0f} kt)",
                    end.state[2] < 0.0 ? "down" : "up", std::abs(end.state[2]) / units::deg, distance,
                    distance / units::ft, result.exit_speed, result.exit_speed / units::kt);
  } else if (end.end == End::far_end) {
    result.outcome = Outcome::left_bed;
    result.message =
        fmt::format("left the bed's far end, {:.1f} m ({:.0f} ft) from its leading edge, at {:.1f} m/s ({:.0f} kt)",
                    distance, distance / units::ft, result.exit_speed, result.exit_speed / units::kt);
  } else {
    const double speed = cg_speed(plant, end.state.data());
    const auto rest = end.unfaded > 0.0 ? Rest{0.5 * speed * speed / end.unfaded, speed / end.unfaded}
                                        : come_to_rest(-end.acceleration);
    length = result.stop_distance = distance + rest.distance;
    result.runway_distance = result.stop_distance + plant.setback;
    result.stop_time += rest.time;
    result.message = fmt::format("stopped {:.1f} m ({:.0f} ft) into the bed", result.stop_distance,
                                 result.stop_distance / units::ft);
  }
  result.mean_deceleration =
      (plant.entry_speed * plant.entry_speed - result.exit_speed * result.exit_speed) / (2.0 * std::max(length, 1e-9));
}

/// The last history row, at rest.
void close_history(const Plant& plant, const Ending& end, Observer& observer) {
  Surroundings around = surroundings_at_entry(plant);
  std::vector<double> rate(end.state.size());
  for (std::size_t r = 0; r < plant.rows.size(); ++r)
    around.in_bed[r] = row_motion(plant, static_cast<int>(r), end.state.data())[0] >= 0.0;
  Moment moment;
  derivatives(plant, around, end.time, end.state.data(), rate.data(), &moment);
  double lost = 0.0;
  for (const double each : end.dissipated) lost += each;
  observer.record(end.time, end.state.data(), moment, lost);
}

Result run(const Model& model, const Overrun& overrun, const Options& options) {
  Prepared prepared(model, overrun, options);
  const auto& plant = prepared.plant;
  const auto end =
      options.method == Method::fast
          ? run_fast(plant, prepared.start.state, fast_tolerance(plant) * options.rtol, options.time_limit,
                     prepared.observer)
          : run_reference(plant, prepared.start.state, options.rtol, options.time_limit, prepared.observer);
  return finish(model, overrun, options, prepared, end);
}

void check(const Options& options) {
  require(options.rtol > 0.0 && options.rtol <= loosest_rtol, "the relative tolerance must lie between 0 and ",
          loosest_rtol, ", not ", options.rtol);
  require(options.sampling >= 0.0, "the sampling interval must not be negative, but is ", options.sampling, " s");
}

/// Observation grid: at most 2 ms; where only extremes are wanted quickly, the solver's steps and their middles.
int instants_per_row(const Options& options) {
  constexpr double finest = 0.002;
  return options.sampling > 0.0 ? std::max(1, static_cast<int>(std::ceil(options.sampling / finest - 1e-9))) : 0;
}
double observation_interval(const Options& options) {
  constexpr double finest = 0.002;
  if (options.sampling > 0.0) return options.sampling / instants_per_row(options);
  return options.method == Method::fast ? 0.0 : finest;
}

}  // namespace

/// The fast method reaches 1 mm with twelve times the reference's tolerance per step (at 20 m/s, see StepControl).
/// Bogies bounce in their ruts, and errors grow there before they die away: less with them, least where they climb a
/// raised bed's ramp.
double fast_tolerance(const Plant& plant) { return plant.bogies == 0 ? 12.0 : plant.base_falls ? 9.0 : 4.0; }

Prepared::Prepared(const Model& model, const Overrun& overrun, const Options& options)
    : plant(make_plant(model, overrun)),
      start(trim(plant, overrun.entry_speed)),
      observer(model, plant, observation_interval(options), instants_per_row(options)) {
  if (options.sampling > 0.0) record_roll_in(plant, start, options.sampling, observer);
}

Result finish(const Model& model, const Overrun& overrun, const Options& options, Prepared& prepared,
              const Ending& end) {
  const auto& plant = prepared.plant;
  const bool history = options.sampling > 0.0;
  Result result;
  result.entry_speed = overrun.entry_speed;
  result.mass = plant.mass;
  result.cg_behind_nose_gear =
      overrun.cg_behind_nose_gear > 0.0 ? overrun.cg_behind_nose_gear : model.aircraft.cg_behind_nose_gear;
  fill_ending(plant, end, result);
  fill_energy(plant, prepared.start.state, end, result);
  // What leads a run along a measured speed pushes it, and stands in no account.
  if (!overrun.alterations.guide) judge_energy(end, options.rtol, result);
  if (history) close_history(plant, end, prepared.observer);
  prepared.observer.finish(result);
  result.solver = end.statistics;
  result.solver.rtol = options.rtol;
  if (history && end.end == End::rest) {
    result.history.time.back() = result.stop_time;
    result.history.distance.back() = result.stop_distance;
    result.history.speed.back() = 0.0;
  }
  return result;
}

bool alters_site(const Overrun& overrun) {
  for (const auto& each : overrun.alterations.effects)
    if (each.effect.site) return true;
  return false;
}

Result simulate(const Model& model, const Overrun& overrun, const Options& options) {
  check(options);
  const auto began = std::chrono::steady_clock::now();
  Result result;
  if (alters_site(overrun)) {
    Model changed = model;
    effects::Site site{
        changed.aircraft, changed.bed, overrun.mass > 0.0 ? overrun.mass : model.aircraft.mass,
        overrun.cg_behind_nose_gear > 0.0 ? overrun.cg_behind_nose_gear : model.aircraft.cg_behind_nose_gear};
    effects::alter_site(overrun.alterations, site);
    Overrun windy = overrun;
    windy.headwind += site.headwind;
    result = run(changed, windy, options);
  } else {
    result = run(model, overrun, options);
  }
  result.solver.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return result;
}

}  // namespace apc::simulation
