#include "apc/simulation/carried_extremes.h"

#include <algorithm>
#include <cmath>

#include "aircraft/limits.h"
#include "apc/simulation/observer.h"
#include "apc/simulation/overrun_run.h"

namespace apc::simulation {

CarriedExtremes::CarriedExtremes(Neighbours& neighbours, double interval)
    : neighbours_(neighbours),
      interval_(interval),
      rate_(neighbours.base.start.size()),
      peaks_(of_run + of_group * neighbours.base.plant.groups.size()),
      mean_over_(static_cast<std::size_t>(std::lround(0.1 / interval))) {}

std::vector<double> CarriedExtremes::signals(const Variant& variant, double t, const double* y) {
  const auto& plant = variant.plant;
  Moment moment;
  derivatives(plant, variant.around, t, y, rate_.data(), &moment);
  std::vector<double> values{-moment.cg_acceleration.x, y[2], -y[2]};
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& group = plant.groups[g];
    const auto load = group_load(plant, g, moment);
    double on_tire = 0.0, deepest_rut = 0.0, deepest = 0.0;
    for (int r = group.first_row; r < group.first_row + group.rows; ++r) {
      const auto& row = moment.rows[static_cast<std::size_t>(r)];
      on_tire = std::max(on_tire, row.ground.load.vertical);
      deepest = std::max(deepest, row.penetration);
      if (row.penetration > 0.0) deepest_rut = std::max(deepest_rut, row.ground.load.rut_depth);
    }
    for (const double each : {load[0] / group.struts, load[1] / group.struts, on_tire, deepest_rut, deepest, y[3 + g]})
      values.push_back(each);
  }
  return values;
}

CarriedExtremes::Samples CarriedExtremes::sample(double t, double offset, const Load& load) {
  const auto& [y, s] = load(t);
  const auto& plant = neighbours_.base.plant;
  const auto there = signals(neighbours_.base, t, y.data());
  auto near = y;
  derivatives(plant, neighbours_.base.around, t, y.data(), rate_.data());
  for (std::size_t i = 0; i < near.size(); ++i) near[i] += offset * rate_[i];
  const auto beside = signals(neighbours_.base, t + offset, near.data());
  const auto slope = neighbours_.totals(y, s, [&](const Variant& v, const double* at) { return signals(v, t, at); });
  Samples now{t, {}};
  for (std::size_t i = 0; i < there.size(); ++i)
    now.each.push_back({there[i], (beside[i] - there[i]) / offset, slope[i]});
  return now;
}

/// Solvers take tiny steps at corners they did not know of: those are looked at together.
void CarriedExtremes::see_piece(double from, double until, const Load& load, PieceEnd end) {
  constexpr double aside = 1e-6, shortest = 1e-4;  // s: from the ends, which may be corners; between samples
  if (last_.each.empty()) {
    last_ = sample(std::min(from + aside, until), aside, load);
  }
  const double last = end == PieceEnd::corner ? std::max(from, until - aside) : until;
  const bool several_steps = last_.time < from;
  if (last - last_.time > (end == PieceEnd::corner ? aside : shortest)) {
    const int parts = several_steps ? 1 : std::max(1, static_cast<int>(std::ceil((last - last_.time) / interval_)));
    const double begin = last_.time;
    for (int i = 1; i <= parts; ++i) {
      auto next = sample(begin + (last - begin) * i / parts, -aside, load);
      look_between(last_, next, load, several_steps ? Within::steps : Within::one_step);
      last_ = std::move(next);
    }
  }
  if (end == PieceEnd::corner) last_.each.clear();
}

void CarriedExtremes::look_between(const Samples& a, const Samples& b, const Load& load, Within within) {
  constexpr double exact = 1e-8, around = 2e-4;  // s: of the peak's time; for its two sides
  const double length = b.time - a.time;
  for (std::size_t i = 0; i < peaks_.size(); ++i) {
    const auto &rising = a.each[i], &falling = b.each[i];
    for (const auto& each : {rising, falling}) peaks_[i].offer(each.value, each.slope);
    if (!(rising.rate > 0.0 && falling.rate < 0.0)) continue;
    const double to_meet = (falling.value - rising.value - falling.rate * length) / (rising.rate - falling.rate);
    const double meeting = rising.value + rising.rate * to_meet;  // of the tangents; no concave signal is higher
    if (meeting < peaks_[i].value()) continue;
    if (within == Within::steps) {
      peaks_[i].offer_between(meeting, rising, falling);
      continue;
    }
    double low = a.time, high = b.time;
    while (high - low > exact) {
      const double middle = 0.5 * (low + high);
      (sample(middle, exact, load).each[i].rate > 0.0 ? low : high) = middle;
    }
    const double value = sample(low, exact, load).each[i].value;
    const auto before = sample(std::max(a.time, low - around), -exact, load);
    const auto after = sample(std::min(b.time, high + around), exact, load);
    peaks_[i].offer_between(value, before.each[i], after.each[i]);
  }
}

void CarriedExtremes::see_instant(double t, const State& now) {
  speeds_.push_back(
      {cg_speed(neighbours_.base.plant, now.y.data()),
       neighbours_.total(now.y, now.s, [](const Variant& v, const double* at) { return cg_speed(v.plant, at); })});
  if (speeds_.size() <= mean_over_) return;
  const auto& then = speeds_[speeds_.size() - 1 - mean_over_];
  mean_.see(t, (then[0] - speeds_.back()[0]) / 0.1, (then[1] - speeds_.back()[1]) / 0.1);
}

CarriedExtremes::Side CarriedExtremes::side(double t, const std::vector<double>& y, const std::vector<double>& moving,
                                            const std::vector<double>& near, double offset) {
  const auto there = signals(neighbours_.base, t, y.data()),
             beside = signals(neighbours_.base, t + offset, near.data());
  const auto slope =
      neighbours_.totals(y, moving, [&](const Variant& v, const double* at) { return signals(v, t, at); });
  Side seen;
  for (std::size_t i = 0; i < there.size(); ++i) seen.push_back({there[i], (beside[i] - there[i]) / offset, slope[i]});
  return seen;
}

void CarriedExtremes::see_corner(const Side& before, const Side& after) {
  for (std::size_t i = 0; i < peaks_.size(); ++i) peaks_[i].offer_corner(before[i], after[i]);
}

void CarriedExtremes::fill(Sensitivity& result) const {
  result.peak_deceleration = peaks_[deceleration].slope();
  result.peak_deceleration_100ms = speeds_.size() > mean_over_ ? mean_.slope() : result.peak_deceleration;
  result.peak_pitch = peaks_[pitch_up].slope();
  result.lowest_pitch = -peaks_[pitch_down].slope();
  for (std::size_t g = 0; g < result.gears.size(); ++g) {
    auto& gear = result.gears[g];
    gear.peak_drag = peak(g, drag).slope();
    gear.peak_vertical = peak(g, vertical).slope();
    gear.peak_stroke = peak(g, stroke).slope();
    gear.peak_rut = peak(g, rut).slope();
    gear.peak_penetration = peak(g, penetration).slope();
    gear.peak_tire_load = peak(g, tire).slope();
    // Margin = limit / peak − 1; limits follow from weights and balance, which a parameter may move.
    const auto limits = [g](const Variant& v) {
      return aircraft::load_limits(v.model.aircraft, v.model.aircraft.gears[g]);
    };
    const auto margin = [&](double aircraft::LoadLimits::*limit, const CarriedPeak& load) {
      const double allowed = limits(neighbours_.base).*limit, most = load.value();
      if (!(allowed > 0.0 && most > 0.0)) return 0.0;
      const double moved = neighbours_.held([&](const Variant& v) { return limits(v).*limit; });
      return moved / most - allowed / (most * most) * load.slope();
    };
    gear.drag_margin = margin(&aircraft::LoadLimits::drag_limit, peak(g, drag));
    gear.ultimate_margin = margin(&aircraft::LoadLimits::drag_ultimate, peak(g, drag));
    gear.vertical_margin = margin(&aircraft::LoadLimits::vertical_limit, peak(g, vertical));
  }
}

}  // namespace apc::simulation
