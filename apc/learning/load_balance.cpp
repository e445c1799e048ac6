#include "apc/learning/rut_balance.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/simulation/plant.h"

namespace apc::learning {
namespace {

constexpr double least_rut = 0.002;
/// Beds thinner than this are between the table's thinnest sample and pavement: blended, loads limited.
constexpr double thin = 0.12;

struct Share {
  double nose = 0.0, main = 0.0;  ///< m behind the nose gear
  /// Static load of one tire, N.
  double static_load(const GearFacts& gear, double mass, double cg) const {
    const double share = gear.nose ? (main - cg) / (main - nose) : (cg - nose) / (main - nose);
    return mass * units::g0 * share / gear.wheels;
  }
};

Share share_of(const std::vector<GearFacts>& gears) {
  Share s;
  for (const GearFacts& g : gears) (g.nose ? s.nose : s.main) = g.behind;
  return s;
}

/// Drag over vertical load of a tire on pavement under this load.
double rolling_ratio(const loadtables::LoadTable& table, double load) {
  double low = 0.0, high = 0.3;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (table.load_on_pavement(middle).load.vertical < load ? low : high) = middle;
  }
  const auto at = table.load_on_pavement(high).load;
  return at.drag / at.vertical;
}

/// The penetration at which the rut is `rut`, between the rut itself and a deflection of 0.6 radii (regula falsi).
template <class Load>
double penetration_of(double rut, double radius, const Load& load) {
  double low = rut, high = rut + 0.6 * radius;
  double below = load(low).rut_depth - rut, above = load(high).rut_depth - rut;
  if (below >= 0.0) return low;
  if (above <= 0.0) return high;
  int side = 0;
  double middle = high;
  for (int i = 0; i < 40 && high - low > 1e-6; ++i) {
    middle = (low * above - high * below) / (above - below);
    const double excess = load(middle).rut_depth - rut;
    if (std::abs(excess) < 2e-6) break;
    if (excess < 0.0) {
      low = middle, below = excess;
      if (side == -1) above *= 0.5;
      side = -1;
    } else {
      high = middle, above = excess;
      if (side == 1) below *= 0.5;
      side = 1;
    }
  }
  return middle;
}

/// Slope of the base: 0 where the base is level and the surface rises.
double base_slope(const bed::Bed& bed, double place) {
  return bed.flush == bed::Flush::top ? -bed.depth_slope_at(place) : 0.0;
}

/// α/sin θ of a sinking wheel, limited as in the simulation's law.
double sinking_angle(double incline, double penetration, double radius) {
  const double depth = std::min(penetration, radius);
  const double arc = std::sqrt(depth * (2.0 * radius - depth) / (radius * radius) + 0.06);
  return 0.6 * std::tanh(incline / arc / 0.6);
}

/// Height of the centre of gravity above the axle, where drag acts.
double arm(const Case& data, const GearFacts& gear) { return data.aircraft.cg_height - gear.radius + 0.05; }

void add_force(Balance& b, const Case& data, const GearFacts& gear, const Run& run, std::size_t i, double fx, double fz,
               double mass) {
  const auto k = static_cast<Eigen::Index>(i);
  b.along[k] += fx / mass;
  b.up[k] += fz / mass;
  b.pitching[k] +=
      (fx * arm(data, gear) - fz * (gear.behind - run.overrun.cg_behind_nose_gear)) / run.overrun.pitch_inertia;
}

}  // namespace

std::vector<GearFacts> gear_facts(const Case& data) {
  std::vector<GearFacts> list;
  if (data.aircraft.gears.size() != 2) return {};
  for (std::size_t g = 0; g < 2; ++g) {
    const aircraft::Gear& gear = data.aircraft.gears[g];
    if (gear.axles != 1) return {};
    const aircraft::Tire& tire = data.aircraft.tires.at(gear.tire);
    const double density = data.bed.nominal ? data.bed.nominal->density : 320.0;
    list.push_back({gear.is_nose(),
                    gear.behind_nose_gear,
                    gear.wheels(),
                    tire.radius(),
                    &data.tables[g],
                    {g, gear.is_nose(), gear.wheels(), tire.width, tire.radius(), density}});
  }
  return list[0].nose != list[1].nose ? list : std::vector<GearFacts>{};
}

Balance balance_at_ruts(const Case& data, const std::vector<GearFacts>& gears, const Run& run, const Motion& m,
                        const effects::Alterations& alterations, std::vector<std::vector<double>>* penetration) {
  aircraft::Aircraft craft = data.aircraft;
  bed::Bed bed = data.bed;
  const double mass = run.overrun.mass;
  effects::Site site{craft, bed, mass, run.overrun.cg_behind_nose_gear};
  effects::alter_site(alterations, site);
  const Share share = share_of(gears);
  const std::vector<double> none(m.size(), 0.0);
  Balance b;
  b.drag.assign(gears.size(), none), b.vertical = b.force_x = b.force_z = b.drag;
  const auto n = static_cast<Eigen::Index>(m.size());
  b.along = Eigen::VectorXd::Zero(n), b.up = b.pitching = b.along;
  if (penetration) penetration->assign(gears.size(), none);
  std::vector<double> ratio;
  for (const GearFacts& gear : gears)
    ratio.push_back(rolling_ratio(*gear.table, share.static_load(gear, mass, run.overrun.cg_behind_nose_gear)));
  for (std::size_t i = 0; i < m.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double v = std::max(m.speed[i], 0.1);
    const double pressure = 0.5 * simulation::air_density * std::pow(v + run.overrun.headwind, 2) * craft.aero.area;
    b.along[k] =
        (-pressure * craft.aero.CD + alterations.thrust(m.time[i]) + run.overrun.thrust) / mass - units::g0 * bed.grade;
    b.up[k] = pressure * craft.aero.CL / mass - units::g0;
    b.pitching[k] = pressure * craft.aero.CM / run.overrun.pitch_inertia;
    for (std::size_t g = 0; g < gears.size(); ++g) {
      const GearFacts& gear = gears[g];
      const double place = m.place[i] - gear.behind, depth = place > 0.0 ? bed.depth_at(place) : 0.0;
      const double standing = share.static_load(gear, mass, run.overrun.cg_behind_nose_gear);
      const double rolling = ratio[g];
      double drag = rolling * standing, vertical = standing, slope = 0.0;
      if (depth > 1e-4) {
        effects::TirePlace at{{v, depth, 0.0}, place, m.place[i], m.time[i]};
        const auto load = [&](double P) {
          at.contact.penetration = P;
          return effects::load(*gear.table, alterations, gear.tire, at);
        };
        const double P = penetration_of(std::max(m.rut[g][i], least_rut), gear.radius, load);
        const TireLoad found = load(P);
        if (penetration) (*penetration)[g][i] = P;
        double here = found.drag, weight = found.vertical;
        if (depth < thin) {
          double u = depth / thin;
          u = u * u * (3.0 - 2.0 * u);
          weight = u * std::min(weight, 2.0 * standing) + (1.0 - u) * standing;
          here = u * std::min(here, 0.5 * standing);
        }
        slope = base_slope(bed, place);
        const double incline = m.incline.empty() ? 0.0 : m.incline[g][i];
        vertical = weight * (1.0 + sinking_angle(incline, P, gear.radius));
        drag = here + rolling * vertical;
      }
      b.drag[g][i] = drag * gear.wheels, b.vertical[g][i] = vertical * gear.wheels;
      const double cosine = 1.0 / std::sqrt(1.0 + slope * slope), sine = slope * cosine;
      b.force_x[g][i] = gear.wheels * (-drag * cosine - vertical * sine);
      b.force_z[g][i] = gear.wheels * (vertical * cosine - drag * sine);
      add_force(b, data, gear, run, i, b.force_x[g][i], b.force_z[g][i], mass);
    }
  }
  return b;
}

Balance changed(const Balance& base, const Case& data, const std::vector<GearFacts>& gears, const Run& run,
                const Motion& m, const std::function<LoadChange(std::size_t, std::size_t)>& change) {
  Balance b = base;
  for (std::size_t g = 0; g < gears.size(); ++g)
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double place = m.place[i] - gears[g].behind;
      if (place <= 0.0 || data.bed.depth_at(place) <= 1e-4) continue;
      const LoadChange c = change(g, i);
      if (c.drag == 0.0 && c.vertical == 0.0) continue;
      const double slope = base_slope(data.bed, place), cosine = 1.0 / std::sqrt(1.0 + slope * slope),
                   sine = slope * cosine;
      const double drag = base.drag[g][i] * c.drag, vertical = base.vertical[g][i] * c.vertical;
      const double fx = -drag * cosine - vertical * sine, fz = vertical * cosine - drag * sine;
      b.force_x[g][i] += fx, b.force_z[g][i] += fz;
      add_force(b, data, gears[g], run, i, fx, fz, run.overrun.mass);
    }
  return b;
}

void settle(const Case& data, const std::vector<GearFacts>& gears, const Run& run, Motion& m) {
  effects::Alterations plain;
  plain.conditions = run.conditions;
  Balance b = balance_at_ruts(data, gears, run, m, plain, &m.penetration);
  const Channel *az = run.find(Quantity::acceleration_z), *rate = run.find(Quantity::pitch_rate);
  if (az && rate) {
    const double first = m.time.front() - 0.1, last = m.time.back() + 0.3;
    const Smooth up = smooth(az->time, az->value, first, last, 0.05, az->noise, 60.0),
                 turning = smooth(rate->time, rate->value, first, last, 0.05, rate->noise, 5.0);
    const Share share = share_of(gears);
    const double mass = run.overrun.mass, cg = run.overrun.cg_behind_nose_gear;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (m.place[i] - share.main < 1.0) continue;
      const double t = m.time[i], turn = (turning.at(t + 0.1) - turning.at(t - 0.1)) / 0.2;
      const double lift =
          0.5 * simulation::air_density * m.speed[i] * m.speed[i] * data.aircraft.aero.area * data.aircraft.aero.CL;
      const double total = mass * (up.at(t) - az->lever_arm * turn + units::g0) - lift;
      const double drag = -mass * std::max(0.0, -b.along[static_cast<Eigen::Index>(i)]);
      const double moment = run.overrun.pitch_inertia * turn - drag * arm(data, gears[gears[0].nose ? 1 : 0]);
      const double nose = (moment + total * (share.main - cg)) / (share.main - share.nose);
      for (std::size_t g = 0; g < gears.size(); ++g) {
        const GearFacts& gear = gears[g];
        const double depth = data.bed.depth_at(m.place[i] - gear.behind);
        if (m.penetration[g][i] <= 0.0 || depth < 0.1) continue;
        const double wanted = std::max(100.0, (gear.nose ? nose : total - nose) / gear.wheels),
                     surveyed = std::max(m.rut[g][i], least_rut);
        const double load_error = 0.1 * wanted + 0.05 * mass * units::g0 / 6.0;
        double best = 1e300;
        for (double P = 0.5 * surveyed; P < surveyed + 0.5 * gear.radius; P += 0.002) {
          const TireLoad l = gear.table->load({m.speed[i], depth, P});
          const double miss =
              std::pow((l.rut_depth - surveyed) / 0.01, 2) + std::pow((l.vertical - wanted) / load_error, 2);
          if (miss < best) best = miss, m.rut[g][i] = l.rut_depth;
          if (l.vertical > 4.0 * wanted && l.rut_depth > surveyed) break;
        }
      }
    }
    for (auto& rut : m.rut) {  // over 0.14 s, as the search leaves steps
      const auto rough = rut;
      for (std::size_t i = 3; i + 3 < rut.size(); ++i) {
        rut[i] = 0.0;
        for (std::size_t j = i - 3; j <= i + 3; ++j) rut[i] += rough[j] / 7.0;
      }
    }
    b = balance_at_ruts(data, gears, run, m, plain, &m.penetration);
  }
  m.incline.assign(gears.size(), std::vector<double>(m.size(), 0.0));
  for (std::size_t g = 0; g < gears.size(); ++g)
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (m.penetration[g][i] <= 0.0) continue;
      const std::size_t a = i > 5 ? i - 5 : 0, c = std::min(m.size() - 1, i + 5);
      const double dx = m.place[c] - m.place[a], v = m.speed[i];
      const double path = dx > 0.02 ? (m.penetration[g][c] - m.penetration[g][a]) / dx : 0.0;
      m.incline[g][i] = path * v * v / (v * v + 1.0) + base_slope(data.bed, m.place[i] - gears[g].behind);
    }
}

}  // namespace apc::learning
