/// Body of equations.h as a template over the number type: double for the right-hand side, Dual for its derivatives.
#pragma once

#include <cmath>
#include <type_traits>

#include "aircraft/strut.h"
#include "apc/simulation/dual.h"
#include "apc/simulation/equations.h"

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

/// The ground under one tire as numbers of type T.
template <class T>
struct GroundNumbers {
  T drag, vertical, rut_depth, spin_ratio;
};

inline GroundNumbers<double> ground_numbers(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead,
                                            double, double, double, double, GroundLoad& load) {
  load = ground_load(ground, place, ahead);
  return {load.load.drag, load.load.vertical, load.load.rut_depth, load.load.spin_ratio};
}

template <int N>
GroundNumbers<Dual<N>> ground_numbers(const TireBed& ground, const effects::TirePlace& place, const Rut* ahead,
                                      const Dual<N>& speed, const Dual<N>& depth, const Dual<N>& penetration,
                                      const Dual<N>& distance, GroundLoad& load) {
  load = ground_load_with_slopes(ground, place, ahead);
  const auto combine = [&](double value, const std::array<double, 4>& slope) {
    Dual<N> y;
    y.value = value;
    for (int i = 0; i < N; ++i)
      y.d[i] = slope[0] * speed.d[i] + slope[1] * depth.d[i] + slope[2] * penetration.d[i] + slope[3] * distance.d[i];
    return y;
  };
  return {combine(load.load.drag, load.drag), combine(load.load.vertical, load.vertical),
          combine(load.load.rut_depth, load.rut_depth), combine(load.load.spin_ratio, load.spin_ratio)};
}

/// Forces of one row on its axle and the rate of its spin.
template <class T>
struct RowForce {
  Pair<T> force;
  T brake_torque, spin_rate;
};

template <class T>
RowForce<T> row_force(const Plant& plant, const Surroundings& around, int index, double time, double nose,
                      const Pair<T>& axle, const Pair<T>& velocity, const T& spin, RowMoment* seen) {
  using std::sqrt;
  const auto& row = plant.rows[static_cast<std::size_t>(index)];
  const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
  const bool inside = around.in_bed[static_cast<std::size_t>(index)];
  const double radius = group.tire_radius, x = value_of(axle.x);

  // The ground under the wheel: depth, and on a falling base the inclination under the contact patch.
  const auto profile = inside ? plant.profile.depth(x) : ValueAndSlope{};
  const T depth = chain(profile.value, profile.slope, axle.x);
  T penetration = radius - axle.z;
  if (!plant.base_falls) penetration += depth;
  const double direction = value_of(velocity.x) < 0.0 ? -1.0 : 1.0;
  const T speed = direction * velocity.x;

  effects::TirePlace place{{value_of(speed), profile.value, value_of(penetration)}, x, nose, time};
  Rut ahead;
  const bool follows = inside && row.ahead >= 0;
  if (follows) ahead = around.ruts[static_cast<std::size_t>(row.ahead)].at(x);
  GroundLoad load;
  const auto ground =
      ground_numbers(group.ground, place, follows ? &ahead : nullptr, speed, depth, penetration, axle.x, load);

  const T along = quick_tanh(velocity.x * (1.0 / creep_speed));
  const double friction = inside ? group.braking_in_bed : group.braking;
  const T roll_radius = radius / ground.spin_ratio;
  const T slip = (velocity.x - spin * roll_radius) / sqrt(velocity.x * velocity.x + slip_floor * slip_floor);
  T slip_force = T(0.0);
  if (plant.wheel_spin == WheelSpin::inertial || plant.brake_mode == BrakeMode::torque)
    slip_force = slip_friction * ground.vertical * quick_tanh(slip * (slip_stiffness / slip_friction));
  T brake_force = T(0.0), brake_torque = T(0.0), wheel_torque = T(0.0);
  if (friction > 0.0 && plant.brake_mode == BrakeMode::friction) {
    brake_force = friction * ground.vertical * along;
    brake_torque = brake_force * (radius - (penetration - ground.rut_depth));  // arm down to the contact
  } else if (friction > 0.0) {
    wheel_torque = friction * ground.vertical * roll_radius * quick_tanh(spin * 2.0);
    brake_torque = wheel_torque;
  }
  const T drag = ground.drag * along;
  const T tangential = drag + brake_force + slip_force;
  RowForce<T> result;
  result.force = {-tangential, ground.vertical};
  Pair<T> contact{-drag, ground.vertical}, tangent{T(1.0), T(0.0)};
  if (inside && plant.base_falls) {
    // Steady loads belong to a level base: turn them with it (base slope = −inclination of the depth).
    const auto incline = plant.profile.inclination(x, 0.5 * radius);
    if (incline.value != 0.0 || incline.slope != 0.0) {
      const T slope = chain(-incline.value, -incline.slope, axle.x);
      const T cosine = 1.0 / sqrt(1.0 + slope * slope), sine = slope * cosine;
      result.force = {-tangential * cosine - ground.vertical * sine, ground.vertical * cosine - tangential * sine};
      tangent = {cosine, sine};
      contact = {-drag * cosine - ground.vertical * sine, ground.vertical * cosine - drag * sine};
    }
  }
  result.force = {row.tires * result.force.x, row.tires * result.force.z};
  result.brake_torque = row.tires * brake_torque;
  if (plant.wheel_spin == WheelSpin::inertial || plant.brake_mode == BrakeMode::torque) {
    result.spin_rate = (slip_force * roll_radius - wheel_torque) * (row.tires / row.inertia);
  } else {  // follows the free spin within 20 ms, for the record only
    result.spin_rate = (velocity.x / roll_radius - spin) * 50.0;
  }
  if constexpr (std::is_same_v<T, double>) {
    if (seen) {
      *seen = {x,
               velocity.x,
               penetration,
               profile.value,
               load,
               result.force.x,
               result.force.z,
               row.tires * contact.x,
               row.tires * contact.z,
               row.tires * brake_force,
               result.brake_torque,
               row.tires * slip_force,
               roll_radius,
               spin,
               {velocity.x, velocity.z},
               {tangent.x, tangent.z}};
    }
  }
  return result;
}

/// A row depends on four numbers only: where its axle is (x, z), its forward speed and its spin. Its derivatives are
/// taken by those and spread over the N variables afterwards.
inline RowForce<double> row_of(const Plant& plant, const Surroundings& around, int index, double time, double nose,
                               const Pair<double>& axle, const Pair<double>& velocity, const double& spin,
                               RowMoment* seen) {
  return row_force<double>(plant, around, index, time, nose, axle, velocity, spin, seen);
}

template <int N>
RowForce<Dual<N>> row_of(const Plant& plant, const Surroundings& around, int index, double time, double nose,
                         const Pair<Dual<N>>& axle, const Pair<Dual<N>>& velocity, const Dual<N>& spin, RowMoment*) {
  using Local = Dual<4>;
  const auto local = row_force<Local>(
      plant, around, index, time, nose, {Local::variable(axle.x.value, 0), Local::variable(axle.z.value, 1)},
      {Local::variable(velocity.x.value, 2), Local(velocity.z.value)}, Local::variable(spin.value, 3), nullptr);
  const auto spread = [&](const Local& f) {
    Dual<N> y;
    y.value = f.value;
    for (int i = 0; i < N; ++i)
      y.d[i] = f.d[0] * axle.x.d[i] + f.d[1] * axle.z.d[i] + f.d[2] * velocity.x.d[i] + f.d[3] * spin.d[i];
    return y;
  };
  return {{spread(local.force.x), spread(local.force.z)}, spread(local.brake_torque), spread(local.spin_rate)};
}

template <class T>
void motion(const Plant& plant, const Surroundings& around, double time, const T* y, T* dydt, Moment* seen) {
  using std::cos, std::sin;
  const int n = plant.degrees();
  const T* rate = y + n;
  const T* spin = y + 2 * n;
  T* acceleration = dydt + n;
  T* spin_rate = dydt + 2 * n;
  for (int i = 0; i < n; ++i) dydt[i] = rate[i];

  const T cosine = cos(y[2]), sine = sin(y[2]);
  const T& q = rate[2];
  const auto turned = [&](const Vector& b) { return Pair<T>{b.x * cosine - b.z * sine, b.x * sine + b.z * cosine}; };
  const Pair<T> origin{y[0], y[1]}, velocity{rate[0], rate[1]};
  const int bogie_start = 3 + static_cast<int>(plant.groups.size());

  // Symmetric 3 × 3 system for (a_x, a_z, θ″).
  T mxx = T(plant.sprung_mass), mxz = T(0.0), mxt = T(0.0), mzz = mxx, mzt = T(0.0), mtt = T(plant.sprung_inertia);
  T fx = T(plant.sprung_mass * plant.gravity.x), fz = T(plant.sprung_mass * plant.gravity.z), moment = T(0.0);

  // Aerodynamics at the static cg, thrust at its own height.
  const auto cg = turned(plant.cg);
  const T airspeed = velocity.x - q * cg.z + plant.headwind;
  const T pressure = airspeed * airspeed;
  const Pair<T> aero{-plant.drag_area * pressure, plant.lift_area * pressure};
  const T aero_moment = plant.moment_area * pressure + cg.x * aero.z - cg.z * aero.x;
  double thrust = plant.thrust;
  if (plant.timed_thrust) thrust += plant.alterations->thrust(time);
  fx += aero.x;
  fz += aero.z;
  moment += aero_moment;
  if (thrust != 0.0) {
    fx += thrust * cosine;
    fz += thrust * sine;
    moment += T(-thrust * plant.thrust_at.z);
  }

  if (plant.alterations && plant.alterations->guide && time > 0.0) {
    const auto& guide = *plant.alterations->guide;
    const T lead = (guide.gain * plant.mass) * (guide.speed_at(time) - (velocity.x - q * cg.z));
    fx += lead;
    moment += lead * origin.z;  // at ground level
  }

  T push[most_groups];
  Pair<T> axis[most_groups], arm[most_groups];
  double nose = 0.0;
  for (std::size_t g = 0; g < plant.groups.size(); ++g) {
    const auto& group = plant.groups[g];
    const T& stroke = y[3 + g];
    const T& stroke_rate = rate[3 + g];
    const auto e = turned(group.axis), across = perpendicular(e);
    const auto rho = turned(group.extended) + stroke * e, rho_turned = perpendicular(rho);
    const Pair<T> axle = origin + rho, axle_velocity = velocity + q * rho_turned + stroke_rate * e;
    if (g == 0) nose = value_of(axle.x);

    Pair<T> force{T(0.0), T(0.0)};
    T torque = T(0.0);
    if (group.bogie < 0) {
      const auto row = row_of(plant, around, group.first_row, time, nose, axle, axle_velocity, spin[group.first_row],
                              seen ? &seen->rows[static_cast<std::size_t>(group.first_row)] : nullptr);
      force = row.force;
      torque = -row.brake_torque;
      spin_rate[group.first_row] = row.spin_rate;
    } else {
      const int beam = bogie_start + group.bogie;
      const T beam_cosine = cos(y[beam]), beam_sine = sin(y[beam]);
      const T damping = group.bogie_damping * (rate[beam] - q);
      T beam_moment = -damping;
      for (int r = group.first_row; r < group.first_row + group.rows; ++r) {
        const double offset = plant.rows[static_cast<std::size_t>(r)].offset;
        const Pair<T> out{offset * beam_cosine, offset * beam_sine};
        const auto row =
            row_of(plant, around, r, time, nose, axle + out, axle_velocity + rate[beam] * perpendicular(out), spin[r],
                   seen ? &seen->rows[static_cast<std::size_t>(r)] : nullptr);
        force = force + row.force;
        torque -= row.brake_torque;
        beam_moment += out.x * row.force.z - out.z * row.force.x;
        spin_rate[r] = row.spin_rate;
      }
      torque += damping;
      acceleration[beam] = beam_moment * (1.0 / group.bogie_inertia);
    }

    // Strut force per strut, all struts of the group together.
    const double each = 1.0 / group.struts;
    const T normal = each * dot(force, across);
    const T gas = aircraft::gas_force(group.strut, stroke), orifice = aircraft::orifice_force(group.strut, stroke_rate);
    const T friction = aircraft::friction_force(group.strut, stroke, stroke_rate, normal);
    const T stop = aircraft::stop_force(group.strut, stroke);
    const T strut = group.struts * (gas + orifice + friction + stop);

    // P = F + m g − m (2 θ′ s′ e^⊥ − θ′² ρ)
    const T coriolis = (2.0 * group.mass) * q * stroke_rate, centripetal = group.mass * q * q;
    const Pair<T> p{force.x + group.mass * plant.gravity.x - coriolis * across.x + centripetal * rho.x,
                    force.z + group.mass * plant.gravity.z - coriolis * across.z + centripetal * rho.z};
    const T across_force = dot(across, p);
    const T lever = dot(rho_turned, across);
    const T bx = group.mass * across.x, bz = group.mass * across.z;
    mxx += bx * across.x;
    mxz += bx * across.z;
    mzz += bz * across.z;
    mxt += bx * lever;
    mzt += bz * lever;
    mtt += group.mass * lever * lever;
    const Pair<T> on_body{strut * e.x + across_force * across.x, strut * e.z + across_force * across.z};
    fx += on_body.x;
    fz += on_body.z;
    moment += dot(rho_turned, on_body) + torque;
    push[g] = (dot(e, p) - strut) * (1.0 / group.mass);
    axis[g] = e;
    arm[g] = rho_turned;
    if constexpr (std::is_same_v<T, double>)
      if (seen)
        seen->groups[g] = {
            stroke, stroke_rate, gas, orifice, friction, stop, {axle.x, axle.z}, {axle_velocity.x, axle_velocity.z}};
  }

  // Cholesky-free elimination of the 3 × 3 system (pivots are masses: positive).
  const T l1 = mxz / mxx, l2 = mxt / mxx;
  const T a22 = mzz - l1 * mxz, a23 = mzt - l1 * mxt, b2 = fz - l1 * fx;
  const T l3 = a23 / a22;
  const T a33 = mtt - l2 * mxt - l3 * a23, b3 = moment - l2 * fx - l3 * b2;
  const T turn = b3 / a33;
  const T az = (b2 - a23 * turn) / a22;
  const T ax = (fx - mxz * az - mxt * turn) / mxx;
  acceleration[0] = ax;
  acceleration[1] = az;
  acceleration[2] = turn;
  for (std::size_t g = 0; g < plant.groups.size(); ++g)
    acceleration[3 + g] = push[g] - axis[g].x * (ax + turn * arm[g].x) - axis[g].z * (az + turn * arm[g].z);

  if constexpr (std::is_same_v<T, double>) {
    if (seen) {
      seen->cg_position = {origin.x + cg.x, origin.z + cg.z};
      seen->cg_velocity = {velocity.x - q * cg.z, velocity.z + q * cg.x};
      seen->cg_acceleration = {ax - turn * cg.z - q * q * cg.x, az + turn * cg.x - q * q * cg.z};
      seen->aero = {aero.x, aero.z};
      seen->thrust = {thrust * cosine, thrust * sine};
      seen->aero_moment = aero_moment;
      seen->thrust_moment = -thrust * plant.thrust_at.z;
    }
  }
}

}  // namespace apc::simulation
