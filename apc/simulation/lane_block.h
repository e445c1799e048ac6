/// Runs of the fast path side by side in the lanes of vectors: what rosenbrock.h does for one, step by step for all,
/// each with its own step size, plant, ruts and state. A lane has the same bits as Rosenbrock alone, whatever its
/// neighbours and whatever the processor: the laws are the same templates, the linear algebra does the same operations
/// in the same order, and nothing is summed across lanes.
#pragma once

#include "apc/simulation/equations.h"
#include "loadtables/table_lanes.h"

namespace apc::simulation {

/// What the runs of a block must have in common.
struct Shape {
  int groups = 0, rows = 0, bogies = 0;
  std::array<int, most_rows> group_of{}, ahead_of{};
  std::array<int, most_groups> bogie_of{};  ///< −1 without
  bool base_falls = true;
  WheelSpin wheel_spin = WheelSpin::inertial;
  auto operator<=>(const Shape&) const = default;
};
Shape shape_of(const Model&, const Overrun&);

/// Every group's table along the bed's last piece, where that is level; empty otherwise.
struct LevelTables {
  explicit LevelTables(const Plant&);
  /// Whether these are another plant's too.
  bool serve(const Plant&) const;
  double depth = 0.0;
  std::vector<std::vector<double>> coefficients;

 private:
  std::vector<loadtables::LoadTable> of_;  ///< kept, so that no other table comes to lie in its place
};

class LaneBlock {
 public:
  virtual ~LaneBlock() = default;
  virtual int width() const = 0;
  /// Another shape, all lanes empty. The weights of its states are those of StepWork.
  virtual void reshape(const Shape&, const double* weight, const double* weight_by_size) = 0;
  /// A run in `lane`; what it is made of must outlive its stay.
  virtual void put(int lane, const Plant&, const LevelTables&, const Surroundings&) = 0;
  virtual void take_out(int lane) = 0;
  /// State of a lane (at a start).
  virtual void set_state(int lane, const double* y) = 0;
  /// Which rows are in the bed, after a change.
  virtual void set_rows_in_bed(int lane) = 0;
  virtual void get_state(int lane, double* y) const = 0;

  /// Rate and Jacobian at the present states, moments into `present`.
  virtual void linearise(const double* time) = 0;
  /// One attempted step of h[lane] from time[lane] for all; errors in units of the weights, NaN where nothing came out.
  virtual void attempt(const double* time, const double* h, double* error) = 0;
  /// Makes the attempted step the last one in the lanes where accepted[lane].
  virtual void accept(const bool* accepted) = 0;
  /// Dense output in the last step.
  virtual void dense(int lane, double theta, double* y) const = 0;
  /// States and moments within the last steps, for the lanes where wanted[lane].
  virtual void look(const double* time, const double* theta, const bool* wanted) = 0;
  /// Of the last look() and of the last linearise().
  virtual void looked(int lane, double* y, Moment&) const = 0;
  virtual void present(int lane, Moment&) const = 0;
};

/// What lanes ask of the scalar code for one lane each; results `stride` apart. Ground: drag, vertical, rut depth, spin
/// ratio, what the row behind will find (penetration, drag, vertical), then the four slopes of the first four.
void lane_ground(const Plant&, const Surroundings&, int row, double time, double nose, double speed, double depth,
                 double penetration, double distance, double* out, int stride);
void lane_ground_with_slopes(const Plant&, const Surroundings&, int row, double time, double nose, double speed,
                             double depth, double penetration, double distance, double* out, int stride);
/// RutLog::between of the rut behind a row.
RutLog::Between lane_rut(const Surroundings&, int leader, double distance, std::size_t& near);
/// Depth and inclination, each value and slope.
void lane_profile(const Plant&, double distance, double half_patch, double* out, int stride);
/// The bed's first and last pieces.
std::array<Profile::Piece, 2> lane_pieces(const Plant&);
/// A lane's numbers of its ground.
struct GroundNumbersOfLane {
  loadtables::TableNumbers table;
  const double* level;  ///< the table along the bed's last piece, or null where that is not level
  double level_depth;
  bool altered;
  double bearing_gain, rolling_resistance;
};
GroundNumbersOfLane lane_numbers(const Plant&, const LevelTables&, int group);

/// For the widest instruction set this processor has; the caller owns it.
LaneBlock* make_lane_block();
unsigned lanes_of_this_processor();
LaneBlock* make_lane_block_v2();
LaneBlock* make_lane_block_v3();
LaneBlock* make_lane_block_v4();

}  // namespace apc::simulation
