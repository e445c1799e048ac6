#include "apc/simulation/equations.h"

#include "apc/base/require.h"
#include "apc/simulation/motion.h"

namespace apc::simulation {

/// Everything below is inlined into one body per instruction set; the processor picks at load time. Contraction to
/// fused multiply-adds is off, so that all of them give the same bits.
#define APC_FOR_EVERY_PROCESSOR \
  __attribute__((flatten, target_clones("arch=skylake-avx512", "arch=haswell", "default")))

APC_FOR_EVERY_PROCESSOR
void derivatives(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
                 Moment* moment) {
  motion<double>(plant, around, time, y, dydt, moment);
}

namespace {

template <int N>
inline void jacobian_of(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
                        double* matrix) {
  const int states = plant.states();
  Dual<N> state[N], rate[N];
  for (int i = 0; i < N; ++i) state[i] = i < states ? Dual<N>::variable(y[i], i) : Dual<N>(0.0);
  motion<Dual<N>>(plant, around, time, state, rate, nullptr);
  for (int i = 0; i < states; ++i) {
    dydt[i] = rate[i].value;
    for (int j = 0; j < states; ++j) matrix[i * states + j] = rate[i].d[j];
  }
}

APC_FOR_EVERY_PROCESSOR
void jacobian_12(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
                 double* matrix) {
  jacobian_of<12>(plant, around, time, y, dydt, matrix);
}

APC_FOR_EVERY_PROCESSOR
void jacobian_24(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
                 double* matrix) {
  jacobian_of<24>(plant, around, time, y, dydt, matrix);
}

}  // namespace

void jacobian(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
              double* matrix) {
  const int states = plant.states();
  if (states <= 12) return jacobian_12(plant, around, time, y, dydt, matrix);
  if (states <= 24) return jacobian_24(plant, around, time, y, dydt, matrix);
  jacobian_of<most_states>(plant, around, time, y, dydt, matrix);
}

void directional(const Plant& plant, const Surroundings& around, double time, const double* y, const double* direction,
                 double* result) {
  Dual<1> state[most_states], rate[most_states];
  const int states = plant.states();
  for (int i = 0; i < most_states; ++i) {
    state[i] = Dual<1>(i < states ? y[i] : 0.0);
    if (i < states) state[i].d[0] = direction[i];
  }
  motion<Dual<1>>(plant, around, time, state, rate, nullptr);
  for (int i = 0; i < states; ++i) result[i] = rate[i].d[0];
}

std::array<double, 2> row_motion(const Plant& plant, int index, const double* y) {
  const auto& row = plant.rows[static_cast<std::size_t>(index)];
  const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
  const double* rate = y + plant.degrees();
  const double c = std::cos(y[2]), s = std::sin(y[2]), stroke = y[3 + row.group];
  const Vector body{group.extended.x + stroke * group.axis.x, group.extended.z + stroke * group.axis.z};
  double x = y[0] + body.x * c - body.z * s;
  double u =
      rate[0] - rate[2] * (body.x * s + body.z * c) + rate[3 + row.group] * (group.axis.x * c - group.axis.z * s);
  if (group.bogie >= 0) {
    const auto beam = 3 + plant.groups.size() + static_cast<std::size_t>(group.bogie);
    x += row.offset * std::cos(y[beam]);
    u -= rate[beam] * row.offset * std::sin(y[beam]);
  }
  return {x, u};
}

effects::TirePlace row_place(const Plant& plant, const Surroundings& around, int index, double time, const double* y) {
  const auto& row = plant.rows[static_cast<std::size_t>(index)];
  const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
  const auto [x, u] = row_motion(plant, index, y);
  const double stroke = y[3 + row.group], s = std::sin(y[2]), c = std::cos(y[2]);
  double z = y[1] + (group.extended.x + stroke * group.axis.x) * s + (group.extended.z + stroke * group.axis.z) * c;
  if (group.bogie >= 0) z += row.offset * std::sin(y[3 + plant.groups.size() + static_cast<std::size_t>(group.bogie)]);
  const double depth = around.in_bed[static_cast<std::size_t>(index)] ? plant.profile.depth(x).value : 0.0;
  const double penetration = group.tire_radius - z + (plant.base_falls ? 0.0 : depth);
  return {{std::abs(u), depth, penetration}, x, nose_distance(plant, y), time};
}

double nose_distance(const Plant& plant, const double* y) { return row_motion(plant, 0, y)[0]; }

}  // namespace apc::simulation
