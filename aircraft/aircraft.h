/// What arrives: an aircraft as data — mass, inertia, gears with struts and tires, aerodynamics, limits. SI.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "apc/base/curve.h"

namespace apc::aircraft {

/// A tire from a library file (schema "apc-tire/1").
struct Tire {
  std::string name, source;
  double diameter = 0.0, width = 0.0, rim_diameter = 0.0;                                             ///< m
  double inflation = 0.0;                                                                             ///< Pa, gauge
  double rated_load = 0.0, rated_deflection = 0.0, bottoming_load = 0.0, bottoming_deflection = 0.0;  ///< N, m
  MonotoneCurve load_curve;  ///< N over m of deflection on a hard surface, through (0, 0)
  double radius() const { return 0.5 * diameter; }
};

/// Oleo-pneumatic strut; per strut. Pressures absolute.
struct Strut {
  double stroke = 0.0;               ///< m available
  double piston_area = 0.0;          ///< m²
  double extended_pressure = 0.0;    ///< Pa, absolute, at zero stroke
  double extended_gas_volume = 0.0;  ///< m³
  double polytropic_exponent = 1.1;
  double damping_compression = 0.0, damping_rebound = 0.0;  ///< N s²/m²
  double friction = 0.0;                                    ///< N, seals
  double bearing_friction = 0.0;                            ///< coefficient on the bearing loads
  double bearing_upper = 0.0, bearing_lower = 0.0;          ///< m, extended: between bearings; lower bearing to axle
  double end_stop = 0.0;  ///< N/m beyond either end of the stroke; 0 = 1500 /m × static strut load
  double rake = 0.0;      ///< rad, axle forward of the strut's top when positive (optional key)
};

struct GearLimits {
  double drag_limit = 0.0, drag_ultimate = 0.0, vertical_limit = 0.0;  ///< N per strut; 0 = computed from the rules
};

/// A group of equal gears ("nose", "main", "wing", "body"). The nose gear is the one named "nose".
struct Gear {
  std::string name;
  double behind_nose_gear = 0.0;  ///< m, of the axle (bogie centre), static
  int struts = 1, wheels_per_axle = 2, axles = 1;
  std::string tire;
  double unsprung_mass = 0.0;  ///< kg per strut
  double wheel_inertia = 0.0;  ///< kg m² per wheel
  bool braked = false;
  double axle_spacing = 0.0, bogie_inertia = 0.0;  ///< m; kg m² per bogie (optional)
  double bogie_damping = 0.0;                      ///< N m s per bogie (optional); 0 = 20 % of critical on its tires
  bool brake_rods = true;                          ///< they hold the brakes' torque off a bogie's beam (optional)
  double track = 0.0, wheel_spacing = 0.0;         ///< m, lateral (optional)
  Strut strut;
  GearLimits limits;
  int wheels() const { return struts * wheels_per_axle * axles; }
  bool is_nose() const { return name == "nose"; }
};

struct Aerodynamics {
  double area = 0.0, CD = 0.0, CL = 0.0, CM = 0.0;  ///< CM about the CG, referred to area and 1 m
};

struct Aircraft {
  std::string name, source;
  double mass = 0.0, pitch_inertia = 0.0;             ///< kg, kg m²
  double ramp_mass = 0.0;                             ///< kg, design ramp (taxi) weight for 25.509; 0 = unknown
  double takeoff_mass = 0.0;                          ///< kg, design take-off weight for 25.493(d), (e); 0 = unknown
  double landing_mass = 0.0;                          ///< kg, design landing weight for 25.493; 0 = unknown
  double cg_behind_nose_gear = 0.0, cg_height = 0.0;  ///< m, static, level pavement
  Aerodynamics aero;
  double idle_thrust = 0.0, thrust_height = 0.0;  ///< N, m
  std::vector<Gear> gears;                        ///< nose first
  std::map<std::string, Tire> tires;              ///< the tires the gears name
};

using TireLibrary = std::map<std::string, Tire>;
TireLibrary load_tires(const std::filesystem::path&);
/// Reads schema "apc-aircraft/1" and checks that it can stand: every refusal gives the physical reason.
Aircraft load_aircraft(const std::filesystem::path&, const TireLibrary&);

}  // namespace apc::aircraft
