#include "apc/simulation/energy.h"

#include "aircraft/strut.h"

namespace apc::simulation {
namespace {

double squared(double x) { return x * x; }

}  // namespace

Stores stores(const Plant& plant, const double* y) {
  const double* rate = y + plant.degrees();
  const double* spin = y + 2 * plant.degrees();
  const double c = std::cos(y[2]), s = std::sin(y[2]), q = rate[2];
  const auto height = [&](double x, double z, double mass) {
    return -mass * (plant.gravity.x * x + plant.gravity.z * z);
  };
  Stores result;
  result.kinetic =
      0.5 * plant.sprung_mass * (squared(rate[0]) + squared(rate[1])) + 0.5 * plant.sprung_inertia * squared(q);
  result.potential = height(y[0], y[1], plant.sprung_mass);
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& group = plant.groups[g];
    const double stroke = y[3 + g];
    const Vector body{group.extended.x + stroke * group.axis.x, group.extended.z + stroke * group.axis.z};
    const Vector rho{body.x * c - body.z * s, body.x * s + body.z * c};
    const Vector axis{group.axis.x * c - group.axis.z * s, group.axis.x * s + group.axis.z * c};
    const double u = rate[0] - q * rho.z + rate[3 + g] * axis.x, w = rate[1] + q * rho.x + rate[3 + g] * axis.z;
    result.kinetic += 0.5 * group.mass * (u * u + w * w);
    result.potential += height(y[0] + rho.x, y[1] + rho.z, group.mass);
    result.oleo_gas += group.struts * aircraft::gas_energy(group.strut, stroke);
    result.stops += group.struts * aircraft::stop_energy(group.strut, stroke);
    if (group.bogie >= 0)
      result.kinetic +=
          0.5 * group.bogie_inertia * squared(rate[3 + plant.groups.size() + static_cast<std::size_t>(group.bogie)]);
  }
  if (plant.wheel_spin == WheelSpin::inertial || plant.brake_mode == BrakeMode::torque)
    for (std::size_t r = 0; r < plant.rows.size(); ++r)
      result.kinetic += 0.5 * plant.rows[r].inertia * squared(spin[r]);
  return result;
}

std::array<double, sinks> powers(const Plant& plant, const Surroundings& around, const double* y,
                                 const Moment& moment) {
  std::array<double, sinks> p{};
  const auto take = [&p](Sink sink, double power) { p[static_cast<std::size_t>(sink)] += power; };
  const double* rate = y + plant.degrees();
  const double q = rate[2];
  const bool slips = plant.wheel_spin == WheelSpin::inertial || plant.brake_mode == BrakeMode::torque;
  for (std::size_t r = 0; r < plant.rows.size(); ++r) {
    const auto& row = moment.rows[r];
    const double ground = -(row.contact_x * row.velocity.x + row.contact_z * row.velocity.z);
    take(around.in_bed[r] && row.bed_depth > 0.0 ? Sink::bed : Sink::tires, ground);
    const double along = row.tangent.x * row.velocity.x + row.tangent.z * row.velocity.z;
    // What holds the brake turns with θ′, or φ′ where it is a beam; on the wheel the torque works only where the wheel
    // is a body of its own.
    const bool on_wheel = plant.brake_mode == BrakeMode::torque;
    const auto& group = plant.groups[static_cast<std::size_t>(plant.rows[r].group)];
    const double held =
        group.brakes_on_beam ? rate[3 + plant.groups.size() + static_cast<std::size_t>(group.bogie)] : q;
    take(Sink::brakes, row.brake_force * along + row.brake_torque * (held + (on_wheel ? row.spin : 0.0)));
    take(Sink::wheel_slip, row.slip_force * (along - (slips ? row.roll_radius * row.spin : 0.0)));
  }
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& group = plant.groups[g];
    const auto& strut = moment.groups[g];
    take(Sink::oleo_damping, group.struts * strut.orifice * strut.stroke_rate);
    take(Sink::strut_friction, group.struts * strut.friction * strut.stroke_rate);
    if (group.bogie >= 0)
      take(Sink::bogie_damping,
           group.bogie_damping * squared(rate[3 + plant.groups.size() + static_cast<std::size_t>(group.bogie)] - q));
  }
  take(Sink::aero, -(moment.aero.x * rate[0] + moment.aero.z * rate[1] + moment.aero_moment * q));
  take(Sink::thrust, -(moment.thrust.x * rate[0] + moment.thrust.z * rate[1] + moment.thrust_moment * q));
  return p;
}

}  // namespace apc::simulation
