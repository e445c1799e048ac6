#include "apc/learning/entry_speed.h"

#include <cmath>

#include "apc/learning/layout.h"

namespace apc::learning {

std::optional<EntrySpeed> entry_speed_of_signal(const Run& run) {
  constexpr double since = -2.0;  // s
  constexpr double fewest = 5.0;
  const Channel* speed = run.find(Quantity::speed);
  if (!speed) return std::nullopt;
  double n = 0.0, t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
  for (std::size_t i = 0; i < speed->time.size() && speed->time[i] <= 0.0; ++i) {
    const double when = speed->time[i], value = speed->value[i];
    if (when < since) continue;
    n += 1.0, t += when, v += value, tt += when * when, tv += when * value;
  }
  const double determinant = n * tt - t * t;
  if (n < fewest || determinant <= 0.0) return std::nullopt;
  const double slope = (n * tv - t * v) / determinant, level = (tt * v - t * tv) / determinant;
  const double entry = level + slope * mean_lag * speed->lag;
  const double drawn = speed->noise * std::sqrt(tt / determinant);  // of the level of the line
  return EntrySpeed{entry, std::hypot(drawn, speed->bias, speed->scale * entry)};
}

EntrySpeed entry_speed(const Run& run) {
  const EntrySpeed recorded{run.overrun.entry_speed, run.uncertainty.entry_speed};
  const auto signal = entry_speed_of_signal(run);
  if (!signal || signal->deviation <= 0.0 || recorded.deviation <= 0.0) return recorded;
  constexpr double contradicts = 4.0;
  if (std::abs(signal->value - recorded.value) > contradicts * std::hypot(signal->deviation, recorded.deviation))
    return recorded;
  const double a = 1.0 / (signal->deviation * signal->deviation), b = 1.0 / (recorded.deviation * recorded.deviation);
  return {(a * signal->value + b * recorded.value) / (a + b), 1.0 / std::sqrt(a + b)};
}

}  // namespace apc::learning
