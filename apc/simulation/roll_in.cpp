#include "apc/simulation/roll_in.h"

#include <algorithm>
#include <cmath>

#include "apc/simulation/energy.h"

namespace apc::simulation {

void record_roll_in(const Plant& plant, const Trim& at_entry, double interval, Observer& observer) {
  constexpr double lead = 1.0;  // s
  const auto n = static_cast<std::size_t>(plant.degrees());
  const double speed = at_entry.state[n], a = at_entry.acceleration;
  // a(V) is aerodynamic drag on a constant: one more trim, a second earlier, gives its slope.
  const auto before = trim(plant, speed - a * lead);
  const double step = before.state[n] - speed;
  const double slope = step != 0.0 ? (before.acceleration - a) / step : 0.0;
  Surroundings around;
  around.ruts.resize(plant.rows.size());
  std::vector<double> y(at_entry.state.size()), rate(y.size());
  Moment moment;
  derivatives(plant, around, 0.0, at_entry.state.data(), rate.data(), &moment);
  double power = 0.0;
  for (const double each : powers(plant, around, at_entry.state.data(), moment)) power += each;
  for (auto k = std::lround(lead / interval); k >= 1; --k) {
    const double t = -static_cast<double>(k) * interval;
    // V′ = a + slope (V − V₀) from V₀ at t = 0; its integral is the distance.
    const double z = slope * t, growth = std::abs(z) < 1e-6 ? t * (1.0 + 0.5 * z) : std::expm1(z) / slope;
    const double change = a * growth;
    const double way = speed * t + a * t * t * (std::abs(z) < 1e-3 ? 0.5 + z / 6.0 : (std::expm1(z) - z) / (z * z));
    const double share = step != 0.0 ? change / step : 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = at_entry.state[i] + share * (before.state[i] - at_entry.state[i]);
    y[0] = at_entry.state[0] + way;
    derivatives(plant, around, t, y.data(), rate.data(), &moment);
    observer.record(t, y.data(), moment, power * t);
  }
}

}  // namespace apc::simulation
