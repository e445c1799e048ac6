#include "apc/learning/carried_loads.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/simulation/plant.h"

namespace apc::learning {
namespace {

using Course = std::function<double(double time)>;

/// Smoothing of what the led model lacks of vertical acceleration, pitch rate and the nose gear's load (per its static
/// load): only what changes as slowly as the aircraft bounces is load; the rest is vibration. Calibrated: near the
/// highest evidence without any effect over six of the cases with known truth.
constexpr double swing_curvature = 4.0, pitching_curvature = 0.04, nose_curvature = 0.5;

/// What an instrument felt of the swing: the led model's, and the smoothed rest of what was measured.
class Felt {
 public:
  Felt(const Motion& m, const Channel& c, double curvature, Course model)
      : model_(std::move(model)), lag_(mean_lag * c.lag) {
    std::vector<double> rest = c.value;
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= model_(c.time[i] - lag_);
    rest_ = smooth(c.time, rest, m.time.front() - 0.1, m.time.back() + 0.3, 0.05, c.noise, curvature);
  }
  double at(double t) const { return rest_.at(t + lag_) + model_(t); }
  double rate_at(double t) const {
    return rate([&](double x) { return rest_.at(x + lag_); }, t, 0.1) + rate(model_, t, 0.04);
  }
  static double rate(const Course& of, double t, double half) { return (of(t + half) - of(t - half)) / (2.0 * half); }

 private:
  Course model_;
  double lag_;
  Smooth rest_;
};

/// Height of the centre of gravity above the axle, where drag acts.
double arm(const Case& data, const GearFacts& gear) { return data.aircraft.cg_height - gear.radius + 0.05; }

/// How far the model led along the speed tells the swing, s after entry: over random blocks its bounce soon loses step.
double led_believed(double t) { return std::exp(-std::pow(std::max(0.0, t) / 1.7, 2)); }

/// What the nose gear carried above statics before the bed, N.
double offset_before(const Felt& nose, const Motion& m, std::size_t g) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < m.size() && m.time[i] < -0.2; ++i) sum += nose.at(m.time[i]) - m.steady[g][i], ++count;
  return count > 10 ? sum / count : 0.0;
}

/// Part of that offset which the load cell is likely to blame for: the centre of gravity may be off, too.
double share_of_bias(const Channel& load, const Run& run, const Share& share) {
  const double by_cg = run.overrun.mass * units::g0 * run.uncertainty.cg / (share.main - share.nose);
  return load.bias == 0.0 ? 0.0 : load.bias * load.bias / (load.bias * load.bias + by_cg * by_cg);
}

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

double least_load(const GearFacts& gear, const Share& share, const Run& run) {
  return 0.15 * gear.wheels * share.static_load(gear, run.overrun.mass, run.overrun.cg_behind_nose_gear);
}

PerGear carried_loads(const Case& data, const std::vector<GearFacts>& gears, const Run& run, const Motion& m,
                      bool steady, double bias) {
  const Share share = share_of(gears);
  const double mass = run.overrun.mass, cg = run.overrun.cg_behind_nose_gear;
  std::optional<Felt> up, turning, on_nose;
  const Channel *az = run.find(Quantity::acceleration_z), *rate = run.find(Quantity::pitch_rate),
                *load = run.find(Quantity::nose_vertical);
  const auto led = [&m](const std::vector<double>& swing) {
    return [&](double t) { return swing.empty() ? 0.0 : led_believed(t) * m.at(swing, t); };
  };
  // Without the turning, the vertical acceleration at its place in the cabin is not that of the whole aircraft.
  if (az && rate && !steady) {
    const auto rise = led(m.led.rise), turn = led(m.led.pitch_rate);
    turning.emplace(m, *rate, pitching_curvature, turn);
    up.emplace(m, *az, swing_curvature,
               [&, rise, turn](double t) { return rise(t) + az->lever_arm * Felt::rate(turn, t, 0.04); });
  }
  double nose_offset = 0.0;
  if (load && !steady) {
    const std::size_t g = gears[0].nose ? 0 : 1;
    const double at_rest = gears[g].wheels * share.static_load(gears[g], mass, cg);
    on_nose.emplace(m, *load, nose_curvature * at_rest, [&, g](double t) {
      const double alone = m.at(m.steady[g], t);
      return m.led.nose.empty() ? alone : alone + led_believed(t) * (m.at(m.led.nose, t) - alone);
    });
    nose_offset = offset_before(*on_nose, m, g) * share_of_bias(*load, run, share);
  }
  PerGear carried(gears.size(), std::vector<double>(m.size()));
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double t = m.time[i];
    double rise = 0.0, turn = 0.0;
    if (up) {
      turn = turning->rate_at(t);
      rise = up->at(t) - bias - az->lever_arm * turn;
    }
    const double lift = 0.5 * simulation::air_density * std::pow(m.speed[i] + run.overrun.headwind, 2) *
                        data.aircraft.aero.area * data.aircraft.aero.CL;
    const double total = std::max(0.3 * mass * units::g0, mass * (rise + units::g0) - lift);
    const double slowing = -(m.at(m.speed, t + 0.1) - m.at(m.speed, t - 0.1)) / 0.2;
    const double moment =
        run.overrun.pitch_inertia * turn + mass * std::max(0.0, slowing) * arm(data, gears[gears[0].nose ? 1 : 0]);
    double nose = (moment + total * (share.main - cg)) / (share.main - share.nose);
    if (on_nose) nose = on_nose->at(t) - nose_offset;
    for (std::size_t g = 0; g < gears.size(); ++g)
      carried[g][i] = std::max(gears[g].nose ? nose : total - nose, least_load(gears[g], share, run));
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
