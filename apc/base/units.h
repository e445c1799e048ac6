/// Unit factors: one SI unit is 1. Multiply on the way in (`70 * units::kt`), divide on the way out (`drag /
/// units::lbf`). Exact by definition: inch, foot, nautical mile, avoirdupois pound, standard gravity; the rest follow
/// from them.
#pragma once

#include <numbers>

namespace apc::units {

inline constexpr double m = 1.0, kg = 1.0, s = 1.0, N = 1.0, Pa = 1.0, J = 1.0, rad = 1.0;
inline constexpr double mm = 1e-3, cm = 1e-2, km = 1e3;
inline constexpr double in = 0.0254, ft = 12.0 * in, nmi = 1852.0;
inline constexpr double ms = 1e-3, min = 60.0, hour = 3600.0, day = 86400.0, year = 365.25 * day;
inline constexpr double g0 = 9.80665;  ///< standard gravity, m/s²
inline constexpr double t = 1e3, lb = 0.45359237;
inline constexpr double kN = 1e3, MN = 1e6, lbf = lb * g0, kip = 1e3 * lbf;
inline constexpr double kPa = 1e3, MPa = 1e6, psi = lbf / (in * in), psf = lbf / (ft * ft);
inline constexpr double kt = nmi / hour, mph = 5280.0 * ft / hour, km_h = km / hour;
inline constexpr double deg = std::numbers::pi / 180.0, rpm = 2.0 * std::numbers::pi / 60.0;
inline constexpr double pcf = lb / (ft * ft * ft);
inline constexpr double kJ = 1e3, MJ = 1e6;

}  // namespace apc::units
