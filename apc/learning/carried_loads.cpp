#include "apc/learning/carried_loads.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/simulation/plant.h"

namespace apc::learning {
namespace {

/// Smoothing of vertical acceleration and pitch rate: only what changes as slowly as the aircraft bounces is load; the
/// rest is vibration. Calibrated: near the highest evidence without any effect over six of the cases with known truth.
constexpr double swing_curvature = 6.0, pitching_curvature = 0.06;

/// Height of the centre of gravity above the axle, where drag acts.
double arm(const Case& data, const GearFacts& gear) { return data.aircraft.cg_height - gear.radius + 0.05; }

}  // namespace

double Share::static_load(const GearFacts& gear, double mass, double cg) const {
  const double share = gear.nose ? (main - cg) / (main - nose) : (cg - nose) / (main - nose);
  return mass * units::g0 * share / gear.wheels;
}

Share share_of(const std::vector<GearFacts>& gears) {
  Share s;
  for (const GearFacts& g : gears) (g.nose ? s.nose : s.main) = g.behind;
  return s;
}

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
                    gear.unsprung_mass * gear.struts / gear.wheels(),
                    &data.tables[g],
                    {g, gear.is_nose(), gear.wheels(), tire.width, tire.radius(), density}});
  }
  return list[0].nose != list[1].nose ? list : std::vector<GearFacts>{};
}

PerGear carried_loads(const Case& data, const std::vector<GearFacts>& gears, const Run& run, const Motion& m,
                      bool steady, double bias) {
  const Share share = share_of(gears);
  const double mass = run.overrun.mass, cg = run.overrun.cg_behind_nose_gear;
  const double first = m.time.front() - 0.1, last = m.time.back() + 0.3;
  std::optional<Smooth> up, turning;
  const Channel *az = run.find(Quantity::acceleration_z), *rate = run.find(Quantity::pitch_rate);
  // Without the turning, the vertical acceleration at its place in the cabin is not that of the whole aircraft.
  if (az && rate && !steady) {
    up = smooth(az->time, az->value, first, last, 0.05, az->noise, swing_curvature);
    turning = smooth(rate->time, rate->value, first, last, 0.05, rate->noise, pitching_curvature);
  }
  PerGear carried(gears.size(), std::vector<double>(m.size()));
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double t = m.time[i];
    double rise = 0.0, turn = 0.0;
    if (up) {
      const double at = t + mean_lag * rate->lag;
      turn = (turning->at(at + 0.1) - turning->at(at - 0.1)) / 0.2;
      rise = up->at(t + mean_lag * az->lag) - bias - az->lever_arm * turn;
    }
    const double lift = 0.5 * simulation::air_density * std::pow(m.speed[i] + run.overrun.headwind, 2) *
                        data.aircraft.aero.area * data.aircraft.aero.CL;
    const double total = std::max(0.3 * mass * units::g0, mass * (rise + units::g0) - lift);
    const double slowing = -(m.at(m.speed, t + 0.1) - m.at(m.speed, t - 0.1)) / 0.2;
    const double moment =
        run.overrun.pitch_inertia * turn + mass * std::max(0.0, slowing) * arm(data, gears[gears[0].nose ? 1 : 0]);
    const double nose = (moment + total * (share.main - cg)) / (share.main - share.nose);
    for (std::size_t g = 0; g < gears.size(); ++g)
      carried[g][i] = std::max(gears[g].nose ? nose : total - nose,
                               least_share * gears[g].wheels * share.static_load(gears[g], mass, cg));
  }
  return carried;
}

void load_motion(const Case& data, const std::vector<GearFacts>& gears, const Run& run, Motion& m) {
  m.steady = carried_loads(data, gears, run, m, true);
  m.carried = m.swing = carried_loads(data, gears, run, m, false);
  for (std::size_t g = 0; g < gears.size(); ++g)
    for (std::size_t i = 0; i < m.size(); ++i) m.swing[g][i] -= m.steady[g][i];
}

}  // namespace apc::learning
