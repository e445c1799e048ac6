#include "apc/learning/shapes.h"

#include <algorithm>
#include <cmath>

namespace apc::learning {

using effects::Applied;
using effects::Effect;

double amplitude_deviation(const effects::Parameter& p) {
  return std::max(std::abs(p.high - p.neutral), p.low < p.neutral ? std::abs(p.low - p.neutral) : 0.0) / 1.96;
}

bool amplitude_positive(const effects::Parameter& p) { return p.low >= p.neutral; }

std::vector<Applied> shapes_of(const Effect& effect, double longest) {
  std::vector<Applied> result;
  const Applied neutral = effects::applied(effect, effect.parameters.front().neutral);
  const auto with = [&](std::size_t parameter, double value) {
    Applied one = neutral;
    one.values[parameter] = value;
    result.push_back(one);
  };
  if (!effect.shapes.empty()) {
    for (const auto& shape : effect.shapes) {
      Applied one = neutral;
      std::copy(shape.begin(), shape.end(), one.values.begin() + 1);
      result.push_back(std::move(one));
    }
    return result;
  }
  if (effect.id == "tire_loss") {
    for (double at = 5.0; at < longest - 5.0; at += 5.0) with(1, at);
    return result;
  }
  if (effect.parameters.size() == 1 || effect.id == "inertial" || effect.id == "rate" || effect.id == "aero" ||
      effect.id == "depth_as_built")
    return {neutral};
  // Shapes the catalogue leaves open: five values over the range of the second parameter, evenly in the logarithm
  // where it is positive.
  const effects::Parameter& p = effect.parameters[1];
  for (int i = 0; i < 5; ++i) {
    const double u = (i + 0.5) / 5.0;
    with(1, p.low > 0.0 ? p.low * std::pow(p.high / p.low, u) : p.low + u * (p.high - p.low));
  }
  return result;
}

}  // namespace apc::learning
