#include "apc/simulation/carried_works.h"

#include "apc/simulation/observer.h"

namespace apc::simulation {

CarriedWorks::CarriedWorks(Neighbours& neighbours) : neighbours_(neighbours), rate_(neighbours.base.start.size()) {
  sum_.value.resize(sinks + neighbours.base.plant.groups.size());
  sum_.slope = sum_.value;
}

std::vector<double> CarriedWorks::powers_of(const Variant& variant, double t, const double* y) {
  const auto& plant = variant.plant;
  derivatives(plant, variant.around, t, y, rate_.data(), &moment_);
  for (std::size_t r = 0; r < plant.rows.size(); ++r) {
    auto& depth = moment_.rows[r].bed_depth;
    if (depth_known_) depth = depth_[r];
    depth_[r] = depth;
  }
  depth_known_ = true;
  const auto of_sinks = powers(plant, variant.around, y, moment_);
  std::vector<double> all(of_sinks.begin(), of_sinks.end());
  for (std::size_t g = 0; g < plant.groups.size(); ++g)
    all.push_back(group_load(plant, g, moment_)[0] / plant.groups[g].struts * moment_.rows[0].velocity.x);
  return all;
}

CarriedWorks::Powers CarriedWorks::at(double t, const std::vector<double>& y, const std::vector<double>& s) {
  depth_known_ = false;
  Powers now;
  now.value = powers_of(neighbours_.base, t, y.data());
  now.slope = neighbours_.totals(y, s, [&](Variant& v, const double* at) { return powers_of(v, t, at); });
  return now;
}

void CarriedWorks::add(double duration, const Powers& begin, const Powers& middle, const Powers& end) {
  for (std::size_t i = 0; i < sum_.value.size(); ++i) {
    sum_.value[i] += duration / 6.0 * (begin.value[i] + 4.0 * middle.value[i] + end.value[i]);
    sum_.slope[i] += duration / 6.0 * (begin.slope[i] + 4.0 * middle.slope[i] + end.slope[i]);
  }
}

void CarriedWorks::jump(const Powers& before, const Powers& after, double later) {
  for (std::size_t i = 0; i < sum_.slope.size(); ++i) sum_.slope[i] += (before.value[i] - after.value[i]) * later;
}

}  // namespace apc::simulation
