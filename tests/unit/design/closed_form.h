/// A stop that can be written down: deceleration a = a₀ + k h(x) and nose drag q h(x) over the depth h of the bed, so
/// that a₀ x + k ∫h dx = v²/2 at rest. Stands in for the simulation where a design or a study itself is tested.
#pragma once

#include <algorithm>
#include <cmath>

#include "apc/simulation/simulate.h"

namespace apc::closed_form {

inline constexpr double base = 0.5;        // a₀, m/s²
inline constexpr double per_depth = 20.0;  // k at 50 t, 1/s²
inline constexpr double nose_drag = 3e5;   // q, N/m

/// An aircraft whose nose gear may take the drag of `limit_depth` of bed.
inline simulation::Model model(double mass, double limit_depth) {
  simulation::Model out;
  out.aircraft.name = "test";
  out.aircraft.mass = mass;
  out.aircraft.pitch_inertia = 1e6;
  out.aircraft.cg_behind_nose_gear = 10.0;
  aircraft::Gear nose, main;
  nose.name = "nose", main.name = "main", main.behind_nose_gear = 12.0;
  nose.limits.drag_limit = nose_drag * limit_depth;
  out.aircraft.gears = {nose, main};
  out.bed.name = "test";
  out.bed.distance = {0.0, 100.0};
  out.bed.depth = {0.4, 0.4};
  out.bed.width = 45.0;
  return out;
}

inline double section(const bed::Bed& bed, double x) {
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < bed.distance.size() && bed.distance[i] < x; ++i) {
    const double to = std::min(x, bed.distance[i + 1]);
    area += 0.5 * (bed.depth_at(bed.distance[i]) + bed.depth_at(to)) * (to - bed.distance[i]);
  }
  return area;
}

inline simulation::Result solve(const simulation::Model& model, const simulation::Overrun& run,
                                const simulation::Options& options) {
  const double mass = run.mass > 0 ? run.mass : model.aircraft.mass;
  const double k = per_depth * 5e4 / mass * run.alterations.bed_strength * run.bed_depth;
  const double a = base + 9.80665 * run.braking;
  const double energy = 0.5 * run.entry_speed * run.entry_speed;
  const auto spent = [&](double x) { return a * x + k * section(model.bed, x); };
  simulation::Result out;
  out.entry_speed = run.entry_speed, out.mass = mass;
  const double length = model.bed.length();
  double low = 0.0, high = length;
  if (spent(length) < energy) {
    out.outcome = simulation::Outcome::left_bed;
    out.stop_distance = std::nan("");
    out.exit_speed = std::sqrt(2 * (energy - spent(length)));
    low = length;
  } else {
    for (int i = 0; i < 60; ++i) (spent(0.5 * (low + high)) < energy ? low : high) = 0.5 * (low + high);
    out.stop_distance = low;
  }
  out.runway_distance = out.stop_distance + model.bed.setback;
  double deepest = 0.0;
  std::vector<double> places{0.0, low};
  for (const double at : model.bed.distance)  // corners, twice, so that nobody takes one for a smooth peak
    if (at < low) places.push_back(at), places.push_back(at);
  for (double at = 0.0; at < low; at += 0.5) places.push_back(at);
  std::sort(places.begin(), places.end());
  for (const double at : places) deepest = std::max(deepest, model.bed.depth_at(at));
  if (options.sampling > 0) out.history.distance = places;
  for (const auto& gear : model.aircraft.gears) {
    simulation::GearSummary summary;
    summary.name = gear.name;
    summary.drag_limit = gear.limits.drag_limit, summary.drag_ultimate = 1.5 * gear.limits.drag_limit;
    if (gear.is_nose()) summary.peak_drag = nose_drag * deepest * run.alterations.bed_strength;
    out.gears.push_back(summary);
    if (options.sampling <= 0) continue;
    simulation::History::Gear history;
    for (const double at : places) {
      history.distance.push_back(at);
      history.drag.push_back(gear.is_nose() ? nose_drag * model.bed.depth_at(at) : 0.0);
    }
    out.history.gears.push_back(history);
  }
  out.peak_deceleration = a + k * deepest;
  return out;
}

}  // namespace apc::closed_form
