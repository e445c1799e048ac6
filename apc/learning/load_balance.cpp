#include "apc/learning/load_balance.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/simulation/plant.h"

namespace apc::learning {
namespace {

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

/// The penetration at which the load is the one carried (regula falsi, outwards from a guess).
template <class Excess>
double penetration_of(double guess, double most, const Excess& excess) {
  double low = 0.0, high = std::min(guess, most), below = excess(0.0), above = excess(high);
  while (above < 0.0 && high < most) {
    low = high, below = above;
    high = std::min(most, 1.15 * high + 0.005);
    above = excess(high);
  }
  if (above <= 0.0) return high;
  if (below >= 0.0) return low;
  if (low == 0.0) {  // the root is below the guess: near it, as a rule
    const double near = 0.85 * high, there = excess(near);
    if (there < 0.0)
      low = near, below = there;
    else
      high = near, above = there;
  }
  int side = 0;
  double middle = high;
  for (int i = 0; i < 40 && high - low > 1e-5; ++i) {
    middle = (low * above - high * below) / (above - below);
    const double there = excess(middle);
    if (std::abs(there) < 1e-4) break;
    if (there < 0.0) {
      low = middle, below = there;
      if (side == -1) above *= 0.5;
      side = -1;
    } else {
      high = middle, above = there;
      if (side == 1) below *= 0.5;
      side = 1;
    }
  }
  return middle;
}

/// Slope of the base under a wheel: 0 where the base is level and the surface rises.
double slope_under(const bed::Bed& bed, double place) {
  return place > 0.0 && bed.flush == bed::Flush::top ? -bed.depth_slope_at(place) : 0.0;
}

/// α/sin θ of a sinking wheel and its derivative by α, limited as in the simulation's law.
struct Sinking {
  double share = 0.0, by_incline = 0.0;
};
Sinking sinking_of(double incline, double penetration, double radius) {
  const double depth = std::clamp(penetration, 0.0, radius);
  const double arc = std::sqrt(depth * (2.0 * radius - depth) / (radius * radius) + 0.06);
  const double share = std::tanh(incline / arc / 0.6);
  return {0.6 * share, (1.0 - share * share) / arc};
}

/// One tire at one sample of a motion, with the penetrations before: what its load lacks of the one carried.
struct Wheel {
  const GearFacts& gear;
  const effects::Alterations& alterations;
  effects::TirePlace at;
  double carried = 0.0, slope = 0.0;                ///< N; of the base
  double last = 0.0, second_last = 0.0;             ///< m
  double response = 1.0;                            ///< to sinking, × that of a rigid wheel
  double way = 1.0, interval = 0.02, easing = 1.0;  ///< m and s since the last sample; → 0 at rest: no path then

  TireLoad load(double penetration) {
    at.contact.penetration = penetration;
    return effects::load(*gear.table, alterations, gear.tire, at);
  }
  Sinking sinking(double penetration) const {
    const Sinking s = sinking_of((penetration - last) / way * easing + slope, penetration, gear.radius);
    return {response * s.share, response * s.by_incline};
  }
  double inertia() const { return gear.unsprung_mass / (interval * interval); }
  /// Relative.
  double excess(double penetration, const TireLoad& l) const {
    return (l.vertical * (1.0 + sinking(penetration).share) - slope * l.drag +
            inertia() * (penetration - 2.0 * last + second_last)) /
               carried -
           1.0;
  }
};

/// Calls `each(gear, sample, wheel)`, which returns the penetration it found, for every sample in the bed in order of
/// time.
template <class Each>
void along_the_bed(const std::vector<GearFacts>& gears, const Motion& m, const bed::Bed& bed,
                   const effects::Alterations& alterations, const Each& each) {
  for (std::size_t g = 0; g < gears.size(); ++g) {
    const GearFacts& gear = gears[g];
    double last = 0.0, second_last = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double place = m.place[i] - gear.behind, depth = place > 0.0 ? bed.depth_at(place) : 0.0;
      if (depth <= 1e-4) {
        last = second_last = 0.0;
        continue;
      }
      const double v = std::max(m.speed[i], 0.1), way = i > 0 ? m.place[i] - m.place[i - 1] : 1.0;
      Wheel wheel{gear,
                  alterations,
                  {{v, depth, 0.0}, place, m.place[i], m.time[i]},
                  m.carried[g][i] / gear.wheels,
                  slope_under(bed, place),
                  last,
                  second_last,
                  m.sinking,
                  std::max(way, 1e-3),
                  m.interval,
                  v * v / (v * v + 1.0)};
      second_last = last;
      last = each(g, i, wheel);
    }
  }
}

}  // namespace

Balance balance_at_loads(const Case& data, const std::vector<GearFacts>& gears, const Run& run, const Motion& m,
                         const effects::Alterations& alterations) {
  aircraft::Aircraft craft = data.aircraft;
  bed::Bed bed = data.bed;
  const double mass = run.overrun.mass;
  effects::Site site{craft, bed, mass, run.overrun.cg_behind_nose_gear};
  effects::alter_site(alterations, site);
  const Share share = share_of(gears);
  Balance b;
  b.drag.assign(gears.size(), std::vector<double>(m.size(), 0.0));
  b.vertical = b.rut = b.penetration = b.force_x = b.drag;
  b.along = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m.size()));
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double v = std::max(m.speed[i], 0.1);
    const double pressure =
        0.5 * simulation::air_density * std::pow(v + run.overrun.headwind + site.headwind, 2) * craft.aero.area;
    b.along[static_cast<Eigen::Index>(i)] =
        (-pressure * craft.aero.CD + alterations.thrust(m.time[i]) + run.overrun.thrust) / mass - units::g0 * bed.grade;
  }
  std::vector<double> rolling;
  for (std::size_t g = 0; g < gears.size(); ++g) {
    rolling.push_back(
        rolling_ratio(*gears[g].table, share.static_load(gears[g], mass, run.overrun.cg_behind_nose_gear)));
    for (std::size_t i = 0; i < m.size(); ++i) {
      b.vertical[g][i] = m.carried[g][i];
      b.drag[g][i] = rolling[g] * m.carried[g][i];
    }
  }
  along_the_bed(gears, m, bed, alterations, [&](std::size_t g, std::size_t i, Wheel& wheel) {
    TireLoad found;
    const double depth = wheel.at.contact.bed_depth;
    const double P = penetration_of(std::max(0.004, wheel.last), depth + 0.6 * wheel.gear.radius, [&](double p) {
      found = wheel.load(p);
      return wheel.excess(p, found);
    });
    found = wheel.load(P);
    b.penetration[g][i] = P, b.rut[g][i] = found.rut_depth;
    b.drag[g][i] = wheel.gear.wheels * found.drag;
    return P;
  });
  for (std::size_t g = 0; g < gears.size(); ++g)
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double slope = slope_under(bed, m.place[i] - gears[g].behind);
      b.force_x[g][i] = -(b.drag[g][i] + b.vertical[g][i] * slope) / std::sqrt(1.0 + slope * slope);
      b.along[static_cast<Eigen::Index>(i)] += b.force_x[g][i] / mass;
    }
  return b;
}

Balance Response::to(const Case& data, const std::vector<GearFacts>& gears, const Run& run, const Motion& m,
                     const std::function<LoadChange(std::size_t, std::size_t)>& by) const {
  Balance b = base;
  for (std::size_t g = 0; g < gears.size(); ++g) {
    double last = 0.0, second_last = 0.0;  // changes of the penetrations before
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (load_by_depth[g][i] == 0.0) continue;
      const LoadChange c = by(g, i);
      const double forced = load_by_strength[g][i] * c.strength + c.table_vertical - c.carried +
                            load_by_last[g][i] * last + load_by_second_last[g][i] * second_last;
      const double deeper = -forced / load_by_depth[g][i];
      second_last = last, last = deeper;
      if (deeper == 0.0 && c.drag == 0.0 && c.strength == 0.0 && c.carried == 0.0) continue;
      const double drag = c.drag * base.drag[g][i] + drag_by_strength[g][i] * c.strength + drag_by_depth[g][i] * deeper;
      const double slope = slope_under(data.bed, m.place[i] - gears[g].behind);
      const double force = -(drag + c.carried * base.vertical[g][i] * slope) / std::sqrt(1.0 + slope * slope);
      b.drag[g][i] += drag, b.vertical[g][i] *= 1.0 + c.carried, b.penetration[g][i] += deeper;
      b.rut[g][i] += rut_by_strength[g][i] * c.strength + rut_by_depth[g][i] * deeper;
      b.force_x[g][i] += force;
      b.along[static_cast<Eigen::Index>(i)] += force / run.overrun.mass;
    }
  }
  return b;
}

Response response_at_loads(const Case& data, const std::vector<GearFacts>& gears, const Run& run, const Motion& m,
                           const effects::Alterations& alterations) {
  constexpr double deeper = 0.004, stronger = 0.04;
  Response r;
  r.base = balance_at_loads(data, gears, run, m, alterations);
  const PerGear zero(gears.size(), std::vector<double>(m.size(), 0.0));
  r.load_by_depth = r.load_by_strength = r.drag_by_depth = r.drag_by_strength = r.rut_by_depth = r.rut_by_strength =
      zero;
  r.load_by_last = r.load_by_second_last = r.sinking = zero;
  effects::Alterations strong = alterations;
  strong.bed_strength *= std::exp(stronger);
  aircraft::Aircraft craft = data.aircraft;
  bed::Bed bed = data.bed;
  effects::Site site{craft, bed, run.overrun.mass, run.overrun.cg_behind_nose_gear};
  effects::alter_site(alterations, site);
  along_the_bed(gears, m, bed, alterations, [&](std::size_t g, std::size_t i, Wheel& wheel) {
    const double P = r.base.penetration[g][i], wheels = wheel.gear.wheels;
    const TireLoad here = wheel.load(P), below = wheel.load(P + deeper), above = wheel.load(std::max(0.0, P - deeper));
    Wheel in_strong{wheel.gear, strong, wheel.at};
    const TireLoad changed = in_strong.load(P);
    const double both = P + deeper - std::max(0.0, P - deeper);
    const Sinking sinking = wheel.sinking(P);
    const double by_path = here.vertical * sinking.by_incline * wheel.easing / wheel.way;
    r.load_by_depth[g][i] =
        std::max(0.05, ((below.vertical - above.vertical) / both * (1.0 + sinking.share) + by_path + wheel.inertia()) /
                           wheel.carried);
    r.load_by_last[g][i] = -(by_path + 2.0 * wheel.inertia()) / wheel.carried;
    r.load_by_second_last[g][i] = wheel.inertia() / wheel.carried;
    r.load_by_strength[g][i] = (changed.vertical - here.vertical) / stronger * (1.0 + sinking.share) / wheel.carried;
    r.drag_by_depth[g][i] = wheels * (below.drag - above.drag) / both;
    r.drag_by_strength[g][i] = wheels * (changed.drag - here.drag) / stronger;
    r.rut_by_depth[g][i] = (below.rut_depth - above.rut_depth) / both;
    r.rut_by_strength[g][i] = (changed.rut_depth - here.rut_depth) / stronger;
    r.sinking[g][i] = sinking.share / (1.0 + sinking.share);
    return P;
  });
  return r;
}

}  // namespace apc::learning
