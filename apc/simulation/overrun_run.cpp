#include "apc/simulation/overrun_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "apc/simulation/course.h"
#include "apc/simulation/cvode.h"
#include "apc/simulation/elementary.h"
#include "apc/simulation/rosenbrock.h"

namespace apc::simulation {

bool enters_with_a_jump(const Plant& plant, int row) {
  const auto& group = plant.groups[static_cast<std::size_t>(plant.rows[static_cast<std::size_t>(row)].group)];
  return plant.profile.steps_in() || group.braking != group.braking_in_bed;
}

Surroundings surroundings_at_entry(const Plant& plant) {
  Surroundings around;
  around.ruts.resize(plant.rows.size());
  for (std::size_t r = 0; r < plant.rows.size(); ++r)
    around.in_bed[r] = r == 0 || !enters_with_a_jump(plant, static_cast<int>(r));
  return around;
}

void write_ruts(const Plant& plant, Surroundings& around, const Moment& moment) {
  for (const auto& row : plant.rows) {
    if (row.ahead < 0) continue;
    const auto r = static_cast<std::size_t>(row.ahead);
    const auto& made = moment.rows[r];
    if (!around.in_bed[r] || made.distance < -1.0) continue;
    Rut rut;
    if (made.penetration > 0.0) {
      const auto& ground = made.ground;
      rut = {ground.load.rut_depth, ground.virgin_penetration, ground.virgin_drag, ground.virgin_vertical};
    }
    auto& log = around.ruts[r];
    log.write(made.distance, rut);
    for (const double corner : plant.groups[static_cast<std::size_t>(plant.rows[r].group)].corners)
      if (std::abs(log.last_distance() - corner) <= at_corner) log.turn();
  }
}

void write_ruts(const Plant& plant, Surroundings& around, double t, const double* y) {
  std::array<double, most_states> rate;
  Moment moment;
  derivatives(plant, around, t, y, rate.data(), &moment);
  write_ruts(plant, around, moment);
}

double time_to_corner(const Plant& plant, const Moment& moment) {
  double soonest = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < plant.rows.size(); ++r) {
    const auto& row = moment.rows[r];
    const double speed = row.velocity.x;
    if (!(speed > 0.0)) continue;
    for (const double corner : plant.groups[static_cast<std::size_t>(plant.rows[r].group)].corners) {
      const double way = corner - row.distance;
      if (way <= at_corner) continue;
      const double rough = way / speed, mean = speed + 0.5 * moment.cg_acceleration.x * rough;
      if (mean > 0.5 * speed) soonest = std::min(soonest, way / mean);
      break;
    }
  }
  return soonest;
}

double longest_way(const Plant& plant) {
  double reach = 2.0;
  for (const auto& row : plant.rows)
    if (row.ahead >= 0)
      reach = std::min(
          {reach, 1.96 * rut_spacing, 0.7 * (plant.rows[static_cast<std::size_t>(row.ahead)].offset - row.offset)});
  if (!plant.alterations) return reach;
  for (const auto& each : plant.alterations->effects) {  // narrow places (joints) must not be stepped over
    if (each.values.empty() || each.values.front() == each.effect.parameters.front().neutral) continue;
    for (std::size_t k = 1; k < each.values.size(); ++k)
      if (each.effect.parameters[k].name == "width") reach = std::min(reach, 0.8 * each.values[k]);
  }
  return reach;
}

bool has_narrow_pieces(const Plant& plant) { return plant.profile.shortest_piece() < longest_way(plant); }

/// The factors undo what fading did before: ∫₁^∞ x (coth x − 1) dx = 0.215520, ∫₁^∞ (coth x − 1) dx = 0.145413.
Rest come_to_rest(double deceleration) {
  const double unfaded = deceleration / std::tanh(1.0);
  if (!(unfaded > 0.0)) return {};
  return {(0.5 - 0.2155197) * creep_speed * creep_speed / unfaded, (1.0 - 0.1454135) * creep_speed / unfaded};
}

std::vector<double> absolute_tolerances(const Plant& plant, double rtol) {
  const double scale = rtol / 1e-6;
  const int n = plant.degrees(), groups = static_cast<int>(plant.groups.size());
  std::vector<double> absolute;
  for (int i = 0; i < plant.states(); ++i) {
    const int k = i < n ? i : i - n;
    const bool angle = i < 2 * n && (k == 2 || k >= 3 + groups);
    absolute.push_back(scale * (i >= 2 * n || i == 0 ? 1e-5 : angle ? 1e-7 : 1e-6));
  }
  return absolute;
}

std::string in_words(const Plant& plant, const double* y) {
  auto words = fmt::format("speed {:.2f} m/s, nose wheel {:.2f} m into the bed, pitch {:.2f} deg, strokes",
                           cg_speed(plant, y), nose_distance(plant, y), y[2] / units::deg);
  for (std::size_t g = 0; g < plant.groups.size(); ++g)
    words += fmt::format("{} {} {:.3f} m of {:.3f}", g == 0 ? "" : ",", plant.groups[g].name, y[3 + g],
                         plant.groups[g].strut.stroke);
  return words;
}

double cg_speed(const Plant& plant, const double* y) {
  const double* rate = y + plant.degrees();
  const auto turn = elementary::sine_cosine(y[2]);
  return rate[0] - rate[2] * (plant.cg.x * turn.sine + plant.cg.z * turn.cosine);
}

double held_up_by_fading(const Plant& plant, const Surroundings& around, double time, const double* y,
                         const Moment& moment) {
  constexpr double unfaded_speed = 5.0 * creep_speed, standstill = 0.01;  // m/s; m/s²
  const double speed = cg_speed(plant, y), faster = unfaded_speed - speed;
  if (faster <= 0.0 || -moment.cg_acceleration.x > standstill) return 0.0;
  std::array<double, most_states> there, rate;
  std::copy(y, y + plant.states(), there.begin());
  there[static_cast<std::size_t>(plant.degrees())] += faster;
  for (std::size_t r = 0; r < plant.rows.size(); ++r)  // wheels that roll along
    there[static_cast<std::size_t>(2 * plant.degrees()) + r] += faster / moment.rows[r].roll_radius;
  Moment rolling;
  derivatives(plant, around, time, there.data(), rate.data(), &rolling);
  return std::max(0.0, -rolling.cg_acceleration.x);
}

Ending run_reference(const Plant& plant, const std::vector<double>& state, double rtol, double time_limit,
                     Observer& observer) {
  auto around = surroundings_at_entry(plant);
  OdeProblem problem;
  problem.states = plant.states();
  problem.rate = [&](double t, const double* y, double* dydt) { derivatives(plant, around, t, y, dydt); };
  std::vector<double> unused(state.size());
  problem.jacobian = [&](double t, const double* y, double* matrix) {
    jacobian(plant, around, t, y, unused.data(), matrix);
  };
  problem.quadratures = static_cast<int>(sinks);
  Moment moment;
  problem.integrand = [&, rate = std::vector<double>(state.size())](double t, const double* y, double* power) mutable {
    derivatives(plant, around, t, y, rate.data(), &moment);
    const auto now = powers(plant, around, y, moment);
    std::copy(now.begin(), now.end(), power);
  };
  problem.describe = [&](const double* y) { return in_words(plant, y); };
  OdeTolerances tolerances{rtol, absolute_tolerances(plant, rtol), longest_way(plant) / plant.entry_speed};
  Cvode solver(std::move(problem), std::move(tolerances));
  return Course<Cvode>(plant, around, solver, observer, time_limit).run(state);
}

Ending run_fast(const Plant& plant, const std::vector<double>& state, double rtol, double time_limit,
                Observer& observer) {
  auto around = surroundings_at_entry(plant);
  Rosenbrock solver(plant, around, rtol, longest_way(plant));
  return Course<Rosenbrock>(plant, around, solver, observer, time_limit).run(state);
}

}  // namespace apc::simulation
