#include "sph_backend/tire.h"

#include <cmath>
#include <numbers>

#include "apc/base/require.h"

namespace apc::sph {

Tire make_tire(const TireShape& shape, const TireGrid& grid, const TireAssumptions& assumed, unsigned threads) {
  Tire tire;
  tire.shape = shape, tire.outline = section(shape), tire.grid = grid;
  const Section& s = tire.outline;
  const double radius = 0.5 * shape.diameter, crown_radius = s.lateral * s.lateral / s.radial;
  const double meridional = shape.inflation * (radius * radius - s.centre * s.centre) / (2.0 * radius);
  const double hoop = radius * (shape.inflation - meridional / crown_radius);
  require(hoop > 0.0, "tire ", shape.name, ": its section is too flat for the membrane model (hoop force ", hoop,
          " N/m). Check diameter, width and rim diameter.");

  const double dy = s.lateral / grid.across, dphi = 2.0 * std::numbers::pi / grid.around;
  const auto height = [&](double y) {
    return s.radial * std::sqrt(std::max(0.0, 1.0 - y * y / (s.lateral * s.lateral)));
  };
  const double areal = assumed.areal_mass_per_width * shape.width;
  for (int j = 0; j <= grid.across; ++j) {
    const double y = j * dy, share = j == 0 ? 0.5 : 1.0;
    tire.ring_radius.push_back(s.centre + height(y));
    const double arc = tire.ring_radius[j] * dphi;
    tire.area.push_back(share * dy * arc);
    tire.mass.push_back(areal * tire.area[j]);
    tire.hoop.push_back(hoop * share * dy / arc);
  }
  for (int j = 0; j < grid.across; ++j) {
    const double ds = std::hypot(dy, height((j + 1) * dy) - height(j * dy));
    tire.meridian.push_back(meridional * 0.5 * (tire.ring_radius[j] + tire.ring_radius[j + 1]) * dphi / ds);
  }
  const std::size_t nodes = static_cast<std::size_t>(grid.around) * (grid.across + 1);
  tire.u.assign(nodes, 0.0), tire.rate.assign(nodes, 0.0), tire.force.assign(nodes, 0.0);
  tire.wheel_inertia = 0.5 * assumed.inertia_factor * std::pow(shape.diameter, 4) * shape.width;
  calibrate_foundation(tire, threads);
  const double stiffness =
      std::max(tire.foundation(shape.rated_deflection), 0.05 * shape.inflation) / shape.rated_deflection;
  tire.damping = 2.0 * assumed.damping_ratio * std::sqrt(stiffness / areal);
  return tire;
}

Tire make_roller(const TireShape& shape, double half_width) {
  Tire tire;
  tire.shape = shape, tire.rigid = true;
  const double radius = 0.5 * shape.diameter;
  tire.outline = {1e6 * radius, 0.5 * radius, 0.5 * radius};
  tire.ring_radius.assign(tire.grid.across + 1, radius);
  tire.area.assign(tire.grid.across + 1, 0.0), tire.mass.assign(tire.grid.across + 1, 1.0);
  tire.hoop.assign(tire.grid.across + 1, 0.0), tire.meridian.assign(tire.grid.across, 0.0);
  tire.foundation = LinearCurve({0.0, 1.0}, {0.0, 0.0});
  const std::size_t nodes = static_cast<std::size_t>(tire.grid.around) * (tire.grid.across + 1);
  tire.u.assign(nodes, 0.0), tire.rate.assign(nodes, 0.0), tire.force.assign(nodes, 0.0);
  tire.wheel_inertia = TireAssumptions{}.inertia_factor * std::pow(shape.diameter, 4) * half_width;
  return tire;
}

void elastic_force(const Tire& tire, std::vector<double>& force) {
  const int around = tire.grid.around, across = tire.grid.across;
  force.assign(tire.u.size(), 0.0);
  for (int i = 0; i < around; ++i) {
    const int next = i + 1 == around ? 0 : i + 1;
    for (int j = 0; j < across; ++j) {
      const std::size_t here = tire.node(i, j);
      const double u = tire.u[here];
      if (u != 0.0) force[here] -= tire.area[j] * (u > 0.0 ? tire.foundation(u) : -tire.foundation(-u));
      const double around_pull = tire.hoop[j] * (tire.u[tire.node(next, j)] - u);
      force[here] += around_pull, force[tire.node(next, j)] -= around_pull;
      const double across_pull = tire.meridian[j] * (tire.u[here + 1] - u);
      force[here] += across_pull, force[here + 1] -= across_pull;
    }
  }
}

double stored_energy(const Tire& tire) {
  const int around = tire.grid.around, across = tire.grid.across;
  const auto& x = tire.foundation.x();
  const auto& q = tire.foundation.y();
  const auto potential = [&](double u) {  // ∫ q du, odd continuation
    u = std::abs(u);
    double sum = 0.0;
    std::size_t k = 1;
    for (; k < x.size() && x[k] < u; ++k) sum += 0.5 * (q[k] + q[k - 1]) * (x[k] - x[k - 1]);
    return sum + 0.5 * (q[k - 1] + tire.foundation(u)) * (u - x[k - 1]);
  };
  double energy = 0.0;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = tire.u[tire.node(i, j)];
      const double du = tire.u[tire.node(i + 1 == around ? 0 : i + 1, j)] - u, dv = tire.u[tire.node(i, j) + 1] - u;
      energy += tire.area[j] * potential(u) + 0.5 * tire.hoop[j] * du * du + 0.5 * tire.meridian[j] * dv * dv;
    }
  return energy;
}

double tread_kinetic_energy(const Tire& tire) {
  double energy = 0.0;
  for (int i = 0; i < tire.grid.around; ++i)
    for (int j = 0; j < tire.grid.across; ++j)
      energy += 0.5 * tire.mass[j] * tire.rate[tire.node(i, j)] * tire.rate[tire.node(i, j)];
  return energy;
}

GasState gas_state(const Tire& tire) {
  const Section& s = tire.outline;
  const double area = std::numbers::pi * s.lateral * s.radial;  // both halves of the section taken as ellipses
  const double volume = 2.0 * std::numbers::pi * s.centre * area, atmosphere = 101325.0;
  double lost = 0.0;
  for (int i = 0; i < tire.grid.around; ++i)
    for (int j = 0; j < tire.grid.across; ++j) lost += 2.0 * tire.area[j] * tire.u[tire.node(i, j)];
  return {volume - lost, -lost, (tire.shape.inflation + atmosphere) * volume / (volume - lost) - atmosphere};
}

double kick_tire(Tire& tire, double dt, std::vector<double>& mean_rate) {
  mean_rate.assign(tire.u.size(), 0.0);
  if (tire.rigid) return 0.0;
  static thread_local std::vector<double> elastic;
  elastic_force(tire, elastic);
  double damped = 0.0;
  const double half = 0.5 * dt * tire.damping;
  for (int i = 0; i < tire.grid.around; ++i)
    for (int j = 0; j < tire.grid.across; ++j) {
      const std::size_t n = tire.node(i, j);
      const double push = (tire.force[n] + elastic[n]) / tire.mass[j];
      const double next = ((1.0 - half) * tire.rate[n] + dt * push) / (1.0 + half);
      mean_rate[n] = 0.5 * (tire.rate[n] + next);
      damped += dt * tire.damping * tire.mass[j] * mean_rate[n] * mean_rate[n];
      tire.rate[n] = next;
    }
  return damped;
}

}  // namespace apc::sph
