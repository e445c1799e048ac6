/// The units a reader sees: the field's (kt, ft, in, lbf, g) or SI. Inside the program everything stays SI; a Measure
/// says how one kind of quantity is written in either system.
#pragma once

#include <string>

namespace apc::report {

enum class UnitSystem { field, si };

/// How one kind of quantity is written: SI value / factor, with `digits` behind the point.
struct Scale {
  const char* unit;
  double factor;
  int digits;
};

/// A kind of quantity with its two scales.
struct Measure {
  Scale field, si;
  const Scale& in(UnitSystem system) const { return system == UnitSystem::field ? field : si; }
};

namespace measure {
extern const Measure speed;         ///< kt | m/s
extern const Measure distance;      ///< ft | m, along the runway
extern const Measure depth;         ///< in | mm, rut, penetration, stroke
extern const Measure force;         ///< lbf | kN
extern const Measure mass;          ///< lb | kg
extern const Measure acceleration;  ///< g | m/s²
extern const Measure angle;         ///< deg in both
extern const Measure time;          ///< s in both
extern const Measure energy;        ///< 10⁶ ft·lbf | MJ
extern const Measure pressure;      ///< psi | kPa
extern const Measure density;       ///< pcf | kg/m³
extern const Measure ratio;         ///< no unit
extern const Measure volume;        ///< cu yd | m³
}  // namespace measure

/// `value` with thousands separated by commas, without its unit; "-" when it is not finite.
std::string number(double value, int digits);
/// The value with its unit: "61.3 ft". `value` in SI.
std::string shown(double value, const Measure&, UnitSystem);
/// A share as a percentage: "97.3 %".
std::string percent(double share, int digits = 0);

}  // namespace apc::report
