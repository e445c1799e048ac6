/// For studies of measurements with unknown inputs: points that fill a box of unknowns evenly, quantiles, inverses.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace apc::testing {

/// Halton's sequence: coordinate `dimension` of point `index` (from 0), in (0, 1). The same points on every machine.
inline double halton(int index, int dimension) {
  static constexpr int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23};
  const int base = primes[dimension];
  double value = 0.0, place = 1.0;
  for (int i = index + 1; i > 0; i /= base) {
    place /= base;
    value += place * (i % base);
  }
  return value;
}

struct Range {
  double low = 0.0, high = 0.0;
  double at(double share) const { return low + share * (high - low); }
  /// For quantities whose factor, not difference, is unknown.
  double at_log(double share) const { return low * std::pow(high / low, share); }
};

/// Linear between order statistics; `share` from 0 to 1.
inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 == values.size()) return values.back();
  return values[i] + (place - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

/// Share of the values that are smaller.
inline double rank(const std::vector<double>& values, double value) {
  return static_cast<double>(std::count_if(values.begin(), values.end(), [&](double v) { return v < value; })) /
         static_cast<double>(values.size());
}

/// Root of a continuous function between two ends of different sign, by regula falsi with the Illinois weights; NaN
/// when the ends have the same sign.
inline double root(const std::function<double(double)>& function, double low, double high, double tolerance) {
  double at_low = function(low), at_high = function(high);
  if (!(at_low * at_high <= 0.0)) return std::numeric_limits<double>::quiet_NaN();
  double trial = low;
  for (int iteration = 0; iteration < 60; ++iteration) {
    trial = (low * at_high - high * at_low) / (at_high - at_low);
    const double value = function(trial);
    if (std::abs(value) < tolerance) break;
    if (value * at_high < 0.0) {
      low = high, at_low = at_high;
    } else {
      at_low *= 0.5;
    }
    high = trial, at_high = value;
  }
  return trial;
}

}  // namespace apc::testing
