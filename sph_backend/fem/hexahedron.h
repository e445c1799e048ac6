/// The 8-node hexahedron: shape functions N_I = ⅛ (1 + ξ_I ξ)(1 + η_I η)(1 + ζ_I ζ), nodes 1–4 around the lower face,
/// 5–8 above them.
///
///   mean gradient  B_iI = ∂V/∂x_iI, V = ⅓ x_iI B_iI; exact for any shape, so the one-point element passes the patch
///   test hourglass      γ_αI = (h_αI − x_iJ h_αJ b_iI)/√8 with b = B/V: orthogonal to every linear velocity field
/// Source: Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679–706.
#pragma once

#include <array>

namespace apc::sph::fem {

inline constexpr int corners = 8, modes = 4;

/// One vector per corner: [i][I].
using Corners = std::array<std::array<double, corners>, 3>;

/// Signs of ξ, η, ζ at the corners.
inline constexpr int sign[3][corners] = {
    {-1, 1, 1, -1, -1, 1, 1, -1}, {-1, -1, 1, 1, -1, -1, 1, 1}, {-1, -1, -1, -1, 1, 1, 1, 1}};

struct Gradient {
  Corners b;      ///< ∂N_I/∂x_i, or its mean over the volume, 1/m
  double volume;  ///< m³; of the whole element, or det ∂x/∂ξ at a point
};
/// Mean over the element (one-point integration).
Gradient mean_gradient(const Corners& x);
/// At one of the eight Gauss points (weight 1 each), numbered like the corners.
Gradient gauss_gradient(const Corners& x, int point);

using HourglassShapes = std::array<std::array<double, corners>, modes>;
HourglassShapes hourglass_shapes(const Corners& x, const Gradient& mean);

}  // namespace apc::sph::fem
