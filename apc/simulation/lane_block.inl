// Body of lane_block_v2/_v3/_v4.cpp; APC_LANES doubles per vector. Nothing here may call inline functions of doubles
// from shared headers out of line: the linker keeps one copy of those, and it must not be one for a wider processor.
#include <cstring>

#include "apc/simulation/lane_ground.h"
#include "apc/simulation/lane_step.h"
#include "apc/simulation/motion_slopes.h"

namespace apc::simulation {
namespace {

constexpr int W = APC_LANES;
using V = Lanes<W>;

class Block final : public LaneBlock {
 public:
  int width() const override { return W; }

  void reshape(const Shape& shape, const double* weight, const double* weight_by_size) override {
    shape_ = shape;
    plant_.groups.count = static_cast<std::size_t>(shape.groups);
    plant_.rows.count = static_cast<std::size_t>(shape.rows);
    plant_.bogies = shape.bogies;
    plant_.base_falls = shape.base_falls;
    plant_.brake_mode = BrakeMode::friction;
    plant_.wheel_spin = shape.wheel_spin;
    const int *group_of = &shape.group_of[0], *ahead_of = &shape.ahead_of[0], *bogie_of = &shape.bogie_of[0];
    for (int r = 0; r < shape.rows; ++r) {
      plant_.rows.at[r].group = group_of[r];
      plant_.rows.at[r].ahead = ahead_of[r];
    }
    for (int g = 0; g < shape.groups; ++g) {
      auto& group = plant_.groups.at[g];
      group.bogie = bogie_of[g];
      group.first_row = 0, group.rows = 0;
      for (int r = shape.rows - 1; r >= 0; --r)
        if (group_of[r] == g) group.first_row = r, ++group.rows;
    }
    work_.degrees = plant_.degrees();
    work_.spins = shape.rows;
    work_.states = plant_.states();
    for (int i = 0; i < work_.states; ++i) work_.weight[i] = weight[i], work_.weight_by_size[i] = weight_by_size[i];
    around_.present = V(0.0) > V(0.0);
    filled_ = started_ = false;
  }

  void put(int lane, const Plant& plant, const LevelTables& levels, const Surroundings& around) override {
    // The first run also stands in for the others until they come: every lane always holds numbers that mean something.
    for (int l = 0; l < W; ++l)
      if (l == lane || !filled_) fill(l, plant, levels, around);
    filled_ = true;
    around_.present.m[lane] = -1;
  }
  void take_out(int lane) override { around_.present.m[lane] = 0; }
  void set_rows_in_bed(int lane) override {
    for (int r = 0; r < shape_.rows; ++r) around_.in_bed[r].m[lane] = around_.around[lane]->in_bed[r] ? -1 : 0;
  }

  void set_state(int lane, const double* y) override {
    for (int l = 0; l < W; ++l)
      if (l == lane || !started_)
        for (int i = 0; i < work_.states; ++i) {
          work_.y[i].set(l, y[i]);
          dense_[0][i].set(l, y[i]), dense_[1][i].set(l, y[i]), dense_[2][i].set(l, 0.0), dense_[3][i].set(l, 0.0);
        }
    started_ = true;
  }
  void get_state(int lane, double* y) const override {
    for (int i = 0; i < work_.states; ++i) y[i] = work_.y[i][lane];
  }

  void linearise(const double* time) override {
    jacobian_of<4>(plant_, around_, load(time), work_.y, work_.f0, work_.jacobian, &present_);
  }

  void attempt(const double* time, const double* h, double* error) override {
    const V start = load(time), step = load(h);
    eliminate(work_, step);
    for (int stage = 0; stage < 6; ++stage) {
      if (stage > 0) {
        place(work_, stage);
        rate(start + stage_time[stage] * step, stage < 4 ? work_.at : work_.next, work_.f,
             static_cast<MomentLanes<V>*>(nullptr));
      }
      solve(work_, stage);
    }
    const V size = norm(work_), first = work_.inverse[0][0];
    const V finite = select(abs(first) < __builtin_inf(), size, V(__builtin_nan("")));
    std::memcpy(error, &finite, sizeof finite);
  }

  void accept(const bool* accepted) override {
    Mask<W> mask;
    for (int l = 0; l < W; ++l) mask.m[l] = accepted[l] ? -1 : 0;
    for (int i = 0; i < work_.states; ++i) {
      V second(0.0), third(0.0);
      for (int k = 0; k < 5; ++k) {
        second += dense_second[k] * work_.u[k][i];
        third += dense_third[k] * work_.u[k][i];
      }
      dense_[0][i] = select(mask, work_.y[i], dense_[0][i]);
      work_.y[i] = select(mask, work_.next[i], work_.y[i]);
      dense_[1][i] = select(mask, work_.y[i], dense_[1][i]);
      dense_[2][i] = select(mask, second, dense_[2][i]);
      dense_[3][i] = select(mask, third, dense_[3][i]);
    }
  }

  void dense(int lane, double theta, double* y) const override {
    const double other = 1.0 - theta;
    for (int i = 0; i < work_.states; ++i)
      y[i] = dense_[0][i][lane] * other +
             theta * (dense_[1][i][lane] + other * (dense_[2][i][lane] + theta * dense_[3][i][lane]));
  }

  void look(const double* time, const double* theta, const bool* wanted) override {
    const V at = load(theta), other = 1.0 - at;
    for (int i = 0; i < work_.states; ++i)
      looked_[i] = dense_[0][i] * other + at * (dense_[1][i] + other * (dense_[2][i] + at * dense_[3][i]));
    const auto all = around_.present;
    for (int l = 0; l < W; ++l)
      if (!wanted[l]) around_.present.m[l] = 0;
    rate(load(time), looked_, work_.f, &looked_at_);
    around_.present = all;
  }
  void looked(int lane, double* y, Moment& moment) const override {
    for (int i = 0; i < work_.states; ++i) y[i] = looked_[i][lane];
    tell(looked_at_, lane, moment);
  }
  void present(int lane, Moment& moment) const override { tell(present_, lane, moment); }

 private:
  static V load(const double* x) {
    V v;
    std::memcpy(&v, x, sizeof v);
    return v;
  }

  void rate(const V& time, const V* y, V* dydt, MomentLanes<V>* seen) {
    BodyMotion<V> body;
    motion(plant_, time, y, dydt, seen, body,
           [&](int r, const Pair<V>& axle, const Pair<V>& velocity, const V& spin, RowMomentLanes<V>* row_seen) {
             return row_force<V>(plant_, around_, r, time, body.nose, axle, velocity, spin, row_seen);
           });
  }

  void fill(int lane, const Plant& from, const LevelTables& levels, const Surroundings& around) {
    auto& to = plant_;
    to.plant[lane] = &from;
    around_.around[lane] = &around;
    const auto set = [lane](V& x, double value) { x.set(lane, value); };
    const auto pair = [&](Pair<V>& x, const Vector& value) { set(x.x, value.x), set(x.z, value.z); };
    set(to.sprung_mass, from.sprung_mass), set(to.sprung_inertia, from.sprung_inertia);
    set(to.lift_area, from.lift_area), set(to.drag_area, from.drag_area), set(to.moment_area, from.moment_area);
    set(to.headwind, from.headwind), set(to.thrust, from.thrust);
    pair(to.cg, from.cg), pair(to.gravity, from.gravity), pair(to.thrust_at, from.thrust_at);
    const Group* groups = &from.groups[0];
    for (int g = 0; g < shape_.groups; ++g) {
      const auto& a = groups[g];
      auto& b = to.groups.at[g];
      set(b.strut.stroke, a.strut.stroke), set(b.strut.piston_area, a.strut.piston_area);
      set(b.strut.extended_pressure, a.strut.extended_pressure);
      set(b.strut.extended_gas_volume, a.strut.extended_gas_volume);
      set(b.strut.polytropic_exponent, a.strut.polytropic_exponent);
      set(b.strut.damping_compression, a.strut.damping_compression);
      set(b.strut.damping_rebound, a.strut.damping_rebound), set(b.strut.friction, a.strut.friction);
      set(b.strut.bearing_friction, a.strut.bearing_friction), set(b.strut.bearing_upper, a.strut.bearing_upper);
      set(b.strut.bearing_lower, a.strut.bearing_lower), set(b.strut.end_stop, a.strut.end_stop);
      set(b.struts, a.struts), set(b.mass, a.mass), set(b.tire_radius, a.tire_radius);
      set(b.braking, a.braking), set(b.braking_in_bed, a.braking_in_bed);
      set(b.bogie_inertia, a.bogie_inertia), set(b.bogie_damping, a.bogie_damping);
      pair(b.extended, a.extended), pair(b.axis, a.axis);
      const auto ground = lane_numbers(from, levels, g);
      b.table.set(lane, ground.table, ground.level, ground.level_depth);
      around_.altered[g].m[lane] = ground.altered ? -1 : 0;
      set(b.bearing_gain, ground.bearing_gain), set(b.rolling_resistance, ground.rolling_resistance);
    }
    const Row* rows = &from.rows[0];
    for (int r = 0; r < shape_.rows; ++r) {
      set(to.rows.at[r].offset, rows[r].offset), set(to.rows.at[r].tires, rows[r].tires);
      set(to.rows.at[r].inertia, rows[r].inertia);
    }
    const auto pieces = lane_pieces(from);
    const auto set_piece = [&](auto& x, const Profile::Piece& piece) {
      set(x.from, piece.from), set(x.to, piece.to), set(x.depth, piece.depth), set(x.slope, piece.slope);
    };
    set_piece(to.profile.first, (&pieces[0])[0]), set_piece(to.profile.last, (&pieces[0])[1]);
    set_rows_in_bed(lane);
  }

  /// What observers ask for, of one lane.
  void tell(const MomentLanes<V>& from, int lane, Moment& to) const {
    const auto pair = [lane](Vector& x, const Pair<V>& value) { x.x = value.x[lane], x.z = value.z[lane]; };
    for (int r = 0; r < shape_.rows; ++r) {
      const auto& a = from.rows[r];
      auto& b = (&to.rows[0])[r];
      b.ground.load.drag = a.ground.load.drag[lane], b.ground.load.vertical = a.ground.load.vertical[lane];
      b.ground.load.rut_depth = a.ground.load.rut_depth[lane];
      b.ground.load.spin_ratio = a.ground.load.spin_ratio[lane];
      b.ground.virgin_penetration = a.ground.virgin_penetration[lane];
      b.ground.virgin_drag = a.ground.virgin_drag[lane], b.ground.virgin_vertical = a.ground.virgin_vertical[lane];
      b.distance = a.distance[lane], b.speed = a.speed[lane], b.penetration = a.penetration[lane];
      b.bed_depth = a.bed_depth[lane], b.force_x = a.force_x[lane], b.force_z = a.force_z[lane];
      b.contact_x = a.contact_x[lane], b.contact_z = a.contact_z[lane], b.brake_force = a.brake_force[lane];
      b.brake_torque = a.brake_torque[lane], b.slip_force = a.slip_force[lane];
      b.roll_radius = a.roll_radius[lane], b.spin = a.spin[lane];
      pair(b.velocity, a.velocity), pair(b.tangent, a.tangent);
    }
    for (int g = 0; g < shape_.groups; ++g) {
      const auto& a = from.groups[g];
      auto& b = (&to.groups[0])[g];
      b.stroke = a.stroke[lane], b.stroke_rate = a.stroke_rate[lane], b.gas = a.gas[lane];
      b.orifice = a.orifice[lane], b.friction = a.friction[lane], b.stop = a.stop[lane];
      pair(b.axle, a.axle), pair(b.axle_velocity, a.axle_velocity);
    }
    pair(to.cg_position, from.cg_position), pair(to.cg_velocity, from.cg_velocity);
    pair(to.cg_acceleration, from.cg_acceleration), pair(to.aero, from.aero), pair(to.thrust, from.thrust);
    to.aero_moment = from.aero_moment[lane], to.thrust_moment = from.thrust_moment[lane];
  }

  Shape shape_;
  PlantLanes<W> plant_;
  AroundLanes<W> around_;
  LaneWork<W> work_;
  V dense_[4][most_states], looked_[most_states];
  MomentLanes<V> present_, looked_at_;
  bool filled_ = false, started_ = false;
};

}  // namespace
