#include "sph_backend/rolling_history.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::sph {
namespace {

double mean_of_last(const std::vector<double>& values, std::size_t bins, std::size_t skip = 0) {
  double sum = 0.0;
  for (std::size_t k = 0; k < bins; ++k) sum += values[values.size() - 1 - skip - k];
  return sum / static_cast<double>(bins);
}

}  // namespace

void sample(RollingSums& s, RollingHistory& h, std::vector<double>& internal, double bin, double dt, double time,
            const AxleState& axle, const Tire& tire, const ContactResult& contact, double internal_energy) {
  s.drag -= 2.0 * contact.force_x, s.vertical += 2.0 * contact.force_z;
  s.spin += tire.spin * 0.5 * tire.shape.diameter / std::max(axle.vx, 1e-9);
  double deepest = 0.0;
  for (int i = 0; i < tire.grid.around; ++i) deepest = std::max(deepest, tire.u[tire.node(i, 0)]);
  s.deflection += deepest;
  s.steps += 1.0, s.distance += axle.vx * dt;
  if (s.distance < bin) return;
  h.time.push_back(time), h.distance.push_back(axle.x);
  h.drag.push_back(s.drag / s.steps), h.vertical.push_back(s.vertical / s.steps);
  h.spin_ratio.push_back(s.spin / s.steps), h.deflection.push_back(s.deflection / s.steps);
  internal.push_back(internal_energy);
  s = {};
}

void measure(const RollingHistory& h, const std::vector<double>& internal, RollingResult& result) {
  const std::size_t n = std::min(bins_per_window, h.drag.size() / 2);
  if (n == 0) return;
  const double d1 = mean_of_last(h.drag, n), d0 = mean_of_last(h.drag, n, n);
  const double v1 = mean_of_last(h.vertical, n), v0 = mean_of_last(h.vertical, n, n);
  const double s1 = mean_of_last(h.spin_ratio, n), s0 = mean_of_last(h.spin_ratio, n, n);
  result.drag = 0.5 * (d0 + d1), result.vertical = 0.5 * (v0 + v1), result.spin_ratio = 0.5 * (s0 + s1);
  result.tire_deflection = mean_of_last(h.deflection, 2 * n);
  const double size = std::max({std::abs(result.drag), std::abs(result.vertical), 1e-9});
  result.drag_change = (d1 - d0) / size, result.vertical_change = (v1 - v0) / size, result.spin_change = s1 - s0;
  const std::size_t last = internal.size() - 1;
  if (last >= 2 * n)
    result.internal_energy_rate =
        2.0 * (internal[last] - internal[last - 2 * n]) / (h.distance[last] - h.distance[last - 2 * n]);
}

bool settled(const RollingCase& setup, const RollingResult& r) {
  return std::abs(r.drag_change) < setup.load_tolerance && std::abs(r.vertical_change) < setup.load_tolerance &&
         std::abs(r.spin_change) < setup.spin_tolerance;
}

bool judge(const RollingCase& setup, const RollingHistory& h, const std::vector<double>& internal, std::size_t& judged,
           RollingResult& result) {
  if (h.drag.size() == judged) return false;
  judged = h.drag.size();
  if (h.distance.back() < setup.transient() + 2.0 * setup.window + 0.25 * setup.window) return false;
  if (setup.fall != 0.0 && h.distance.back() < setup.transient() + 3.0 * setup.window) return false;
  measure(h, internal, result);
  if (setup.fall == 0.0 && !settled(setup, result)) return false;
  result.state = RunState::steady;
  return true;
}

void conclude(const RollingCase& setup, RollingResult& result) {
  using units::in;
  using units::lbf;
  if (result.state == RunState::unstable) return;
  const TireShape& tire = setup.tire;
  const double limit = setup.tire_overload * tire.bottoming_load;
  const double deepest = setup.rigid_roller ? 0.0 : catalogue_deflection(tire, limit);
  if (std::abs(result.residual) > setup.residual_limit) {
    result.state = RunState::unstable;
    result.message = concat("energy account open by ", 100.0 * result.residual, " % (limit ",
                            100.0 * setup.residual_limit, " %). Try a smaller cfl or a finer spacing.");
  } else if (!setup.rigid_roller && (result.vertical > limit || result.tire_deflection > deepest)) {
    result.state = RunState::tire_overloaded;
    result.message =
        concat("tire overloaded: ", result.vertical / lbf, " lbf, ", result.tire_deflection / in, " in; the limit is ",
               limit / lbf, " lbf, ", deepest / in, " in (", setup.tire_overload, " of bottoming)");
  } else if (result.state == RunState::did_not_settle) {
    result.message =
        concat("did not settle within ", setup.longest / in, " in: between the last two windows drag changed by ",
               100.0 * result.drag_change, " %, vertical by ", 100.0 * result.vertical_change, " %, spin ratio by ",
               result.spin_change);
  }
}

}  // namespace apc::sph
