/// A made-up overrun for tests of the reports: a smooth stop with a nose and a main gear. Its numbers mean nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apc/report/record.h"

namespace apc::report::synthetic {

inline simulation::GearSummary gear(const std::string& name, double peak_drag, double drag_limit, int struts) {
  simulation::GearSummary out;
  out.name = name;
  out.struts = struts;
  out.peak_drag = peak_drag;
  out.peak_drag_distance = 31.0;
  out.peak_vertical = 2.2 * peak_drag;
  out.peak_vertical_distance = 24.0;
  out.mean_drag = 0.7 * peak_drag;
  out.drag_limit = drag_limit;
  out.drag_ultimate = 1.5 * drag_limit;
  out.vertical_limit = 3.0 * drag_limit;
  out.drag_rule = "14 CFR 25.509 from ramp weight";
  out.vertical_rule = "aircraft file";
  out.drag_margin = drag_limit / peak_drag - 1.0;
  out.ultimate_margin = 1.5 * drag_limit / peak_drag - 1.0;
  out.vertical_margin = out.vertical_limit / out.peak_vertical - 1.0;
  out.peak_stroke = 0.27;
  out.stroke = 0.305;
  out.peak_rut = 0.31;
  out.peak_penetration = 0.36;
  out.static_vertical = 0.8 * peak_drag;
  return out;
}

inline bed::Bed flat_bed() {
  bed::Bed bed;
  bed.name = "18 in, 400 ft <test>";
  bed.source = "invented for a test";
  bed.material = "foam_50psi";
  bed.setback = 15.24;
  bed.width = 45.72;
  bed.distance = {0.0, 15.24, 121.92};
  bed.depth = {0.0, 0.4572, 0.4572};
  return bed;
}

inline aircraft::Aircraft twin() {
  aircraft::Aircraft plane;
  plane.name = "Testjet-200";
  plane.source = "invented for a test";
  plane.mass = 66000.0;
  plane.cg_behind_nose_gear = 14.8;
  plane.cg_height = 2.6;
  aircraft::Gear nose, main;
  nose.name = "nose";
  nose.tire = "N27";
  main.name = "main";
  main.tire = "M44";
  main.behind_nose_gear = 15.6;
  main.struts = 2;
  plane.gears = {nose, main};
  plane.tires["N27"].diameter = 0.69;
  plane.tires["M44"].diameter = 1.13;
  return plane;
}

/// x(t) with a constant deceleration and a little pitching; loads ramp up over the bed's first 15 m.
inline simulation::History history(const bed::Bed& bed, double speed, double deceleration) {
  simulation::History out;
  out.gears.resize(2);
  const double stop = speed / deceleration;
  for (double t = -0.4; t < stop + 0.3; t += 0.005) {
    const double in = std::clamp(t, 0.0, stop);
    const double x = (t < 0 ? speed * t : 0.0) + speed * in - 0.5 * deceleration * in * in;
    const double ramp = std::clamp(x / 15.24, 0.0, 1.0), swing = std::exp(-0.8 * in) * std::sin(6.0 * in);
    out.time.push_back(t);
    out.distance.push_back(x);
    out.speed.push_back(speed - deceleration * in);
    out.deceleration.push_back(t > 0 && t < stop ? deceleration * ramp * (1.0 + 0.2 * swing) : 0.0);
    out.pitch.push_back(-0.02 * ramp * (1.0 + swing));
    out.heave.push_back(-0.3 * ramp);
    out.dissipated.push_back(0.5 * 66000.0 * (speed * speed - std::pow(speed - deceleration * in, 2)));
    for (std::size_t i = 0; i < 2; ++i) {
      auto& gear = out.gears[i];
      const double at = x - (i ? 15.6 : 0.0), depth = bed.depth_at(at);
      gear.distance.push_back(at);
      gear.bed_depth.push_back(depth);
      gear.drag.push_back((i ? 260e3 : 98e3) * depth / 0.4572 * (1.0 + 0.15 * swing));
      gear.vertical.push_back((i ? 560e3 : 150e3) * (0.8 + 0.2 * ramp * (1.0 + swing)));
      gear.stroke.push_back((i ? 0.22 : 0.2) + 0.06 * ramp * swing);
      gear.stroke_rate.push_back(0.0);
      gear.penetration.push_back(0.78 * depth + (i ? 0.06 : 0.04));
      gear.rut.push_back(0.78 * depth);
      gear.spin.push_back(0.0);
    }
  }
  return out;
}

inline OverrunRecord record() {
  OverrunRecord out;
  out.model.bed = flat_bed();
  out.model.aircraft = twin();
  out.overrun.entry_speed = 36.011;
  auto& result = out.result;
  result.entry_speed = 36.011;
  result.mass = 66000.0;
  result.cg_behind_nose_gear = 14.8;
  result.history = history(out.model.bed, 36.011, 7.6);
  result.stop_distance = result.history.distance.back();
  result.runway_distance = result.stop_distance + out.model.bed.setback;
  result.stop_time = 36.011 / 7.6;
  result.message = "The aircraft stopped in the bed.";
  result.peak_deceleration = 8.4;
  result.peak_deceleration_100ms = 8.2;
  result.mean_deceleration = 7.6;
  result.peak_pitch = 0.002;
  result.lowest_pitch = -0.03;
  result.gears = {gear("nose", 108e3, 116.6e3, 1), gear("main", 142e3, 260e3, 2)};
  result.coverage = {{"nose", "N27", 0.93, 0.07, 0.0, 0.0}, {"main", "M44", 0.91, 0.06, 0.0, 0.03}};
  result.energy = {{"bed", 35.1e6},         {"kinetic", 42.8e6},       {"kinetic_left", 0.0}, {"potential", -0.6e6},
                   {"oleo_damping", 1.9e6}, {"strut_friction", 0.5e6}, {"brakes", 4.0e6},     {"aero", 1.3e6},
                   {"oleo_gas", 0.2e6},     {"tires", 0.4e6},          {"residual", 3.4e-9}};
  result.warnings = {"nose: 7.0 % of the time in the bed was slower than the load table's range (10 kt)"};
  result.solver = {"CVODE BDF", 812, 1203, 61, 14, 2, 0.021, 1e-6};
  out.manifest = {"apc 0.1.0",
                  "apc simulate --aircraft Testjet-200 --bed test --speed \"70 kt\"",
                  "2020-01-01 00:00 UTC",
                  {{"aircraft", "aircraft/data/Testjet-200.json", std::string(64, 'a'), "invented for a test"},
                   {"bed", "designs/beds/test.json", std::string(64, 'b'), "invented for a test"}}};
  return out;
}

}  // namespace apc::report::synthetic
