/// The Jacobian of motion.h by the chain rule. A row depends on four numbers (where its axle is, its forward speed, its
/// spin) and, where sinking counts, on a fifth, its climb; a strut on three; with the accelerations held, what a gear
/// passes to the body depends on ten numbers of its own and the spins of its rows. Last, the frozen accelerations are
/// freed:  M da = dR,  ds″ = d(push) − e·(da + dθ″ρ^⊥).
///
/// Derivatives of the frame: ∂e/∂θ = n, ∂n/∂θ = −e, ∂ρ/∂θ = ρ^⊥, ∂ρ^⊥/∂θ = −ρ, ∂ρ/∂s = e, ∂ρ^⊥/∂s = n.
#pragma once

#include "apc/simulation/motion.h"

namespace apc::simulation {

/// Columns of one gear: X Z θ s φ X′ θ′ s′ φ′ Z′, then its rows' spins.
enum Column { in_x, in_z, in_pitch, in_stroke, in_beam, in_speed, in_turn, in_rate, in_beam_rate, in_climb, in_spin };
inline constexpr int most_columns = in_spin + most_rows;

/// `N`: 4, or 5 where the rows answer to their climb. `accelerations` receives the rows n … of ∂(dy/dt)/∂y; those
/// before only say that positions move with their rates.
template <int N, class V, class Aircraft, class Around, class Seen>
void jacobian_of(const Aircraft& plant, const Around& around, const V& time, const V* y, V* dydt, V* accelerations,
                 Seen* seen) {
  using P = Pair<V>;
  using Local = Dual<N, V>;
  const auto climb = [](const V& z) {
    if constexpr (N > 4)
      return Local::variable(z, 4);
    else
      return Local(z);
  };
  RowForce<Local> rows[most_rows];
  BodyMotion<V> body;
  motion(plant, time, y, dydt, seen, body, [&](int r, const P& axle, const P& velocity, const V& spin, auto* row_seen) {
    auto& row = rows[r];
    row = row_force<Local>(plant, around, r, time, body.nose, {Local::variable(axle.x, 0), Local::variable(axle.z, 1)},
                           {Local::variable(velocity.x, 2), climb(velocity.z)}, Local::variable(spin, 3), row_seen);
    return RowForce<V>{{row.force.x.value, row.force.z.value}, row.brake_torque.value, row.spin_rate.value};
  });

  const int n = plant.degrees(), states = plant.states(), groups = static_cast<int>(plant.groups.size());
  const V* rate = y + n;
  const V q = rate[2], ax = body.ax, az = body.az, turn = body.turn;
  for (int i = 0; i < (states - n) * states; ++i) accelerations[i] = 0.0;
  // dR: three residuals of the body, a strut's push; the first 3 + groups rows hold them until the end.
  V* to_x = accelerations;
  V* to_z = to_x + states;
  V* to_moment = to_z + states;

  {
    using Own = Dual<4, V>;  // by Z, θ, X′, θ′
    const Own cosine = cos(Own::variable(y[2], 1)), sine = sin(Own::variable(y[2], 1));
    const auto own = body_force<Own>(plant, time, thrust_at(plant, time), Own::variable(y[1], 0), cosine, sine,
                                     Own::variable(rate[0], 2), Own::variable(q, 3));
    const int column[4] = {1, 2, n, n + 2};
    for (int k = 0; k < 4; ++k) {
      to_x[column[k]] += own.x.d[k];
      to_z[column[k]] += own.z.d[k];
      to_moment[column[k]] += own.moment.d[k];
    }
  }

  for (int g = 0; g < groups; ++g) {
    const auto& group = plant.groups[static_cast<std::size_t>(g)];
    const auto& at = body.groups[static_cast<std::size_t>(g)];
    const int beam = group.bogie < 0 ? -1 : 3 + groups + group.bogie, columns = in_spin + group.rows;
    int column[most_columns] = {0, 1, 2, 3 + g, beam, n, n + 2, n + 3 + g, n + beam, n + 1};
    for (int r = 0; r < group.rows; ++r) column[in_spin + r] = 2 * n + group.first_row + r;

    // Rows: forces, torque and beam moment by the gear's columns.
    const P e = at.axis, across = at.across, rho = at.arm, rho_turned = at.arm_turned;
    const V stroke_rate = rate[3 + g], m = group.mass;
    V force_x[most_columns] = {}, force_z[most_columns] = {}, torque[most_columns] = {}, on_beam[most_columns] = {};
    for (int r = 0; r < group.rows; ++r) {
      const int index = group.first_row + r;
      const auto& row = rows[index];
      P out{0.0, 0.0}, out_turned{0.0, 0.0};
      V beam_rate = 0.0;
      if (beam >= 0) {
        const V offset = plant.rows[static_cast<std::size_t>(index)].offset;
        out = {offset * at.beam_cosine, offset * at.beam_sine};
        out_turned = perpendicular(out);
        beam_rate = rate[beam];
      }
      // Axle place and forward speed by the columns.
      const V x[in_spin] = {1.0, 0.0, rho_turned.x, e.x, out_turned.x};
      const V z[in_spin] = {0.0, 1.0, rho_turned.z, e.z, out_turned.z};
      const V u[in_spin] = {
          0.0, 0.0,         stroke_rate * across.x - q * rho.x, q * across.x, -beam_rate * out.x, 1.0, rho_turned.x,
          e.x, out_turned.x};
      const V w[in_spin] = {0.0,
                            0.0,
                            stroke_rate * across.z - q * rho.z,
                            q * across.z,
                            -beam_rate * out.z,
                            0.0,
                            rho_turned.z,
                            e.z,
                            out_turned.z,
                            1.0};
      V* spin_row = accelerations + (n + index) * states;
      for (int k = 0; k < in_spin; ++k) {
        if ((beam < 0 && (k == in_beam || k == in_beam_rate)) || (N < 5 && k == in_climb)) continue;
        const auto by = [&](const Local& f) {
          V sum = f.d[0] * x[k] + f.d[1] * z[k] + f.d[2] * u[k];
          if constexpr (N > 4) sum += f.d[4] * w[k];
          return sum;
        };
        const V fx = by(row.force.x), fz = by(row.force.z);
        force_x[k] += fx;
        force_z[k] += fz;
        (brakes_on_beam(group) ? on_beam : torque)[k] -= by(row.brake_torque);
        on_beam[k] += out.x * fz - out.z * fx;
        spin_row[column[k]] = by(row.spin_rate);
      }
      const int s = in_spin + r;
      force_x[s] = row.force.x.d[3];
      force_z[s] = row.force.z.d[3];
      on_beam[s] = out.x * force_z[s] - out.z * force_x[s];
      (brakes_on_beam(group) ? on_beam : torque)[s] -= row.brake_torque.d[3];
      spin_row[column[s]] = row.spin_rate.d[3];
      on_beam[in_beam] -= out.z * row.force.z.value + out.x * row.force.x.value;
    }
    if (beam >= 0) {
      on_beam[in_beam_rate] -= group.bogie_damping;
      on_beam[in_turn] += group.bogie_damping;
      torque[in_beam_rate] += group.bogie_damping;
      torque[in_turn] -= group.bogie_damping;
      V* row = accelerations + beam * states;
      for (int k = 0; k < columns; ++k) row[column[k]] = on_beam[k] / group.bogie_inertia;
    }

    // The strut: S by stroke, rate and the axle's force across it.
    using Three = Dual<4, V>;
    const V each = 1.0 / group.struts;
    const auto part = strut_force<Three>(group.strut, Three::variable(y[3 + g], 0), Three::variable(stroke_rate, 1),
                                         Three::variable(each * dot(at.force, across), 2));
    V strut[3];
    for (int k = 0; k < 3; ++k)
      strut[k] = group.struts * (part.gas.d[k] + part.orifice.d[k] + part.friction.d[k] + part.stop.d[k]);
    const V by_normal = each * strut[2];

    // Q = F + m (g − a − θ″ρ^⊥ − 2 θ′s′n + θ′²ρ); with explicit derivatives by θ, s, θ′, s′.
    const auto& gravity = plant.gravity;
    const V spin = 2.0 * q * stroke_rate;
    const P load{at.force.x + m * (gravity.x - ax - turn * rho_turned.x - spin * across.x + q * q * rho.x),
                 at.force.z + m * (gravity.z - az - turn * rho_turned.z - spin * across.z + q * q * rho.z)};
    const V along_load = dot(e, load), across_load = dot(across, load);
    const P on_body{at.strut * e.x + across_load * across.x, at.strut * e.z + across_load * across.z};
    V* push = accelerations + (3 + g) * states;
    for (int k = 0; k < columns; ++k) {
      if ((beam < 0 && (k == in_beam || k == in_beam_rate)) || (N < 5 && k == in_climb)) continue;
      P moved{force_x[k], force_z[k]};  // dF, then dQ
      V normal = dot(moved, across), strut_moved = 0.0;
      V de = 0.0, dn = 0.0;  // turning of the frame: e gains n dθ, n gains −e dθ
      if (k == in_pitch) {
        normal -= dot(at.force, e);
        de = 1.0, dn = -1.0;
        moved.x += m * (turn * rho.x + spin * e.x + q * q * rho_turned.x);
        moved.z += m * (turn * rho.z + spin * e.z + q * q * rho_turned.z);
      } else if (k == in_stroke) {
        strut_moved = strut[0];
        moved.x += m * (q * q * e.x - turn * across.x);
        moved.z += m * (q * q * e.z - turn * across.z);
      } else if (k == in_turn) {
        moved.x += 2.0 * m * (q * rho.x - stroke_rate * across.x);
        moved.z += 2.0 * m * (q * rho.z - stroke_rate * across.z);
      } else if (k == in_rate) {
        strut_moved = strut[1];
        moved.x -= 2.0 * m * q * across.x;
        moved.z -= 2.0 * m * q * across.z;
      }
      strut_moved += by_normal * normal;
      const V along_moved = dot(e, moved) + de * across_load, across_moved = dot(across, moved) + dn * along_load;
      const V along_e = strut_moved + dn * across_load, along_n = across_moved + de * at.strut;
      const P d{along_e * e.x + along_n * across.x, along_e * e.z + along_n * across.z};
      V moment = dot(rho_turned, d) + torque[k];
      if (k == in_pitch) moment -= dot(rho, on_body);
      if (k == in_stroke) moment += dot(across, on_body);
      to_x[column[k]] += d.x;
      to_z[column[k]] += d.z;
      to_moment[column[k]] += moment;
      push[column[k]] = (along_moved - strut_moved) / m;
    }
  }

  for (int k = 0; k < states; ++k) {
    const auto freed = solve(body, to_x[k], to_z[k], to_moment[k]);
    to_x[k] = freed[0];
    to_z[k] = freed[1];
    to_moment[k] = freed[2];
  }
  for (int g = 0; g < groups; ++g) {
    const auto& at = body.groups[static_cast<std::size_t>(g)];
    const V lever = dot(at.axis, at.arm_turned);
    V* push = accelerations + (3 + g) * states;
    for (int k = 0; k < states; ++k) push[k] -= at.axis.x * to_x[k] + at.axis.z * to_z[k] + lever * to_moment[k];
  }
}

}  // namespace apc::simulation
