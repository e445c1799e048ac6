#include "apc/simulation/lane_block.h"

namespace apc::simulation {

Shape shape_of(const Model& model, const Overrun& overrun) {
  Shape shape;
  for (const auto& gear : model.aircraft.gears) {
    const auto g = static_cast<std::size_t>(shape.groups);
    shape.bogie_of.at(g) = gear.axles > 1 ? shape.bogies++ : -1;
    for (int axle = 0; axle < gear.axles; ++axle) {
      const auto r = static_cast<std::size_t>(shape.rows);
      shape.group_of.at(r) = shape.groups;
      shape.ahead_of[r] = axle == 0 ? -1 : shape.rows - 1;
      ++shape.rows;
    }
    ++shape.groups;
  }
  shape.base_falls = model.bed.flush == bed::Flush::top;
  shape.wheel_spin = overrun.wheel_spin;
  return shape;
}

namespace {

/// One row's tires at one place, and the rut there.
template <class Load>
GroundLoad load_of(const Plant& plant, const Surroundings& around, int row, const effects::TirePlace& place,
                   const Load& load) {
  const auto& ground = plant.groups[static_cast<std::size_t>(plant.rows[static_cast<std::size_t>(row)].group)].ground;
  const int leader = plant.rows[static_cast<std::size_t>(row)].ahead;
  if (leader < 0 || !around.in_bed[static_cast<std::size_t>(row)]) return load(ground, place, nullptr);
  const auto ahead = around.ruts[static_cast<std::size_t>(leader)].at(place.bed_distance);
  return load(ground, place, &ahead);
}

double* tell(const GroundLoad& load, double* out, int stride) {
  for (const double value : {load.load.drag, load.load.vertical, load.load.rut_depth, load.load.spin_ratio,
                             load.virgin_penetration, load.virgin_drag, load.virgin_vertical})
    *out = value, out += stride;
  return out;
}

}  // namespace

void lane_ground(const Plant& plant, const Surroundings& around, int row, double time, double nose, double speed,
                 double depth, double penetration, double distance, double* out, int stride) {
  tell(load_of(plant, around, row, {{speed, depth, penetration}, distance, nose, time}, ground_load), out, stride);
}

void lane_ground_with_slopes(const Plant& plant, const Surroundings& around, int row, double time, double nose,
                             double speed, double depth, double penetration, double distance, double* out, int stride) {
  const auto load =
      load_of(plant, around, row, {{speed, depth, penetration}, distance, nose, time}, ground_load_with_slopes);
  out = tell(load, out, stride);
  for (const auto* slopes : {&load.drag, &load.vertical, &load.rut_depth, &load.spin_ratio})
    for (const double slope : *slopes) *out = slope, out += stride;
}

void lane_profile(const Plant& plant, double distance, double half_patch, double* out, int stride) {
  const auto under = plant.profile.under(distance, half_patch);
  out[0] = under.depth.value, out[stride] = under.depth.slope;
  out[2 * stride] = under.inclination.value, out[3 * stride] = under.inclination.slope;
}

std::array<Profile::Piece, 2> lane_pieces(const Plant& plant) {
  return {plant.profile.first_piece(), plant.profile.last_piece()};
}

RutLog::Between lane_rut(const Surroundings& around, int leader, double distance, std::size_t& near) {
  return around.ruts[static_cast<std::size_t>(leader)].between(distance, near);
}

namespace {

bool is_level(const Plant& plant, const Group& group) {
  return plant.profile.last_piece().slope == 0.0 && !group.ground.alterations;
}

}  // namespace

LevelTables::LevelTables(const Plant& plant) : depth(plant.profile.last_piece().depth) {
  for (const auto& group : plant.groups) {
    coefficients.push_back(is_level(plant, group) ? loadtables::level_coefficients(*group.ground.table, depth)
                                                  : std::vector<double>{});
    of_.push_back(*group.ground.table);
  }
}

bool LevelTables::serve(const Plant& plant) const {
  if (plant.profile.last_piece().depth != depth || plant.groups.size() != of_.size()) return false;
  for (std::size_t g = 0; g < of_.size(); ++g) {
    const auto& group = plant.groups[g];
    if (&group.ground.table->data() != &of_[g].data() || is_level(plant, group) == coefficients[g].empty())
      return false;
  }
  return true;
}

GroundNumbersOfLane lane_numbers(const Plant& plant, const LevelTables& levels, int group) {
  const auto& level = levels.coefficients[static_cast<std::size_t>(group)];
  const auto& ground = plant.groups[static_cast<std::size_t>(group)].ground;
  return {ground.table->numbers(),       level.empty() ? nullptr : level.data(), levels.depth,
          ground.alterations != nullptr, ground.following.bearing_gain,          ground.following.rolling_resistance};
}

unsigned lanes_of_this_processor() {
  return __builtin_cpu_supports("x86-64-v4") ? 8 : __builtin_cpu_supports("x86-64-v3") ? 4 : 2;
}

LaneBlock* make_lane_block() {
  return __builtin_cpu_supports("x86-64-v4")   ? make_lane_block_v4()
         : __builtin_cpu_supports("x86-64-v3") ? make_lane_block_v3()
                                               : make_lane_block_v2();
}

}  // namespace apc::simulation
