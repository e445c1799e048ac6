#include "sph_backend/fem/hexahedron.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace apc::sph::fem {
namespace {

Corners distorted(unsigned seed, double by) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-by, by);
  Corners x;
  for (int i = 0; i < 3; ++i)
    for (int n = 0; n < corners; ++n) x[i][n] = 0.5 * sign[i][n] + part(random);
  return x;
}

TEST(Hexahedron, MeanGradientIsThatOfTheGaussPoints) {
  for (unsigned seed = 1; seed < 6; ++seed) {
    const Corners x = distorted(seed, 0.2);
    const Gradient mean = mean_gradient(x);
    double volume = 0.0;
    Corners sum{};
    for (int p = 0; p < corners; ++p) {
      const Gradient g = gauss_gradient(x, p);
      volume += g.volume;
      for (int i = 0; i < 3; ++i)
        for (int n = 0; n < corners; ++n) sum[i][n] += g.volume * g.b[i][n];
    }
    EXPECT_NEAR(mean.volume, volume, 1e-12);
    for (int i = 0; i < 3; ++i)
      for (int n = 0; n < corners; ++n) EXPECT_NEAR(mean.b[i][n], sum[i][n] / volume, 1e-12);
  }
}

TEST(Hexahedron, GradientsReproduceLinearFields) {
  const Corners x = distorted(3, 0.25);
  const double slope[3] = {0.7, -1.3, 2.1};
  const auto check = [&](const Gradient& g) {
    for (int i = 0; i < 3; ++i) {
      double found = 0.0;
      for (int n = 0; n < corners; ++n)
        found += (slope[0] * x[0][n] + slope[1] * x[1][n] + slope[2] * x[2][n] + 5.0) * g.b[i][n];
      EXPECT_NEAR(found, slope[i], 1e-12);
    }
  };
  check(mean_gradient(x));
  for (int p = 0; p < corners; ++p) check(gauss_gradient(x, p));
}

TEST(Hexahedron, HourglassShapesSeeNoLinearField) {
  const Corners x = distorted(4, 0.25);
  const HourglassShapes shapes = hourglass_shapes(x, mean_gradient(x));
  for (const auto& shape : shapes) {
    double constant = 0.0, linear[3] = {}, self = 0.0;
    for (int n = 0; n < corners; ++n) {
      constant += shape[n], self += shape[n] * shape[n];
      for (int i = 0; i < 3; ++i) linear[i] += shape[n] * x[i][n];
    }
    EXPECT_NEAR(constant, 0.0, 1e-12);
    for (const double l : linear) EXPECT_NEAR(l, 0.0, 1e-12);
    EXPECT_GT(self, 0.5);
  }
}

}  // namespace
}  // namespace apc::sph::fem
