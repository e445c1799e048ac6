#include "apc/simulation/equations.h"

#include "apc/base/require.h"
#include "apc/simulation/every_processor.h"
#include "apc/simulation/motion_slopes.h"

namespace apc::simulation {

APC_FOR_EVERY_PROCESSOR
void derivatives(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
                 Moment* moment) {
  BodyMotion<double> body;
  motion(plant, time, y, dydt, moment, body,
         [&](int r, const Pair<double>& axle, const Pair<double>& velocity, double spin, RowMoment* seen) {
           return row_force<double>(plant, around, r, time, body.nose, axle, velocity, spin, seen);
         });
}

APC_FOR_EVERY_PROCESSOR
void jacobian(const Plant& plant, const Surroundings& around, double time, const double* y, double* dydt,
              double* matrix, Moment* moment) {
  const int n = plant.degrees(), states = plant.states();
  for (int i = 0; i < n * states; ++i) matrix[i] = 0.0;
  for (int i = 0; i < n; ++i) matrix[i * states + n + i] = 1.0;
  if (plant.sinking.counts())
    jacobian_of<5>(plant, around, time, y, dydt, matrix + n * states, moment);
  else
    jacobian_of<4>(plant, around, time, y, dydt, matrix + n * states, moment);
}

void directional(const Plant& plant, const Surroundings& around, double time, const double* y, const double* direction,
                 double* result) {
  double rate[most_states], matrix[most_states * most_states];
  jacobian(plant, around, time, y, rate, matrix);
  const int states = plant.states();
  for (int i = 0; i < states; ++i) {
    result[i] = 0.0;
    for (int j = 0; j < states; ++j) result[i] += matrix[i * states + j] * direction[j];
  }
}

std::array<double, 2> row_motion(const Plant& plant, int index, const double* y) {
  const auto& row = plant.rows[static_cast<std::size_t>(index)];
  const auto& group = plant.groups[static_cast<std::size_t>(row.group)];
  const double* rate = y + plant.degrees();
  const auto [s, c] = elementary::sine_cosine(y[2]);
  const double stroke = y[3 + row.group];
  const Vector body{group.extended.x + stroke * group.axis.x, group.extended.z + stroke * group.axis.z};
  double x = y[0] + body.x * c - body.z * s;
  double u =
      rate[0] - rate[2] * (body.x * s + body.z * c) + rate[3 + row.group] * (group.axis.x * c - group.axis.z * s);
  if (group.bogie >= 0) {
    const auto beam = 3 + plant.groups.size() + static_cast<std::size_t>(group.bogie);
    const auto turn = elementary::sine_cosine(y[beam]);
    x += row.offset * turn.cosine;
    u -= rate[beam] * row.offset * turn.sine;
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
