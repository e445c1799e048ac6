#include "apc/simulation/convoy.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "apc/simulation/course.h"
#include "apc/simulation/prepared.h"
#include "apc/simulation/rosenbrock.h"

namespace apc::simulation {
namespace {

constexpr std::size_t widest = 8;

/// Rosenbrock's part in a Course, played by a lane.
class LaneSolver {
 public:
  LaneSolver(LaneBlock& block, int lane, const Plant& plant, const Surroundings& around, double rtol)
      : block_(block), lane_(lane), plant_(plant), around_(around), control_(rtol, longest_way(plant)) {
    statistics_.method = "RODAS4";
    statistics_.rtol = rtol;
  }

  void start(double t, const std::vector<double>& y) {
    time_ = previous_ = t;
    y_ = y;
    block_.set_state(lane_, y.data());
    block_.set_rows_in_bed(lane_);
    control_.start();
    linearised_ = false;
  }
  double time() const { return time_; }
  void state(double t, double* y) const {
    if (t == time_)
      std::copy(y_.begin(), y_.end(), y);
    else
      block_.dense(lane_, theta(t), y);
  }
  double theta(double t) const { return (t - previous_) / (time_ - previous_); }

  /// The Jacobian of the lane belongs to its present state.
  void linearised() {
    if (linearised_) return;
    block_.present(lane_, moment_);
    count_linearisation();
  }
  /// Where the block has just looked, else null.
  const Moment* looked(double t, double* y) {
    if (t != looked_at_) return nullptr;
    block_.looked(lane_, y, looked_);
    return &looked_;
  }
  const Moment* known(double t, double* y) {
    if (const auto* between = looked(t, y)) return between;
    state(t, y);
    if (t != time_) return nullptr;
    if (!linearised_) {  // an event at the very end of a step
      std::vector<double> rate(y_.size()), matrix(y_.size() * y_.size());
      jacobian(plant_, around_, t, y, rate.data(), matrix.data(), &moment_);
      count_linearisation();
    }
    return &moment_;
  }
  /// Instant for which the block has looked.
  void looks_at(double t) { looked_at_ = t; }

  double next_step() {
    return control_.step(y_[static_cast<std::size_t>(plant_.degrees())], time_to_corner(plant_, moment_));
  }
  bool judge(double h, double size) {
    statistics_.rhs_calls += 5;
    if (!control_.accepts(size, time_, y_.data(), plant_)) {
      ++statistics_.error_test_failures;
      return false;
    }
    previous_ = time_;
    time_ += h;
    ++statistics_.steps;
    linearised_ = false;
    return true;
  }
  void arrived() { block_.get_state(lane_, y_.data()); }
  SolverStatistics statistics() const { return statistics_; }

 private:
  void count_linearisation() {
    ++statistics_.jacobians;
    ++statistics_.rhs_calls;
    linearised_ = true;
  }

  LaneBlock& block_;
  int lane_;
  const Plant& plant_;
  const Surroundings& around_;
  StepControl control_;
  std::vector<double> y_;
  double time_ = 0.0, previous_ = 0.0, looked_at_ = NAN;
  bool linearised_ = false;
  Moment moment_, looked_;
  SolverStatistics statistics_;
};

}  // namespace

bool fits_lanes(const Errand& errand) {
  const auto& overrun = *errand.overrun;
  return errand.options->method == Method::fast && overrun.brake_mode == BrakeMode::friction &&
         !overrun.sinking.counts() && !overrun.alterations.guide && !overrun.alterations.alter_thrust() &&
         !alters_site(overrun) && std::ranges::all_of(errand.model->aircraft.gears, [](const auto& gear) {
           return gear.axles == 1 || gear.brake_rods;
         });
}

struct Convoy::Lane {
  Lane(const Errand& asked, std::size_t of, Convoy& convoy, LaneBlock& block, int lane)
      : errand(asked),
        ticket(of),
        prepared(*asked.model, *asked.overrun, *asked.options),
        levels(convoy.levels_of(prepared.plant)),
        around(surroundings_at_entry(prepared.plant)),
        solver(block, lane, prepared.plant, around, fast_tolerance(prepared.plant) * asked.options->rtol),
        course(prepared.plant, around, solver, prepared.observer, asked.options->time_limit) {
    block.put(lane, prepared.plant, *levels, around);
    course.begin(prepared.start.state);
  }

  Errand errand;
  std::size_t ticket;
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  Prepared prepared;
  std::shared_ptr<const LevelTables> levels;
  Surroundings around;
  LaneSolver solver;
  Course<LaneSolver> course;
  Stretch passed;
  bool open = false;  ///< the end of `passed` has still to be looked at
};

Convoy::Convoy(const Shape& shape, LaneBlock* block) : shape_(shape), block_(block) {
  const auto weights = error_weights(shape.groups, shape.bogies, shape.rows);
  block_->reshape(shape, weights.constant.data(), weights.by_size.data());
  lanes_.resize(static_cast<std::size_t>(block_->width()));
}
Convoy::~Convoy() = default;

std::shared_ptr<const LevelTables> Convoy::levels_of(const Plant& plant) {
  for (const auto& each : levels_)
    if (each->serve(plant)) return each;
  if (levels_.size() > 2 * widest) std::erase_if(levels_, [](const auto& each) { return each.use_count() == 1; });
  return levels_.emplace_back(std::make_shared<const LevelTables>(plant));
}

void Convoy::settle(std::size_t lane, Outturn outturn) {
  settled_.push_back({lanes_[lane]->ticket, std::move(outturn)});
  block_->take_out(static_cast<int>(lane));
  lanes_[lane].reset();
  --running_;
}

/// What a run throws is its own outturn.
template <class Work>
bool Convoy::guarded(std::size_t lane, const Work& work) {
  try {
    return work();
  } catch (...) {
    settle(lane, {{}, std::current_exception()});
    return false;
  }
}

/// The end of a run's last stretch; a run that has ended there is settled.
bool Convoy::close(std::size_t lane, Lane& run) {
  if (!run.course.close(run.passed)) return false;
  const auto end = run.course.ending(run.passed);
  const auto& errand = run.errand;
  Outturn outturn{finish(*errand.model, *errand.overrun, *errand.options, run.prepared, end), nullptr};
  outturn.result.solver.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - run.began).count();
  settle(lane, std::move(outturn));
  return true;
}

void Convoy::add(const Errand& errand, std::size_t ticket) {
  std::size_t lane = 0;
  while (lanes_[lane]) ++lane;
  try {
    lanes_[lane] = std::make_unique<Lane>(errand, ticket, *this, *block_, static_cast<int>(lane));
    ++running_;
  } catch (...) {
    block_->take_out(static_cast<int>(lane));
    settled_.push_back({ticket, {{}, std::current_exception()}});
  }
}

std::vector<Convoy::Settled> Convoy::settled() { return std::exchange(settled_, {}); }

void Convoy::advance() {
  alignas(64) double time[widest] = {}, h[widest] = {}, error[widest] = {}, theta[widest] = {};
  bool chosen[widest] = {};
  const auto each = [&](const auto& work) {
    for (std::size_t l = 0; l < lanes_.size(); ++l)
      if (lanes_[l]) work(l, *lanes_[l]);
  };

  // Where the runs are; it closes their last stretches.
  each([&](std::size_t l, Lane& run) { time[l] = run.solver.time(); });
  block_->linearise(time);
  each([&](std::size_t l, Lane& run) {
    run.solver.linearised();
    if (!std::exchange(run.open, false)) return;
    guarded(l, [&] { return close(l, run); });
  });

  for (auto& step : h) step = 1e-3;
  each([&](std::size_t l, Lane& run) { h[l] = run.solver.next_step(); });
  block_->attempt(time, h, error);
  each([&](std::size_t l, Lane& run) { chosen[l] = guarded(l, [&] { return run.solver.judge(h[l], error[l]); }); });
  block_->accept(chosen);

  // Events; then what is seen between, together where nothing happened.
  each([&](std::size_t l, Lane& run) {
    if (!chosen[l]) return;
    run.solver.arrived();
    run.passed = run.course.stretch(time[l]);
    run.open = run.passed.event == Event::none;
  });
  const auto together = [&](const auto& wanted, const auto& instant, const auto& see) {
    bool any_look = false, looks[widest] = {};
    each([&](std::size_t l, Lane& run) {
      looks[l] = chosen[l] && run.open && wanted(run);
      if (!looks[l]) return;
      any_look = true;
      time[l] = instant(run);
      theta[l] = run.solver.theta(time[l]);
      run.solver.looks_at(time[l]);
    });
    if (!any_look) return false;
    block_->look(time, theta, looks);
    each([&](std::size_t l, Lane& run) {
      if (looks[l]) see(run), run.solver.looks_at(NAN);
    });
    return true;
  };
  while (together([](const Lane& run) { return run.course.on_grid(run.passed); },
                  [](const Lane& run) { return run.course.grid_instant(); },
                  [](Lane& run) { run.course.look_on_grid(); })) {
  }
  for (int index = 1; together([&](const Lane& run) { return index < 2 * run.passed.pairs; },
                               [&](const Lane& run) { return run.passed.instant(index); },
                               [&](Lane& run) { run.course.look_at(run.passed, index); });
       ++index) {
  }
  each([&](std::size_t l, Lane& run) {
    if (!chosen[l] || run.open) return;
    guarded(l, [&] {
      run.course.look_between(run.passed);
      return close(l, run);
    });
  });
}

}  // namespace apc::simulation
