#include "apc/simulation/tire_bed.h"

#include <algorithm>
#include <cmath>

namespace apc::simulation {
namespace {

TireLoad virgin(const TireBed& ground, const effects::TirePlace& place) {
  return ground.alterations ? effects::load(*ground.table, *ground.alterations, ground.facts, place)
                            : ground.table->load(place.contact);
}

/// The tire on a hard floor, deflected by `deflection`: the pavement row of the table.
TireLoad on_floor(const TireBed& ground, double speed, double deflection) {
  return ground.table->load({speed, 0.0, deflection});
}

effects::TirePlace at_penetration(effects::TirePlace place, double penetration) {
  place.contact.penetration = penetration;
  return place;
}

GroundLoad plain(const TireLoad& load, double penetration) {
  return {load, penetration, load.drag, load.vertical, {}, {}, {}, {}};
}

/// P̂ ∈ [P*, P] with F_tire(P − rut(P̂)) = c F_z(P̂): bracketed secant (the left side falls, the right side rises).
GroundLoad deepened(const TireBed& ground, const effects::TirePlace& place, const Rut& ahead) {
  const double penetration = place.contact.penetration, speed = place.contact.speed;
  const auto excess = [&](double virgin_penetration, TireLoad& load) {
    load = virgin(ground, at_penetration(place, virgin_penetration));
    const double depth = std::max(load.rut_depth, 1e-9);
    const double gain = 1.0 + (ground.following.bearing_gain - 1.0) * std::sqrt(std::min(1.0, ahead.depth / depth));
    return on_floor(ground, speed, penetration - load.rut_depth).vertical - gain * load.vertical;
  };
  TireLoad load;
  double low = std::min(ahead.penetration, penetration), high = penetration;
  double at_low = excess(low, load), at_high = excess(high, load), middle = high;
  if (at_low > 0.0 && at_high < 0.0) {
    for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
      middle = i % 3 == 2 ? 0.5 * (low + high) : (low * at_high - high * at_low) / (at_high - at_low);
      const double value = excess(middle, load);
      if (std::abs(value) < 1e-9 * (1.0 + load.vertical)) break;
      (value > 0.0 ? low : high) = middle;
      (value > 0.0 ? at_low : at_high) = value;
    }
  }
  GroundLoad result = plain(load, middle);
  result.load.vertical = on_floor(ground, speed, penetration - load.rut_depth).vertical;
  result.load.drag = std::max(0.0, load.drag - ahead.drag) + ground.following.rolling_resistance * result.load.vertical;
  return result;
}

GroundLoad follow(const TireBed& ground, const effects::TirePlace& place, const Rut& ahead) {
  GroundLoad result;
  result.virgin_penetration = ahead.penetration;
  result.virgin_drag = ahead.drag;
  result.virgin_vertical = ahead.vertical;
  result.load.rut_depth = ahead.depth;
  const double deflection = place.contact.penetration - ahead.depth;
  if (deflection <= 0.0) return result;
  const auto floor = on_floor(ground, place.contact.speed, deflection);
  if (floor.vertical > ground.following.bearing_gain * ahead.vertical) return deepened(ground, place, ahead);
  result.load.vertical = floor.vertical;
  result.load.drag = ground.following.rolling_resistance * floor.vertical;
  result.load.spin_ratio = floor.spin_ratio;
  return result;
}

/// Ruts shallower than the first count as untouched ground; from the second on they are followed; C¹ in between.
constexpr double shallowest_rut = 1e-3, plain_rut = 20e-3;  // m

bool follows(const effects::TirePlace& place, const Rut* ahead) {
  return ahead && place.contact.bed_depth > 0.0 && ahead->depth > shallowest_rut;
}

void blend(GroundLoad& result, const GroundLoad& untouched, double weight) {
  const auto mix = [weight](double& a, double b) { a = weight * a + (1.0 - weight) * b; };
  mix(result.load.drag, untouched.load.drag);
  mix(result.load.vertical, untouched.load.vertical);
  mix(result.load.rut_depth, untouched.load.rut_depth);
  mix(result.load.spin_ratio, untouched.load.spin_ratio);
  mix(result.virgin_penetration, untouched.virgin_penetration);
  mix(result.virgin_drag, untouched.virgin_drag);
  mix(result.virgin_vertical, untouched.virgin_vertical);
}

void store(GroundLoad& result, std::size_t lane, const TireLoad& up, const TireLoad& down, double width) {
  result.drag[lane] = (up.drag - down.drag) / width;
  result.vertical[lane] = (up.vertical - down.vertical) / width;
  result.rut_depth[lane] = (up.rut_depth - down.rut_depth) / width;
  result.spin_ratio[lane] = (up.spin_ratio - down.spin_ratio) / width;
}

}  // namespace

GroundLoad ground_load(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead) {
  if (!follows(place, ahead)) return plain(virgin(ground, place), place.contact.penetration);
  auto result = follow(ground, place, *ahead);
  if (ahead->depth < plain_rut) {
    const double u = (ahead->depth - shallowest_rut) / (plain_rut - shallowest_rut);
    blend(result, plain(virgin(ground, place), place.contact.penetration), u * u * (3.0 - 2.0 * u));
  }
  return result;
}

GroundLoad ground_load_with_slopes(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead) {
  const bool behind = follows(place, ahead);
  if (!behind && !ground.alterations) {
    const auto all = ground.table->load_with_slopes(place.contact);
    auto result = plain(all.load, place.contact.penetration);
    const auto lanes = [](const loadtables::Slopes& s) {
      return std::array<double, 4>{s.speed, s.bed_depth, s.penetration, 0.0};
    };
    result.drag = lanes(all.drag);
    result.vertical = lanes(all.vertical);
    result.rut_depth = lanes(all.rut_depth);
    result.spin_ratio = lanes(all.spin_ratio);
    return result;
  }
  if (!behind) {
    const auto all = effects::load_with_slopes(*ground.table, *ground.alterations, ground.facts, place);
    auto result = plain(all.load, place.contact.penetration);
    result.drag = all.drag;
    result.vertical = all.vertical;
    result.rut_depth = all.rut_depth;
    result.spin_ratio = all.spin_ratio;
    return result;
  }
  auto result = ground_load(ground, place, ahead);
  constexpr double step[4] = {1e-4, 1e-6, 1e-6, 1e-5};
  for (std::size_t lane = 0; lane < 4; ++lane) {
    auto up = place, down = place;
    Rut rut_up = behind ? *ahead : Rut{}, rut_down = rut_up;
    double* const moved[4] = {&up.contact.speed, &up.contact.bed_depth, &up.contact.penetration, &up.bed_distance};
    double* const back[4] = {&down.contact.speed, &down.contact.bed_depth, &down.contact.penetration,
                             &down.bed_distance};
    *moved[lane] += step[lane];
    *back[lane] -= step[lane];
    if (lane == 3) {
      rut_up.depth += ahead && behind ? step[lane] * ahead->depth_slope : 0.0;
      rut_down.depth -= ahead && behind ? step[lane] * ahead->depth_slope : 0.0;
    }
    store(result, lane, ground_load(ground, up, behind ? &rut_up : nullptr).load,
          ground_load(ground, down, behind ? &rut_down : nullptr).load, 2.0 * step[lane]);
  }
  return result;
}

}  // namespace apc::simulation
