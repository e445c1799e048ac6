#include "apc/cli/formats.h"

namespace apc::cli {

FormatNote describe_aircraft() {
  return {
      "apc-aircraft/1",
      "an aircraft: mass, balance, aerodynamics, gears with struts, tires and limits",
      "JSON. Lengths and heights hold for the static aircraft on level pavement at the given mass; pressures are "
      "absolute. The gear named \"nose\" is the nose gear, all others count as main gears. Strut gas force: "
      "(p_ext (V/(V - A s))^n - p_atm) A; damping force: c s'|s'|.",
      {
          {"schema", "text", "required", "names the format", "\"apc-aircraft/1\""},
          {"name", "text", "required", "how reports call it", "\"B737-800\""},
          {"source", "text", "required", "where each number comes from", "\"planning manual; inertia estimated\""},
          {"sources", "object of texts", "optional, at any level", "the source of each number beside it",
           "{\"mass\": \"design landing weight, planning manual\"}"},
          {"mass", "mass", "required", "as it overruns, unless a run gives its own", "\"65000 kg\""},
          {"ramp_mass", "mass", "optional", "design ramp mass, for the towing loads of 14 CFR 25.509", "\"79242 kg\""},
          {"takeoff_mass", "mass", "optional; the ramp mass", "design take-off mass, for 14 CFR 25.493(e)",
           "\"79016 kg\""},
          {"landing_mass", "mass", "optional", "design landing mass, for 14 CFR 25.493", "\"66361 kg\""},
          {"pitch_inertia", "moment of inertia", "required", "about the centre of gravity; scales with mass",
           "\"3.0e6 kg m^2\""},
          {"cg.behind_nose_gear", "length", "required", "of the nose axle", "\"14.8 m\""},
          {"cg.height", "length", "required", "above the pavement", "\"2.6 m\""},
          {"aero.area", "area", "required", "reference area of the coefficients", "\"124.6 m^2\""},
          {"aero.CD", "number", "required", "drag coefficient, rolling", "0.135"},
          {"aero.CL", "number", "required", "lift coefficient, rolling", "0.25"},
          {"aero.CM", "number", "required", "pitching moment, nose up, about the CG, per area and 1 m", "0.0"},
          {"idle_thrust.total", "force", "required", "of all engines, forward", "\"11.4 kN\""},
          {"idle_thrust.height", "length", "required", "of its line above the pavement", "\"1.6 m\""},
          {"gears[]", "list", "required", "groups of equal gears, nose first", ""},
          {"gears[].name", "text", "required", "\"nose\", \"main\", \"wing\", \"body\"", "\"nose\""},
          {"gears[].behind_nose_gear", "length", "required", "of the axle or bogie centre", "\"15.6 m\""},
          {"gears[].struts", "whole number", "required", "struts in the group", "2"},
          {"gears[].wheels_per_axle", "whole number", "required", "per strut", "2"},
          {"gears[].axles", "whole number", "required", "per strut; 2 is a bogie", "1"},
          {"gears[].axle_spacing", "length", "for a bogie", "between its axles", "\"1.47 m\""},
          {"gears[].bogie_inertia", "moment of inertia", "optional", "per bogie", "\"900 kg m^2\""},
          {"gears[].bogie_damping", "moment over rate of turn", "optional; 0.2 of critical on its tires",
           "of a bogie's pitch, per bogie", "\"20 kN m s\""},
          {"gears[].brake_rods", "true or false", "optional; true",
           "whether rods lead a bogie's brake torque past its beam to the strut", "false"},
          {"gears[].tire", "text", "required", "a name in the tire library (apc list tires)", "\"H27x7.7-15\""},
          {"gears[].unsprung_mass", "mass", "required", "per strut", "\"150 kg\""},
          {"gears[].wheel_inertia", "moment of inertia", "required", "per wheel", "\"1.6 kg m^2\""},
          {"gears[].braked", "true or false", "required", "whether its wheels have brakes", "false"},
          {"gears[].track", "length", "optional", "between the outermost struts", "\"5.72 m\""},
          {"gears[].wheel_spacing", "length", "optional", "between the wheels of one axle", "\"0.86 m\""},
          {"gears[].strut.stroke", "length", "required", "available", "\"0.305 m\""},
          {"gears[].strut.piston_area", "area", "required", "gas piston", "\"0.0123 m^2\""},
          {"gears[].strut.extended_pressure", "pressure", "required", "absolute, at zero stroke", "\"1.6 MPa\""},
          {"gears[].strut.extended_gas_volume", "volume", "required", "at zero stroke", "\"0.0041 m^3\""},
          {"gears[].strut.polytropic_exponent", "number", "required", "n of the gas law", "1.1"},
          {"gears[].strut.damping_compression", "square-law damping", "required", "orifice, closing",
           "\"9.0e4 N s^2/m^2\""},
          {"gears[].strut.damping_rebound", "square-law damping", "required", "orifice, opening",
           "\"2.7e5 N s^2/m^2\""},
          {"gears[].strut.friction", "force", "required", "of the seals", "\"1.5 kN\""},
          {"gears[].strut.bearing_friction", "number", "required", "coefficient on the bearing loads", "0.05"},
          {"gears[].strut.bearing_upper", "length", "required", "between the bearings, extended", "\"0.5 m\""},
          {"gears[].strut.bearing_lower", "length", "required", "lower bearing to axle, extended", "\"0.9 m\""},
          {"gears[].strut.end_stop", "stiffness", "optional; 1500 /m times the static strut load",
           "of the stops beyond either end of the stroke", "\"78 MN/m\""},
          {"gears[].strut.rake", "angle", "optional; 0", "axle forward of the strut's top", "\"4 deg\""},
          {"gears[].limits.drag_limit", "force", "optional; from 14 CFR 25.509/25.493", "per strut", "\"116.6 kN\""},
          {"gears[].limits.drag_ultimate", "force", "optional; 1.5 times the limit", "per strut", "\"174.9 kN\""},
          {"gears[].limits.vertical_limit", "force", "optional", "per strut", "\"330 kN\""},
      }};
}

FormatNote describe_tire() {
  return {"apc-tire/1",
          "tires: size, inflation and load-deflection on a hard surface",
          "JSON, a library with a list \"tires\". Without \"curve\", the load-deflection curve is the monotone cubic "
          "through zero, the rated and the bottoming point.",
          {
              {"schema", "text", "required", "names the format", "\"apc-tire/1\""},
              {"source", "text", "required", "where the numbers come from", "\"Michelin bias tire table\""},
              {"tires[].name", "text", "required", "what the gears call it", "\"H27x7.7-15\""},
              {"tires[].source", "text", "required", "of this tire", "\"Michelin, H27x7.7-15 12 PR\""},
              {"tires[].diameter", "length", "required", "inflated, unloaded", "\"27 in\""},
              {"tires[].width", "length", "required", "inflated", "\"7.7 in\""},
              {"tires[].rim_diameter", "length", "required", "", "\"15 in\""},
              {"tires[].inflation", "pressure", "required", "gauge, loaded", "\"200 psi\""},
              {"tires[].rated_load", "force", "required", "", "\"9725 lbf\""},
              {"tires[].rated_deflection", "length", "required", "under the rated load", "\"1.6 in\""},
              {"tires[].bottoming_load", "force", "required", "at which the rim is reached", "\"26300 lbf\""},
              {"tires[].bottoming_deflection", "length", "required", "under the bottoming load", "\"3.9 in\""},
              {"tires[].curve.deflection", "list of lengths", "optional", "measured points, from 0",
               "{\"unit\": \"in\", \"values\": [0, 1, 2]}"},
              {"tires[].curve.load", "list of forces", "with curve.deflection", "",
               "{\"unit\": \"lbf\", \"values\": [0, 5000, 13000]}"},
          }};
}

}  // namespace apc::cli
