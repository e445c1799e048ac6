#include "apc/effects/alterations.h"

#include <algorithm>
#include <cmath>

#include "apc/effects/balance.h"

namespace apc::effects {

double StrengthProfile::at(double bed_distance) const {
  if (log_strength.empty()) return 0.0;
  const double place = std::clamp(bed_distance / spacing, 0.0, static_cast<double>(log_strength.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), log_strength.size() - 1);
  if (i + 1 == log_strength.size()) return log_strength[i];
  const double u = place - static_cast<double>(i);
  return (1.0 - u) * log_strength[i] + u * log_strength[i + 1];
}

double Guide::speed_at(double at) const {
  const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const double place = std::clamp((at - time.front()) / interval, 0.0, static_cast<double>(time.size() - 1) - 1e-9);
  const auto i = static_cast<std::size_t>(place);
  const double u = place - static_cast<double>(i);
  return (1.0 - u) * speed[i] + u * speed[i + 1];
}

bool TableError::none() const {
  const auto zero = [](double x) { return x == 0.0; };
  return std::all_of(drag.begin(), drag.end(), zero) && std::all_of(vertical.begin(), vertical.end(), zero);
}

namespace {

std::array<double, 3> lagrange(double x, double a, double b, double c) {
  x = std::clamp(x, a, c);
  return {(x - b) * (x - c) / ((a - b) * (a - c)), (x - a) * (x - c) / ((b - a) * (b - c)),
          (x - a) * (x - b) / ((c - a) * (c - b))};
}

}  // namespace

std::array<double, 2> TableError::at(double speed, double relative_penetration) const {
  const auto u = lagrange(speed, 5.0, 17.5, 36.0), w = lagrange(relative_penetration, 0.15, 0.5, 0.9);
  std::array<double, 2> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      result[0] += u[i] * w[j] * drag[3 * i + j];
      result[1] += u[i] * w[j] * vertical[3 * i + j];
    }
  return result;
}

bool Alterations::alter_tires() const {
  if (bed_strength != 1.0 || !strength.empty() || !table_errors.empty()) return true;
  return std::any_of(effects.begin(), effects.end(), [](const Applied& a) { return a.effect.bed || a.effect.force; });
}

bool Alterations::alter_thrust() const {
  return guide || std::any_of(effects.begin(), effects.end(), [](const Applied& a) { return bool(a.effect.thrust); });
}

double Alterations::thrust(double time) const {
  double sum = 0.0;
  for (const Applied& a : effects)
    if (a.effect.thrust) sum += a.effect.thrust(time, a.values);
  return sum;
}

void alter_site(const Alterations& alterations, Site& site) {
  for (const Applied& a : alterations.effects)
    if (a.effect.site) a.effect.site(site, a.values);
}

namespace {

TireState state_at(const Alterations& alterations, const TireFacts& facts, const TirePlace& place) {
  return {place.bed_distance,
          place.nose_distance,
          place.time,
          place.contact.speed,
          place.contact.bed_depth,
          place.contact.penetration,
          0.0,
          facts.width,
          facts.radius,
          facts.density,
          alterations.conditions.years,
          alterations.conditions.temperature,
          facts.nose,
          facts.wheels};
}

/// Step 1: factors of all effects, of the bed and of the blocks.
TireChange factors(const Alterations& alterations, const TireFacts& facts, const TireState& state) {
  TireChange change;
  for (const Applied& a : alterations.effects) {
    if (!a.effect.bed) continue;
    if (!a.effect.fine) {
      a.effect.bed(state, a.values, change);
      continue;
    }
    TireState seen = state;
    seen.bed_distance = state.bed_distance * (1.0 + alterations.place_stretch) + alterations.place_shift;
    a.effect.bed(seen, a.values, change);
  }
  change.strength *= alterations.bed_strength;
  if (facts.gear < alterations.strength.size())
    change.strength *= std::exp(alterations.strength[facts.gear].at(state.bed_distance));
  change.strength = std::max(change.strength, 0.02);
  change.tire_pressure = std::max(change.tire_pressure, 0.02);
  return change;
}

/// Step 2: table error and forces, on top of the balance.
void finish(const loadtables::LoadTable& table, const Alterations& alterations, const TireFacts& facts, TireState state,
            double depth, TireLoad& load) {
  if (facts.gear < alterations.table_errors.size() && !alterations.table_errors[facts.gear].none()) {
    const double ratio = state.penetration / std::max(table.maximum_penetration(depth), 1e-6);
    const auto error = alterations.table_errors[facts.gear].at(state.speed, ratio);
    const double faded = in_bed(depth);
    load.drag *= std::exp(faded * error[0]);
    load.vertical *= std::exp(faded * error[1]);
  }
  state.vertical = load.vertical;
  TireChange change;
  for (const Applied& a : alterations.effects)
    if (a.effect.force) a.effect.force(state, a.values, change);
  load.drag += change.drag;
  load.vertical += change.vertical;
}

}  // namespace

TireLoad load(const loadtables::LoadTable& table, const Alterations& alterations, const TireFacts& facts,
              const TirePlace& place) {
  TireContact contact = place.contact;
  if (contact.penetration <= 0.0 || contact.bed_depth <= 0.0) return table.load(contact);
  const TireState state = state_at(alterations, facts, place);
  const TireChange change = factors(alterations, facts, state);
  contact.bed_depth *= change.depth;
  TireLoad result = balance(table, contact, change.strength, 1.0);
  if (change.tire_pressure != 1.0) {
    const TireLoad soft = balance(table, contact, change.strength, change.tire_pressure);
    const double share = 1.0 / facts.wheels;
    result.drag += share * (soft.drag - result.drag);
    result.vertical += share * (soft.vertical - result.vertical);
    result.rut_depth += share * (soft.rut_depth - result.rut_depth);
  }
  finish(table, alterations, facts, state, contact.bed_depth, result);
  return result;
}

AlteredLoad load_with_slopes(const loadtables::LoadTable& table, const Alterations& alterations, const TireFacts& facts,
                             const TirePlace& place) {
  TireContact contact = place.contact;
  const bool plain = contact.penetration <= 0.0 || contact.bed_depth <= 0.0;
  const TireState state = state_at(alterations, facts, place);
  const TireChange change = plain ? TireChange{} : factors(alterations, facts, state);
  contact.bed_depth *= change.depth;
  BalanceWithSlopes base = balance_with_slopes(table, contact, change.strength, 1.0);
  if (change.tire_pressure != 1.0) {
    const BalanceWithSlopes soft = balance_with_slopes(table, contact, change.strength, change.tire_pressure);
    const double share = 1.0 / facts.wheels;
    const auto blend = [share](double& x, double y) { x += share * (y - x); };
    blend(base.load.drag, soft.load.drag), blend(base.load.vertical, soft.load.vertical),
        blend(base.load.rut_depth, soft.load.rut_depth);
    for (std::size_t i = 0; i < 4; ++i)
      blend(base.drag[i], soft.drag[i]), blend(base.vertical[i], soft.vertical[i]),
          blend(base.rut_depth[i], soft.rut_depth[i]);
  }
  AlteredLoad result;
  result.load = base.load;
  if (!plain) finish(table, alterations, facts, state, contact.bed_depth, result.load);

  constexpr double step[4] = {1e-3, 1e-5, 1e-5, 1e-4};
  for (std::size_t lane = 0; lane < 4; ++lane) {
    // How the balance moves along this lane, the laws' change of strength included.
    TireState moved = state;
    double* const where[4] = {&moved.speed, &moved.bed_depth, &moved.penetration, &moved.bed_distance};
    *where[lane] += step[lane];
    if (lane == 3) moved.nose_distance += step[lane];
    const TireChange there = plain ? TireChange{} : factors(alterations, facts, moved);
    const double log_strength = (std::log(there.strength) - std::log(change.strength)) / step[lane];
    const auto slope = [&](const std::array<double, 4>& s) {
      return (lane == 3 ? 0.0 : s[lane] * (lane == 1 ? change.depth : 1.0)) + s[3] * log_strength;
    };
    TireLoad near{base.load.drag + step[lane] * slope(base.drag),
                  base.load.vertical + step[lane] * slope(base.vertical),
                  base.load.rut_depth + step[lane] * slope(base.rut_depth),
                  base.load.spin_ratio + step[lane] * slope(base.spin_ratio)};
    if (!plain) finish(table, alterations, facts, moved, moved.bed_depth * there.depth, near);
    result.drag[lane] = (near.drag - result.load.drag) / step[lane];
    result.vertical[lane] = (near.vertical - result.load.vertical) / step[lane];
    result.rut_depth[lane] = (near.rut_depth - result.load.rut_depth) / step[lane];
    result.spin_ratio[lane] = (near.spin_ratio - result.load.spin_ratio) / step[lane];
  }
  return result;
}

}  // namespace apc::effects
