/// Runs of one shape through the lanes of a block: each has its own step size, events, ruts and observer; all attempt
/// one step at a time; a lane that has finished is free for the next run.
#pragma once

#include <exception>
#include <memory>
#include <vector>

#include "apc/simulation/lane_block.h"
#include "apc/simulation/simulate.h"

namespace apc::simulation {

/// What simulate() is asked for. All three must outlive the run.
struct Errand {
  const Model* model = nullptr;
  const Overrun* overrun = nullptr;
  const Options* options = nullptr;
};
/// What simulate() returns or throws.
struct Outturn {
  Result result;
  std::exception_ptr failure;
};

/// Whether lanes know all that a run needs: the fast path without guide, timed thrust, brakes by torque, brakes on
/// bogie beams, response to sinking, or effects on the site.
bool fits_lanes(const Errand&);

class Convoy {
 public:
  /// Owns the block.
  explicit Convoy(const Shape&, LaneBlock* block = make_lane_block());
  ~Convoy();
  const Shape& shape() const { return shape_; }
  std::size_t width() const { return lanes_.size(); }
  std::size_t running() const { return running_; }
  bool has_room() const { return running_ < lanes_.size(); }
  bool empty() const { return running_ == 0 && settled_.empty(); }
  /// The errand must fit lanes and have the convoy's shape. `ticket` comes back with its outturn.
  void add(const Errand&, std::size_t ticket);
  /// One attempted step for all.
  void advance();
  struct Settled {
    std::size_t ticket;
    Outturn outturn;
  };
  /// What has come to its end since it was last asked.
  std::vector<Settled> settled();

 private:
  struct Lane;
  std::shared_ptr<const LevelTables> levels_of(const Plant&);
  void settle(std::size_t lane, Outturn);
  bool close(std::size_t lane, Lane&);
  template <class Work>
  bool guarded(std::size_t lane, const Work&);

  Shape shape_;
  std::unique_ptr<LaneBlock> block_;
  std::vector<std::unique_ptr<Lane>> lanes_;  ///< null: free
  std::size_t running_ = 0;
  std::vector<Settled> settled_;
  std::vector<std::shared_ptr<const LevelTables>> levels_;  ///< shared by lanes of one bed: less to keep in caches
};

}  // namespace apc::simulation
