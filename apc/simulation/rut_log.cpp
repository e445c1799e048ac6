#include "apc/simulation/rut_log.h"

#include <algorithm>
#include <cmath>

namespace apc::simulation {

void RutLog::write(double distance, const Rut& rut) {
  if (!entries_.empty() && distance < distances_.back() + 1e-3) return;
  distances_.push_back(distance);
  entries_.push_back({{rut.depth, rut.penetration, rut.drag, rut.vertical}, {}});
  const std::size_t n = entries_.size();
  if (n == 1) distances_.reserve(1024), entries_.reserve(1024);
  if (n < 2) return;
  auto &last = entries_[n - 1], &middle = entries_[n - 2];
  const double h1 = distance - distances_[n - 2], per_h1 = 1.0 / h1;
  for (int k = 0; k < 4; ++k) last.slope[k] = (last.value[k] - middle.value[k]) * per_h1;
  if (begins(n - 2)) {
    for (int k = 0; k < 4; ++k) middle.slope[k] = last.slope[k];
  } else {  // of the parabola through three points; the middle one still holds the secant before it
    auto& first = entries_[n - 3];
    const double h0 = distances_[n - 2] - distances_[n - 3], per_both = 1.0 / (h0 + h1);
    const bool at_the_beginning = begins(n - 3);
    for (int k = 0; k < 4; ++k) {
      const double secant = middle.slope[k];
      middle.slope[k] = (secant * h1 + last.slope[k] * h0) * per_both;
      if (at_the_beginning) first.slope[k] = 2.0 * secant - middle.slope[k];
    }
  }
}

/// Entry i is the first of a smooth piece.
bool RutLog::begins(std::size_t i) const { return i == 0 || distances_[i] == distances_[i - 1]; }

void RutLog::turn() {
  const std::size_t n = entries_.size();
  if (n == 0 || begins(n - 1)) return;
  if (!begins(n - 2))  // the end of the parabola through the last three
    for (int k = 0; k < 4; ++k) entries_[n - 1].slope[k] = 2.0 * entries_[n - 1].slope[k] - entries_[n - 2].slope[k];
  distances_.push_back(distances_.back());
  entries_.push_back(entries_.back());
}

double RutLog::last_distance() const { return entries_.empty() ? -1e300 : distances_.back(); }

void RutLog::clear() {
  distances_.clear();
  entries_.clear();
}

RutLog::Between RutLog::between(double distance, std::size_t& near) const {
  static constexpr Entry nothing{};
  if (entries_.size() < 2 || distance <= distances_.front()) return {distance, distance, &nothing, nullptr};
  if (distance >= distances_.back()) return {distance, distance, &entries_.back(), nullptr};
  std::size_t i = std::min(near, entries_.size() - 2);
  while (distances_[i] > distance) --i;
  while (distances_[i + 1] <= distance) ++i;
  near = i;
  return {distances_[i], distances_[i + 1], &entries_[i], &entries_[i + 1]};
}

template <bool with_slopes>
Rut RutLog::read(double distance, std::size_t& near) const {
  const auto at = between(distance, near);
  const Entry& a = *at.before;
  if (!at.after) return {a.value[0], a.value[1], a.value[2], a.value[3]};
  const Entry& b = *at.after;
  const double h = at.to - at.from, per_h = 1.0 / h, t = (distance - at.from) * per_h, r = 1.0 - t;
  const double w0 = r * r * (1.0 + 2.0 * t), w1 = t * t * (3.0 - 2.0 * t), w2 = h * t * r * r, w3 = -h * t * t * r;
  double value[4];
  for (int k = 0; k < 4; ++k) value[k] = (a.value[k] * w0 + b.value[k] * w1) + (a.slope[k] * w2 + b.slope[k] * w3);
  if constexpr (!with_slopes) return {value[0], value[1], value[2], value[3]};
  const double s0 = -6.0 * t * r * per_h, s2 = r * (1.0 - 3.0 * t), s3 = t * (3.0 * t - 2.0);
  double slope[4];
  for (int k = 0; k < 4; ++k) slope[k] = (a.value[k] - b.value[k]) * s0 + (a.slope[k] * s2 + b.slope[k] * s3);
  return {value[0], value[1], value[2], value[3], slope[0], slope[1], slope[3]};
}

namespace {

constexpr std::size_t from_the_end = static_cast<std::size_t>(-1);  // a row reads not far behind what was written last

}  // namespace

Rut RutLog::at(double distance) const {
  std::size_t near = from_the_end;
  return read<true>(distance, near);
}
Rut RutLog::values_at(double distance) const {
  std::size_t near = from_the_end;
  return read<false>(distance, near);
}

}  // namespace apc::simulation
