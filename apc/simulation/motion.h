/// Body of equations.h. Rows and struts are laws over the number type: double for the right-hand side, a Dual of the
/// few numbers they depend on for their derivatives, which motion_slopes.h spreads over the state by the chain rule.
/// `V`, the number of the motion itself, is a double or several runs side by side (lanes.h); plant, surroundings and
/// moment then hold numbers side by side under the same names (plant_lanes.h).
#pragma once

#include <cmath>
#include <type_traits>

#include "aircraft/strut.h"
#include "apc/simulation/row_ground.h"

namespace apc::simulation {

template <class T>
struct Pair {
  T x, z;
};
template <class T>
Pair<T> operator+(const Pair<T>& a, const Pair<T>& b) {
  return {a.x + b.x, a.z + b.z};
}
template <class T>
Pair<T> operator*(const T& s, const Pair<T>& a) {
  return {s * a.x, s * a.z};
}
template <class T>
T dot(const Pair<T>& a, const Pair<T>& b) {
  return a.x * b.x + a.z * b.z;
}
template <class T>
Pair<T> perpendicular(const Pair<T>& a) {
  return {-a.z, a.x};
}

/// What sinking adds to the load of the steady table (`Sinking`). Slow tires are pressed, not rolled: it fades below 1
/// m/s.
template <class T>
void sink(const Sinking& law, const T& base_slope, double radius, const T& penetration, const T& speed, const T& climb,
          GroundNumbers<T>& ground) {
  using std::sqrt;
  constexpr double steepest = 0.6, shallowest = 0.06;  // of α/sin θ; of sin²θ
  const T incline = -1.0 * base_slope - climb * speed * (1.0 / (speed * speed + 1.0));
  const T depth = value_of(penetration) < radius ? penetration : T(radius);
  const T arc = sqrt(depth * (2.0 * radius - depth) * (1.0 / (radius * radius)) + shallowest);
  const T angle = steepest * quick_tanh(incline / arc * (1.0 / steepest));
  ground.drag = ground.drag + law.drag * angle * arc * ground.vertical;
  ground.vertical = ground.vertical * (1.0 + law.vertical * angle);
}

/// Forces of one row on its axle and the rate of its spin.
template <class T>
struct RowForce {
  Pair<T> force;
  T brake_torque, spin_rate;
};

template <class T, class P, class A, class V, class Seen>
RowForce<T> row_force(const P& plant, const A& around, int index, const V& time, const V& nose, const Pair<T>& axle,
                      const Pair<T>& velocity, const T& spin, Seen* seen) {
  using std::sqrt;
  const auto& row = plant.rows[static_cast<std::size_t>(index)];
  const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
  const auto inside = around.in_bed[static_cast<std::size_t>(index)];
  const V radius = group.tire_radius, x = value_of(axle.x);

  const auto under = ground_under(plant, around, index, x, 0.5 * radius);
  const auto& profile = under.depth;
  const T depth = chain(profile.value, profile.slope, axle.x);
  T penetration = radius - axle.z;
  if (!plant.base_falls) penetration += depth;
  const V direction = select(value_of(velocity.x) < 0.0, V(-1.0), V(1.0));
  const T speed = direction * velocity.x;
  auto ground = ground_numbers(plant, around, index, time, nose, speed, depth, penetration, axle.x,
                               seen ? &seen->ground : nullptr);
  if constexpr (std::is_same_v<V, double>)
    if (plant.sinking.counts() && inside && row.ahead < 0 && value_of(ground.vertical) > 0.0)
      sink(plant.sinking, plant.base_falls ? chain(under.inclination.value, under.inclination.slope, axle.x) : T(0.0),
           radius, penetration, speed, velocity.z, ground);

  const T along = quick_tanh(velocity.x * (1.0 / creep_speed));
  const V friction = select(inside, V(group.braking_in_bed), V(group.braking));
  const T roll_radius = radius / ground.spin_ratio;
  const bool slips = plant.wheel_spin == WheelSpin::inertial || plant.brake_mode == BrakeMode::torque;
  T slip_force = T(0.0);
  if (slips) {
    const T slip = (velocity.x - spin * roll_radius) / sqrt(velocity.x * velocity.x + slip_floor * slip_floor);
    slip_force = slip_friction * ground.vertical * quick_tanh(slip * (slip_stiffness / slip_friction));
  }
  T brake_force = T(0.0), brake_torque = T(0.0), wheel_torque = T(0.0);
  const bool braked = any(friction > 0.0);
  if (braked && plant.brake_mode == BrakeMode::friction) {
    brake_force = friction * ground.vertical * along;
    brake_torque = brake_force * (radius - (penetration - ground.rut_depth));  // arm down to the contact
  } else if (braked) {
    wheel_torque = friction * ground.vertical * roll_radius * quick_tanh(spin * 2.0);
    brake_torque = wheel_torque;
  }
  const T drag = ground.drag * along;
  const T tangential = drag + brake_force + slip_force;
  RowForce<T> result;
  result.force = {-tangential, ground.vertical};
  Pair<T> contact{-drag, ground.vertical}, tangent{T(1.0), T(0.0)};
  const auto& incline = under.inclination;
  if (plant.base_falls && any((incline.value != 0.0) | (incline.slope != 0.0))) {
    // Steady loads belong to a level base: turn them with it (base slope = −inclination of the depth).
    const T slope = chain(-incline.value, -incline.slope, axle.x);
    const T cosine = 1.0 / sqrt(1.0 + slope * slope), sine = slope * cosine;
    result.force = {-tangential * cosine - ground.vertical * sine, ground.vertical * cosine - tangential * sine};
    tangent = {cosine, sine};
    contact = {-drag * cosine - ground.vertical * sine, ground.vertical * cosine - drag * sine};
  }
  result.force = {row.tires * result.force.x, row.tires * result.force.z};
  result.brake_torque = row.tires * brake_torque;
  if (slips) {
    result.spin_rate = (slip_force * roll_radius - wheel_torque) * (row.tires / row.inertia);
  } else {  // follows the free spin within 20 ms, for the record only
    result.spin_rate = (velocity.x / roll_radius - spin) * 50.0;
  }
  if (seen) {
    seen->distance = x;
    seen->speed = value_of(velocity.x);
    seen->penetration = value_of(penetration);
    seen->bed_depth = profile.value;
    seen->force_x = value_of(result.force.x);
    seen->force_z = value_of(result.force.z);
    seen->contact_x = row.tires * value_of(contact.x);
    seen->contact_z = row.tires * value_of(contact.z);
    seen->brake_force = row.tires * value_of(brake_force);
    seen->brake_torque = value_of(result.brake_torque);
    seen->slip_force = row.tires * value_of(slip_force);
    seen->roll_radius = value_of(roll_radius);
    seen->spin = value_of(spin);
    seen->velocity = {value_of(velocity.x), value_of(velocity.z)};
    seen->tangent = {value_of(tangent.x), value_of(tangent.z)};
  }
  return result;
}

/// Force of one strut, part by part.
template <class T>
struct StrutForce {
  T gas, orifice, friction, stop;
};
template <class T, class S>
StrutForce<T> strut_force(const S& strut, const T& stroke, const T& rate, const T& normal) {
  return {aircraft::gas_force(strut, stroke), aircraft::orifice_force(strut, rate),
          aircraft::friction_force(strut, stroke, rate, normal), aircraft::stop_force(strut, stroke)};
}
/// By way of numbers that carry no derivatives, so that all paths call the same elementary functions.
template <class V, class S>
StrutForce<V> plain_strut_force(const S& strut, const V& stroke, const V& rate, const V& normal) {
  const auto force = strut_force<Dual<0, V>>(strut, stroke, rate, normal);
  return {force.gas.value, force.orifice.value, force.friction.value, force.stop.value};
}

/// Forces on the body that no gear makes: aerodynamics at the static cg, thrust at its own height, the guide at ground
/// level.
template <class T>
struct BodyForce {
  T x, z, moment;
  Pair<T> aero;
  T aero_moment;
  Pair<T> cg;
};
template <class T, class P, class V>
BodyForce<T> body_force(const P& plant, const V& time, const V& thrust, const T& height, const T& cosine, const T& sine,
                        const T& speed, const T& q) {
  BodyForce<T> result;
  result.cg = {plant.cg.x * cosine - plant.cg.z * sine, plant.cg.x * sine + plant.cg.z * cosine};
  const T cg_speed = speed - q * result.cg.z;
  const T airspeed = cg_speed + plant.headwind;
  const T pressure = airspeed * airspeed;
  result.aero = {-plant.drag_area * pressure, plant.lift_area * pressure};
  result.aero_moment = plant.moment_area * pressure + result.cg.x * result.aero.z - result.cg.z * result.aero.x;
  result.x = result.aero.x;
  result.z = result.aero.z;
  result.moment = result.aero_moment;
  if (any(thrust != 0.0)) {
    result.x += thrust * cosine;
    result.z += thrust * sine;
    result.moment += T(-thrust * plant.thrust_at.z);
  }
  if constexpr (std::is_same_v<P, Plant>)
    if (plant.alterations && plant.alterations->guide && time > 0.0) {
      const auto& guide = *plant.alterations->guide;
      const T lead = (guide.gain * plant.mass) * (guide.speed_at(time) - cg_speed);
      result.x += lead;
      result.moment += lead * height;
    }
  return result;
}
inline double thrust_at(const Plant& plant, double time) {
  return plant.timed_thrust ? plant.thrust + plant.alterations->thrust(time) : plant.thrust;
}

/// Runs side by side all have brake rods (convoy.h).
inline bool brakes_on_beam(const Group& group) { return group.brakes_on_beam; }
template <class G>
bool brakes_on_beam(const G&) {
  return false;
}

/// One gear group as a right-hand side leaves it, for the derivatives.
template <class V>
struct GroupMotion {
  Pair<V> axis, across, arm, arm_turned;  ///< e, n = e^⊥, ρ, ρ^⊥
  Pair<V> force;                          ///< of the tires, on the axle
  V strut;                                ///< S, all struts
  V beam_cosine, beam_sine;
};
template <class V>
struct BodyMotion {
  std::array<GroupMotion<V>, most_groups> groups;
  V cosine, sine, nose;
  V l1, l2, l3, a22, a23, a33, mxx, mxz, mxt;  ///< the eliminated 3 × 3 system
  V ax, az, turn;
};

/// Solution of the eliminated 3 × 3 system (a_x, a_z, θ″).
template <class V>
std::array<V, 3> solve(const BodyMotion<V>& m, const V& fx, const V& fz, const V& moment) {
  const V b2 = fz - m.l1 * fx, b3 = moment - m.l2 * fx - m.l3 * b2;
  const V turn = b3 / m.a33, az = (b2 - m.a23 * turn) / m.a22;
  return {(fx - m.mxz * az - m.mxt * turn) / m.mxx, az, turn};
}

/// dy/dt. `row_of(index, axle, velocity, spin, seen)` gives the force of a row.
template <class V, class Aircraft, class Seen, class Rows>
inline void motion(const Aircraft& plant, const V& time, const V* y, V* dydt, Seen* seen, BodyMotion<V>& body,
                   const Rows& row_of) {
  using P = Pair<V>;
  const int n = plant.degrees();
  const V* rate = y + n;
  const V* spin = y + 2 * n;
  V* acceleration = dydt + n;
  V* spin_rate = dydt + 2 * n;
  for (int i = 0; i < n; ++i) dydt[i] = rate[i];

  const auto pitch = sine_cosine(y[2]);
  const V cosine = body.cosine = pitch.cosine, sine = body.sine = pitch.sine, q = rate[2];
  const auto turned = [&](const auto& b) { return P{b.x * cosine - b.z * sine, b.x * sine + b.z * cosine}; };
  const P origin{y[0], y[1]}, velocity{rate[0], rate[1]};
  const int bogie_start = 3 + static_cast<int>(plant.groups.size());

  // Symmetric 3 × 3 system for (a_x, a_z, θ″).
  V mxx = plant.sprung_mass, mxz = 0.0, mxt = 0.0, mzz = mxx, mzt = 0.0, mtt = plant.sprung_inertia;
  const V thrust = thrust_at(plant, time);
  const auto own = body_force<V>(plant, time, thrust, y[1], cosine, sine, rate[0], q);
  V fx = plant.sprung_mass * plant.gravity.x + own.x, fz = plant.sprung_mass * plant.gravity.z + own.z,
    moment = own.moment;

  V push[most_groups];
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& group = plant.groups[g];
    const V stroke = y[3 + g], stroke_rate = rate[3 + g];
    auto& at = body.groups[g];
    const P e = at.axis = turned(group.axis), across = at.across = perpendicular(e);
    const P rho = at.arm = turned(group.extended) + stroke * e, rho_turned = at.arm_turned = perpendicular(rho);
    const P axle = origin + rho, axle_velocity = velocity + q * rho_turned + stroke_rate * e;
    if (g == 0) body.nose = axle.x;

    P force{0.0, 0.0};
    V torque = 0.0;
    if (group.bogie < 0) {
      const int r = group.first_row;
      const auto row =
          row_of(r, axle, axle_velocity, spin[r], seen ? &seen->rows[static_cast<std::size_t>(r)] : nullptr);
      force = row.force;
      torque = -row.brake_torque;
      spin_rate[r] = row.spin_rate;
    } else {
      const int beam = bogie_start + group.bogie;
      const auto turn = sine_cosine(y[beam]);
      at.beam_cosine = turn.cosine;
      at.beam_sine = turn.sine;
      const V damping = group.bogie_damping * (rate[beam] - q);
      V beam_moment = -damping;
      for (int r = group.first_row; r < group.first_row + group.rows; ++r) {
        const V offset = plant.rows[static_cast<std::size_t>(r)].offset;
        const P out{offset * turn.cosine, offset * turn.sine};
        const auto row = row_of(r, axle + out, axle_velocity + rate[beam] * perpendicular(out), spin[r],
                                seen ? &seen->rows[static_cast<std::size_t>(r)] : nullptr);
        force = force + row.force;
        (brakes_on_beam(group) ? beam_moment : torque) -= row.brake_torque;
        beam_moment += out.x * row.force.z - out.z * row.force.x;
        spin_rate[r] = row.spin_rate;
      }
      torque += damping;
      acceleration[beam] = beam_moment / group.bogie_inertia;
    }
    at.force = force;

    // Strut force per strut, all struts of the group together.
    const auto part = plain_strut_force<V>(group.strut, stroke, stroke_rate, dot(force, across) / group.struts);
    const V strut = at.strut = group.struts * (part.gas + part.orifice + part.friction + part.stop);

    // P = F + m g − m (2 θ′ s′ e^⊥ − θ′² ρ)
    const V coriolis = (2.0 * group.mass) * q * stroke_rate, centripetal = group.mass * q * q;
    const P p{force.x + group.mass * plant.gravity.x - coriolis * across.x + centripetal * rho.x,
              force.z + group.mass * plant.gravity.z - coriolis * across.z + centripetal * rho.z};
    const V across_force = dot(across, p), lever = dot(rho_turned, across);
    const V bx = group.mass * across.x, bz = group.mass * across.z;
    mxx += bx * across.x;
    mxz += bx * across.z;
    mzz += bz * across.z;
    mxt += bx * lever;
    mzt += bz * lever;
    mtt += group.mass * lever * lever;
    const P on_body{strut * e.x + across_force * across.x, strut * e.z + across_force * across.z};
    fx += on_body.x;
    fz += on_body.z;
    moment += dot(rho_turned, on_body) + torque;
    push[g] = (dot(e, p) - strut) / group.mass;
    if (seen)
      seen->groups[g] = {stroke,        stroke_rate, part.gas,         part.orifice,
                         part.friction, part.stop,   {axle.x, axle.z}, {axle_velocity.x, axle_velocity.z}};
  }

  // Cholesky-free elimination of the 3 × 3 system (pivots are masses: positive).
  body.mxx = mxx, body.mxz = mxz, body.mxt = mxt;
  body.l1 = mxz / mxx, body.l2 = mxt / mxx;
  body.a22 = mzz - body.l1 * mxz, body.a23 = mzt - body.l1 * mxt;
  body.l3 = body.a23 / body.a22;
  body.a33 = mtt - body.l2 * mxt - body.l3 * body.a23;
  const auto [ax, az, turn] = solve(body, fx, fz, moment);
  acceleration[0] = body.ax = ax;
  acceleration[1] = body.az = az;
  acceleration[2] = body.turn = turn;
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& at = body.groups[g];
    acceleration[3 + g] =
        push[g] - at.axis.x * (ax + turn * at.arm_turned.x) - at.axis.z * (az + turn * at.arm_turned.z);
  }

  if (seen) {
    const auto& cg = own.cg;
    seen->cg_position = {origin.x + cg.x, origin.z + cg.z};
    seen->cg_velocity = {velocity.x - q * cg.z, velocity.z + q * cg.x};
    seen->cg_acceleration = {ax - turn * cg.z - q * q * cg.x, az + turn * cg.x - q * q * cg.z};
    seen->aero = {own.aero.x, own.aero.z};
    seen->thrust = {thrust * cosine, thrust * sine};
    seen->aero_moment = own.aero_moment;
    seen->thrust_moment = -thrust * plant.thrust_at.z;
  }
}

}  // namespace apc::simulation
