#include "apc/simulation/tire_bed.h"

#include <algorithm>
#include <cmath>

namespace apc::simulation {
namespace {

TireLoad virgin(const TireBed& ground, const effects::TirePlace& place) {
  return ground.alterations ? effects::load(*ground.table, *ground.alterations, ground.facts, place)
                            : ground.table->load(place.contact);
}

effects::TirePlace at_penetration(effects::TirePlace place, double penetration) {
  place.contact.penetration = penetration;
  return place;
}

GroundLoad plain(const TireLoad& load, double penetration) {
  return {load, penetration, load.drag, load.vertical, {}, {}, {}, {}};
}

using Four = std::array<double, 4>;  ///< by speed, bed depth, penetration, distance

/// Virgin ground with all four derivatives.
effects::AlteredLoad with_slopes(const TireBed& ground, const effects::TirePlace& place) {
  if (ground.alterations) return effects::load_with_slopes(*ground.table, *ground.alterations, ground.facts, place);
  const auto all = ground.table->load_with_slopes(place.contact);
  const auto four = [](const loadtables::Slopes& s) { return Four{s.speed, s.bed_depth, s.penetration, 0.0}; };
  return {all.load, four(all.drag), four(all.vertical), four(all.rut_depth), four(all.spin_ratio)};
}

/// Virgin ground along the penetration at one place: the table's line, or altered ground at its own cost.
class Virgin {
 public:
  Virgin(const TireBed& ground, const effects::TirePlace& place)
      : ground_(ground), place_(place), line_(*ground.table, place.contact.speed, place.contact.bed_depth) {}

  loadtables::LoadAlong at(double penetration) {
    if (!ground_.alterations) return line_.at(penetration);
    const auto all = full(penetration);
    return {all.load, all.drag[2], all.vertical[2], all.rut_depth[2], all.spin_ratio[2]};
  }
  effects::AlteredLoad full(double penetration) const {
    return with_slopes(ground_, at_penetration(place_, penetration));
  }

 private:
  const TireBed& ground_;
  const effects::TirePlace& place_;
  loadtables::PenetrationLine line_;
};

/// Load and spin ratio of the tire on a hard floor, with their slopes.
struct OnFloor {
  double load, slope, spin_ratio, spin_slope;
};
OnFloor on_floor(const TireBed& ground, double deflection) {
  const auto floor = ground.table->load_on_pavement(deflection);
  return {floor.load.vertical, floor.vertical, floor.load.spin_ratio, floor.spin_ratio};
}

/// c and its derivative by D.
struct Bearing {
  double gain, slope;
};
Bearing bearing(const TireBed& ground, double old_depth, double depth) {
  const double more = ground.following.bearing_gain - 1.0;
  if (depth <= old_depth) return {1.0 + more, 0.0};
  const double root = std::sqrt(old_depth / depth);
  return {1.0 + more * root, -0.5 * more * root / depth};
}

/// Solution P̂ of a yielding floor, and all that was needed to find it.
struct Yield {
  double penetration = 0.0, depth = 0.0, virgin = 0.0;  ///< P̂, D, V
  loadtables::LoadAlong from, to;                       ///< virgin loads at P* and P̂
  OnFloor floor{};
  Bearing bearing{};
};

/// F_tire(P − D) − c V falls with P̂ and changes its sign before D reaches P: Newton steps, halving the bracket where
/// one leaves it.
Yield yield(const TireBed& ground, double penetration, const Rut& ahead, Virgin& virgin) {
  Yield at;
  at.from = virgin.at(ahead.penetration);
  double low = ahead.penetration, high = 1e3;
  at.penetration = low;
  for (int i = 0; i < 60; ++i) {
    at.to = i == 0 ? at.from : virgin.at(at.penetration);
    at.depth = ahead.depth + (at.to.load.rut_depth - at.from.load.rut_depth);
    at.virgin = ahead.vertical + (at.to.load.vertical - at.from.load.vertical);
    at.floor = on_floor(ground, penetration - at.depth);
    at.bearing = bearing(ground, ahead.depth, at.depth);
    const double excess = at.floor.load - at.bearing.gain * at.virgin;
    const double slope =
        -at.to.rut_depth * (at.floor.slope + at.bearing.slope * at.virgin) - at.bearing.gain * at.to.vertical;
    (excess > 0.0 ? low : high) = at.penetration;
    double next = at.penetration - excess / slope;
    const double change = std::abs(next - at.penetration);
    if (change < 1e-14) break;
    if (!(next > low && next < high)) next = 0.5 * (low + std::min(high, low + 1.0));
    at.penetration = next;
  }
  return at;
}

GroundLoad yielded(const TireBed& ground, const Yield& at) {
  GroundLoad result;
  result.virgin_penetration = at.penetration;
  result.virgin_drag = at.to.load.drag;
  result.virgin_vertical = at.virgin;
  result.load.vertical = at.floor.load;
  result.load.drag =
      std::max(0.0, at.to.load.drag - at.from.load.drag) + ground.following.rolling_resistance * at.floor.load;
  result.load.rut_depth = at.depth;
  result.load.spin_ratio = at.floor.spin_ratio + (at.to.load.spin_ratio - at.from.load.spin_ratio);
  return result;
}

/// Derivatives of a yielding floor: the balance G(P̂; v, h, P, x) = 0 is differentiated implicitly.
void add_slopes(const TireBed& ground, const Rut& ahead, const Virgin& virgin, const Yield& at, GroundLoad& result) {
  const auto from = virgin.full(ahead.penetration), to = virgin.full(at.penetration);
  const bool paid = at.to.load.drag > at.from.load.drag;
  const double by_depth = -(at.floor.slope + at.bearing.slope * at.virgin);  // ∂G/∂D
  const double by_solution = by_depth * at.to.rut_depth - at.bearing.gain * at.to.vertical;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    // At fixed P̂: how D, V and F_x(P̂) − F_x(P*) move; P* and the log move with the distance.
    double depth = 0.0, load = 0.0, drag = 0.0, spin = 0.0, explicitly = lane == 2 ? at.floor.slope : 0.0;
    if (lane != 2) {
      depth = to.rut_depth[lane] - from.rut_depth[lane];
      load = to.vertical[lane] - from.vertical[lane];
      drag = to.drag[lane] - from.drag[lane];
      spin = to.spin_ratio[lane] - from.spin_ratio[lane];
    }
    if (lane == 3) {
      depth += ahead.depth_slope - from.rut_depth[2] * ahead.penetration_slope;
      load += ahead.vertical_slope - from.vertical[2] * ahead.penetration_slope;
      drag -= from.drag[2] * ahead.penetration_slope;
      spin -= from.spin_ratio[2] * ahead.penetration_slope;
      if (at.depth > ahead.depth)  // c by D₀
        explicitly -= at.virgin * 0.5 * (at.bearing.gain - 1.0) / ahead.depth * ahead.depth_slope;
    }
    const double moved = -(explicitly + by_depth * depth - at.bearing.gain * load) / by_solution;  // dP̂
    const double settled = depth + at.to.rut_depth * moved;
    result.rut_depth[lane] = settled;
    result.vertical[lane] = at.floor.slope * ((lane == 2 ? 1.0 : 0.0) - settled);
    result.drag[lane] =
        (paid ? drag + at.to.drag * moved : 0.0) + ground.following.rolling_resistance * result.vertical[lane];
    result.spin_ratio[lane] =
        spin + at.to.spin_ratio * moved + at.floor.spin_slope * ((lane == 2 ? 1.0 : 0.0) - settled);
  }
}

enum class Slopes { no, yes };

GroundLoad follow(const TireBed& ground, const effects::TirePlace& place, const Rut& ahead, Slopes slopes) {
  GroundLoad result;
  result.virgin_penetration = ahead.penetration;
  result.virgin_drag = ahead.drag;
  result.virgin_vertical = ahead.vertical;
  result.load.rut_depth = ahead.depth;
  result.rut_depth[3] = ahead.depth_slope;
  const double deflection = place.contact.penetration - ahead.depth;
  if (deflection <= 0.0) return result;
  const auto floor = ground.table->load_on_pavement(deflection);
  if (floor.load.vertical > ground.following.bearing_gain * ahead.vertical) {
    Virgin virgin(ground, place);
    const auto at = yield(ground, place.contact.penetration, ahead, virgin);
    result = yielded(ground, at);
    if (slopes == Slopes::yes) add_slopes(ground, ahead, virgin, at, result);
    return result;
  }
  const double friction = ground.following.rolling_resistance;
  result.load.vertical = floor.load.vertical;
  result.load.drag = friction * floor.load.vertical;
  result.load.spin_ratio = floor.load.spin_ratio;
  result.vertical = {0.0, 0.0, floor.vertical, -floor.vertical * ahead.depth_slope};
  result.drag = {0.0, 0.0, friction * floor.vertical, -friction * floor.vertical * ahead.depth_slope};
  result.spin_ratio = {0.0, 0.0, floor.spin_ratio, -floor.spin_ratio * ahead.depth_slope};
  return result;
}

GroundLoad untouched(const TireBed& ground, const effects::TirePlace& place, Slopes slopes) {
  if (slopes == Slopes::no) return plain(virgin(ground, place), place.contact.penetration);
  const auto all = with_slopes(ground, place);
  auto result = plain(all.load, place.contact.penetration);
  result.drag = all.drag;
  result.vertical = all.vertical;
  result.rut_depth = all.rut_depth;
  result.spin_ratio = all.spin_ratio;
  return result;
}

bool follows(const effects::TirePlace& place, const Rut* ahead) {
  return ahead && place.contact.bed_depth > 0.0 && ahead->depth > shallowest_rut;
}

/// `weight` × followed + (1 − weight) × untouched; `by_distance` is the weight's own slope.
void blend(GroundLoad& result, const GroundLoad& untouched, double weight, double by_distance) {
  const auto mix = [weight](double& a, double b) { a = weight * a + (1.0 - weight) * b; };
  const auto mix_slopes = [&](Four& a, const Four& b, double followed, double virgin_value) {
    for (std::size_t lane = 0; lane < 4; ++lane) mix(a[lane], b[lane]);
    a[3] += by_distance * (followed - virgin_value);
  };
  const auto &f = result.load, &u = untouched.load;
  mix_slopes(result.drag, untouched.drag, f.drag, u.drag);
  mix_slopes(result.vertical, untouched.vertical, f.vertical, u.vertical);
  mix_slopes(result.rut_depth, untouched.rut_depth, f.rut_depth, u.rut_depth);
  mix_slopes(result.spin_ratio, untouched.spin_ratio, f.spin_ratio, u.spin_ratio);
  mix(result.load.drag, untouched.load.drag);
  mix(result.load.vertical, untouched.load.vertical);
  mix(result.load.rut_depth, untouched.load.rut_depth);
  mix(result.load.spin_ratio, untouched.load.spin_ratio);
  mix(result.virgin_penetration, untouched.virgin_penetration);
  mix(result.virgin_drag, untouched.virgin_drag);
  mix(result.virgin_vertical, untouched.virgin_vertical);
}

GroundLoad any_load(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead, Slopes slopes) {
  if (!follows(place, ahead)) return untouched(ground, place, slopes);
  auto result = follow(ground, place, *ahead, slopes);
  if (ahead->depth < plain_rut) {
    constexpr double per_width = 1.0 / (plain_rut - shallowest_rut);
    const double u = (ahead->depth - shallowest_rut) * per_width;
    blend(result, untouched(ground, place, slopes), u * u * (3.0 - 2.0 * u),
          6.0 * u * (1.0 - u) * per_width * ahead->depth_slope);
  }
  return result;
}

}  // namespace

GroundLoad ground_load(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead) {
  return any_load(ground, place, ahead, Slopes::no);
}

GroundLoad ground_load_with_slopes(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead) {
  return any_load(ground, place, ahead, Slopes::yes);
}

}  // namespace apc::simulation
