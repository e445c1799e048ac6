#include "apc/simulation/trim.h"

#include <fmt/core.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aircraft/strut.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/simulation/overrun_run.h"

namespace apc::simulation {
namespace {

/// Deflection of one tire on pavement under `load`, N; at most the radius.
double deflection_under(const Group& group, double load) {
  double low = 0.0, high = group.tire_radius;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (group.ground.table->load_on_pavement(middle).load.vertical < load ? low : high) = middle;
  }
  return low;
}

/// Gears under their static loads, and the height and pitch that put their tires on the ground: near enough that no
/// first step drives a light nose tire down to its rim, from where the next one would lead back for ever.
std::vector<double> first_guess(const Plant& plant, double speed) {
  std::vector<double> y(static_cast<std::size_t>(plant.states()), 0.0);
  const auto n = static_cast<std::size_t>(plant.degrees());
  const double weight = -plant.gravity.z;
  double behind = 0.0, tires = 0.0;
  for (const auto& row : plant.rows) {
    const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
    if (row.group > 0) behind -= row.tires * group.extended.x, tires += row.tires;
  }
  const double nose = plant.groups.front().extended.x, base = nose + behind / tires;
  const double nose_load = plant.mass * weight * (base - nose + plant.cg.x) / base;
  double height_of_nose = 0.0, height_of_mains = 0.0;  // of S above the ground, as each would have it in level attitude
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& group = plant.groups[g];
    double own = 0.0;
    for (int r = group.first_row; r < group.first_row + group.rows; ++r)
      own += plant.rows[static_cast<std::size_t>(r)].tires;
    const double share = g == 0 ? nose_load : (plant.mass * weight - nose_load) * own / tires;
    const double load = std::max(0.05 * plant.mass, share / group.struts - group.mass / group.struts * weight);
    const double stroke = y[3 + g] = aircraft::static_stroke(group.strut, load);
    const double height =
        group.tire_radius - deflection_under(group, std::max(0.0, share / own)) - group.extended.z - stroke;
    (g == 0 ? height_of_nose : height_of_mains) += g == 0 ? height : height * own / tires;
  }
  y[2] = (height_of_nose - height_of_mains) / base;
  y[1] = height_of_nose - y[2] * nose;
  y[n] = speed;
  return y;
}

/// Spins at which slip accelerates the wheels as fast as the aircraft.
void set_spins(const Plant& plant, const Surroundings& around, std::vector<double>& y) {
  const int n = plant.degrees();
  std::vector<double> rate(y.size());
  for (int pass = 0; pass < 3; ++pass) {
    Moment moment;
    derivatives(plant, around, 0.0, y.data(), rate.data(), &moment);
    for (std::size_t r = 0; r < plant.rows.size(); ++r) {
      const auto& row = moment.rows[r];
      const double wanted = rate[static_cast<std::size_t>(n)] / row.roll_radius;  // ω′ of a wheel that keeps its slip
      double slip = 0.0;
      const bool inertial = plant.wheel_spin == WheelSpin::inertial || plant.brake_mode == BrakeMode::torque;
      if (inertial && row.ground.load.vertical > 0.0) {
        const double braked = plant.brake_mode == BrakeMode::torque ? row.brake_torque : 0.0;
        const double force = (wanted * plant.rows[r].inertia + braked) / (row.roll_radius * plant.rows[r].tires);
        const double share = std::clamp(force / (slip_friction * row.ground.load.vertical), -0.999, 0.999);
        slip = slip_friction / slip_stiffness * std::atanh(share);
      }
      y[2 * static_cast<std::size_t>(n) + r] = (row.speed - slip * std::hypot(row.speed, slip_floor)) / row.roll_radius;
    }
  }
}

/// Why an aircraft will not stand, and what to do; as far as it can be told from outside.
std::string cause(const Plant& plant, double speed, const std::vector<double>& y) {
  const double air = speed + plant.headwind, weight = -plant.mass * plant.gravity.z;
  const double lift = plant.lift_area * air * std::abs(air);
  if (lift > 0.9 * weight)
    return fmt::format(
        "the lift of {:.0f} kN at an airspeed of {:.1f} m/s leaves too little of the weight of {:.0f} kN "
        "on the wheels: it would fly. Lower the speed or the headwind, or raise the mass",
        lift / units::kN, air, weight / units::kN);
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& strut = plant.groups[g].strut;
    if (y[3 + g] > strut.stroke)
      return fmt::format(
          "the {} strut is driven {:.3f} m into its stop. Look at mass, centre of gravity and its "
          "pressure and volume",
          plant.groups[g].name, y[3 + g] - strut.stroke);
    if (y[3 + g] < 0.0)
      return fmt::format(
          "nothing rests on the {} strut, which is extended by {:.3f} m beyond its stop. Move the centre "
          "of gravity, or lower braking, thrust or headwind",
          plant.groups[g].name, -y[3 + g]);
  }
  return "Check mass, centre of gravity, strut and tire data";
}

}  // namespace

Trim trim(const Plant& plant, double speed) {
  const int n = plant.degrees(), states = plant.states(), unknowns = n - 1;
  Surroundings around;
  around.ruts.resize(plant.rows.size());
  Trim result;
  auto& y = result.state = first_guess(plant, speed);
  std::vector<double> rate(y.size()), matrix(y.size() * y.size());
  // Per unknown (Z, θ, strokes, beams): the longest step. Residuals: accelerations, so that rad/s² and m/s² compare.
  Eigen::MatrixXd a(unknowns, unknowns);
  Eigen::VectorXd b(unknowns);
  double residual = INFINITY;
  for (result.iterations = 1; result.iterations <= 100; ++result.iterations) {
    set_spins(plant, around, y);
    jacobian(plant, around, 0.0, y.data(), rate.data(), matrix.data());
    for (int i = 0; i < unknowns; ++i) {
      b[i] = -rate[static_cast<std::size_t>(n + 1 + i)];
      for (int j = 0; j < unknowns; ++j) a(i, j) = matrix[static_cast<std::size_t>((n + 1 + i) * states + 1 + j)];
    }
    residual = b.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(residual)) break;
    if (residual < 1e-11) break;
    Eigen::VectorXd step = a.partialPivLu().solve(b);
    double largest = 0.0;
    for (int i = 0; i < unknowns; ++i) largest = std::max(largest, std::abs(step[i]) / 0.05);
    if (!std::isfinite(largest)) break;
    if (largest > 1.0) step /= largest;
    for (int i = 0; i < unknowns; ++i) y[static_cast<std::size_t>(1 + i)] += step[i];
    for (std::size_t g = 0; g < plant.groups.size(); ++g) {  // the gas law ends at V/A
      const auto& strut = plant.groups[g].strut;
      y[3 + g] = std::min(y[3 + g], 0.5 * (y[3 + g] - step[static_cast<int>(2 + g)]) +
                                        0.5 * strut.extended_gas_volume / strut.piston_area);
    }
    if (step.lpNorm<Eigen::Infinity>() < 1e-14) break;
  }
  if (!(residual < 1e-6))
    throw SolveError(concat("the aircraft cannot be trimmed at t = 0 s, before the run: accelerations of ", residual,
                            " m/s^2 remain after ", result.iterations, " Newton steps (", in_words(plant, y.data()),
                            "): ", cause(plant, speed, y)));
  set_spins(plant, around, y);
  Moment moment;
  derivatives(plant, around, 0.0, y.data(), rate.data(), &moment);
  y[0] -= nose_distance(plant, y.data());
  y[static_cast<std::size_t>(n)] = speed;
  result.acceleration = moment.cg_acceleration.x;
  return result;
}

}  // namespace apc::simulation
