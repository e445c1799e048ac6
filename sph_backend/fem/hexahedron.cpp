#include "sph_backend/fem/hexahedron.h"

#include <cmath>

namespace apc::sph::fem {
namespace {

/// Which node plays the part of node J in the formula of node I (Flanagan and Belytschko, appendix), from 0.
constexpr int part[corners][corners] = {{0, 1, 2, 3, 4, 5, 6, 7}, {1, 2, 3, 0, 5, 6, 7, 4}, {2, 3, 0, 1, 6, 7, 4, 5},
                                        {3, 0, 1, 2, 7, 4, 5, 6}, {4, 7, 6, 5, 0, 3, 2, 1}, {5, 4, 7, 6, 1, 0, 3, 2},
                                        {6, 5, 4, 7, 2, 1, 0, 3}, {7, 6, 5, 4, 3, 2, 1, 0}};

/// The four hourglass vectors: products of two or three of ξ, η, ζ.
constexpr int mode(int alpha, int corner) {
  const int a = sign[0][corner], b = sign[1][corner], c = sign[2][corner];
  return alpha == 0 ? b * c : alpha == 1 ? c * a : alpha == 2 ? a * b : a * b * c;
}

}  // namespace

Gradient mean_gradient(const Corners& x) {
  Gradient g;
  double volume = 0.0;
  for (int i = 0; i < 3; ++i) {
    const auto& y = x[(i + 1) % 3];
    const auto& z = x[(i + 2) % 3];
    for (int n = 0; n < corners; ++n) {
      const int* p = part[n];
      g.b[i][n] = (y[p[1]] * ((z[p[5]] - z[p[2]]) - (z[p[3]] - z[p[4]])) + y[p[2]] * (z[p[1]] - z[p[3]]) +
                   y[p[3]] * ((z[p[2]] - z[p[7]]) - (z[p[4]] - z[p[1]])) +
                   y[p[4]] * ((z[p[7]] - z[p[5]]) - (z[p[1]] - z[p[3]])) + y[p[5]] * (z[p[4]] - z[p[1]]) +
                   y[p[7]] * (z[p[3]] - z[p[4]])) /
                  12.0;
      volume += x[i][n] * g.b[i][n];
    }
  }
  g.volume = volume / 3.0;
  const double inverse = 1.0 / g.volume;
  for (auto& row : g.b)
    for (double& value : row) value *= inverse;
  return g;
}

Gradient gauss_gradient(const Corners& x, int point) {
  const double place = 1.0 / std::sqrt(3.0);
  const double xi[3] = {place * sign[0][point], place * sign[1][point], place * sign[2][point]};
  double local[3][corners];  // ∂N/∂ξ_k
  for (int n = 0; n < corners; ++n) {
    const double f[3] = {1.0 + sign[0][n] * xi[0], 1.0 + sign[1][n] * xi[1], 1.0 + sign[2][n] * xi[2]};
    local[0][n] = 0.125 * sign[0][n] * f[1] * f[2];
    local[1][n] = 0.125 * sign[1][n] * f[0] * f[2];
    local[2][n] = 0.125 * sign[2][n] * f[0] * f[1];
  }
  double j[3][3] = {};  // ∂x_i/∂ξ_k
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int n = 0; n < corners; ++n) j[i][k] += x[i][n] * local[k][n];
  double cofactor[3][3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      cofactor[i][k] = j[(i + 1) % 3][(k + 1) % 3] * j[(i + 2) % 3][(k + 2) % 3] -
                       j[(i + 1) % 3][(k + 2) % 3] * j[(i + 2) % 3][(k + 1) % 3];
  Gradient g;
  g.volume = j[0][0] * cofactor[0][0] + j[0][1] * cofactor[0][1] + j[0][2] * cofactor[0][2];
  for (int i = 0; i < 3; ++i)
    for (int n = 0; n < corners; ++n)
      g.b[i][n] =
          (cofactor[i][0] * local[0][n] + cofactor[i][1] * local[1][n] + cofactor[i][2] * local[2][n]) / g.volume;
  return g;
}

HourglassShapes hourglass_shapes(const Corners& x, const Gradient& mean) {
  HourglassShapes shapes;
  for (int a = 0; a < modes; ++a) {
    double along[3] = {};
    for (int i = 0; i < 3; ++i)
      for (int n = 0; n < corners; ++n) along[i] += x[i][n] * mode(a, n);
    for (int n = 0; n < corners; ++n)
      shapes[a][n] =
          (mode(a, n) - along[0] * mean.b[0][n] - along[1] * mean.b[1][n] - along[2] * mean.b[2][n]) / std::sqrt(8.0);
  }
  return shapes;
}

}  // namespace apc::sph::fem
