/// The course of one run, whatever steps it: events at jumps, ruts, observation, energy. What happens after a step
/// comes in three parts, so that runs side by side can do the costly ones together: stretch(), look_between(), close().
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "apc/base/require.h"
#include "apc/simulation/cvode.h"
#include "apc/simulation/overrun_run.h"

namespace apc::simulation {

/// Time in (t0, t1] where `crossed(state)` turns from < 0 to ≥ 0: bisection on dense output to 1e-13 s.
template <class Solver, class Crossed>
double crossing(const Solver& solver, double t0, double t1, double* y, const Crossed& crossed) {
  for (int i = 0; i < 60 && t1 - t0 > 1e-13; ++i) {
    const double middle = 0.5 * (t0 + t1);
    solver.state(middle, y);
    (crossed(y) < 0.0 ? t0 : t1) = middle;
  }
  solver.state(t1, y);
  return t1;
}

enum class Event { none, row, stop, far_end, pitched_over };

/// From the end of the last stretch to the end of a step, or to an event within it; observed at the ends of
/// 2 × `pairs` parts.
struct Stretch {
  double before = 0.0, until = 0.0;
  Event event = Event::none;
  int pairs = 1;
  double part() const { return 0.5 * (until - before) / pairs; }
  double instant(int index) const { return before + index * part(); }
};

template <class Solver>
class Course {
 public:
  Course(const Plant& plant, Surroundings& around, Solver& solver, Observer& observer, double time_limit)
      : plant_(plant),
        around_(around),
        solver_(solver),
        observer_(observer),
        time_limit_(time_limit),
        y_(static_cast<std::size_t>(plant.states())),
        rate_(y_.size()) {
    for (int r = 1; r < static_cast<int>(plant.rows.size()); ++r)
      if (!around.in_bed[static_cast<std::size_t>(r)]) waiting_.push_back(r);
    for (const auto& row : plant.rows) any_follower_ = any_follower_ || row.ahead >= 0;
    narrow_ = has_narrow_pieces(plant);
  }

  Ending run(const std::vector<double>& start) {
    begin(start);
    for (;;) {
      const double before = solver_.time();
      if constexpr (has_quadratures)
        if (narrow_) solver_.stop_at(before + time_to_corner_from(before));
      solver_.step();
      const auto passed = stretch(before);
      look_between(passed);
      if (close(passed)) return ending(passed);
    }
  }

  void begin(const std::vector<double>& start) {
    y_ = start;
    way_ = y_[0];
    solver_.start(0.0, y_);
    look(0.0);
    started_ = 0.0;
    write_ruts(plant_, around_, moment_);
    if (observer_.interval() == 0.0) observer_.see(0.0, y_.data(), around_, moment_, 0.0);
    power_ = powers(plant_, around_, y_.data(), moment_);
  }

  /// What of the solver's last step counts: up to the earliest event in it.
  Stretch stretch(double before) {
    Stretch passed{before, solver_.time(), Event::none, 1};
    passed.event = next_event(before, passed.until);
    if (any_follower_) passed.pairs = std::max(1, static_cast<int>(std::ceil(0.5 * (y_[0] - way_) / rut_spacing)));
    way_ = y_[0];
    slow_ = cg_speed(plant_, y_.data()) < 5.0 * creep_speed;
    return passed;
  }

  /// Grid instants; then ruts and (for solvers without quadratures of their own) energy within a stretch.
  void look_between(const Stretch& passed) {
    while (on_grid(passed)) look_on_grid();
    if (!has_quadratures || any_follower_)
      for (int i = 1; i < 2 * passed.pairs; ++i) look_at(passed, i);
  }
  /// Whether the observer's next grid instant lies in the stretch; when it is; and seeing it.
  bool on_grid(const Stretch& passed) const { return observer_.interval() > 0.0 && next_look_ <= passed.until; }
  double grid_instant() const { return next_look_; }
  void look_on_grid() {
    const Moment* moment = nullptr;
    if constexpr (requires { solver_.looked(next_look_, y_.data()); }) moment = solver_.looked(next_look_, y_.data());
    if (!moment) {
      solver_.state(next_look_, y_.data());
      look(next_look_);
      moment = &moment_;
    }
    observer_.see(next_look_, y_.data(), around_, *moment, dissipated_at(next_look_));
    next_look_ = static_cast<double>(++looks_) * observer_.interval();
  }
  /// The end of one of the stretch's parts.
  void look_at(const Stretch& passed, int index) { see(passed, index, passed.instant(index)); }

  /// The end of a stretch; true when the run has ended there.
  bool close(const Stretch& passed) {
    if (narrow_ && observer_.interval() > 0.0) look_aside(passed.until);
    if (!has_quadratures || any_follower_) see(passed, 2 * passed.pairs, passed.until);
    if constexpr (has_quadratures) solver_.integrals(passed.until, dissipated_.data());
    if (passed.event != Event::none && passed.event != Event::row) return true;
    if (passed.event == Event::none && slow_) {
      solver_.state(passed.until, y_.data());
      look(passed.until);
      unfaded_ = held_up_by_fading(plant_, around_, passed.until, y_.data(), moment_);
      if (unfaded_ > 0.0) return true;
    }
    if (passed.event == Event::row) {
      solver_.state(passed.until, y_.data());
      restart(passed.until);
    }
    if (passed.until > time_limit_) {
      solver_.state(passed.until, y_.data());
      look(passed.until);
      throw SolveError(concat("did not stop: still rolling at ", cg_speed(plant_, y_.data()), " m/s after ",
                              passed.until, " s, ", nose_distance(plant_, y_.data()),
                              " m into the bed, with a deceleration of ", -moment_.cg_acceleration.x,
                              " m/s^2. Is thrust (or a falling grade) as large as the drag? Lower it, brake, or raise "
                              "the time limit"),
                       passed.until);
    }
    return false;
  }

  Ending ending(const Stretch& passed) {
    solver_.state(passed.until, y_.data());
    look(passed.until);
    Ending end;
    end.end = passed.event == Event::far_end        ? End::far_end
              : passed.event == Event::pitched_over ? End::pitched_over
                                                    : End::rest;
    end.time = passed.until;
    end.state = y_;
    end.acceleration = moment_.cg_acceleration.x;
    end.unfaded = unfaded_;
    end.dissipated = dissipated_;
    end.statistics = solver_.statistics();
    return end;
  }

 private:
  static constexpr bool has_quadratures = std::is_same_v<Solver, Cvode>;

  /// The earliest event in the step; `until` is moved to it, and the state is the one there.
  Event next_event(double before, double& until) {
    Event event = Event::none;
    solver_.state(until, y_.data());
    const auto look_for = [&](Event kind, const auto& crossed) {
      if (crossed(y_.data()) < 0.0) return false;
      until = crossing(solver_, before, until, y_.data(), crossed);
      event = kind;
      return true;
    };
    look_for(Event::far_end, [&](const double* y) { return nose_distance(plant_, y) - plant_.profile.length(); });
    look_for(Event::stop, [&](const double* y) { return creep_speed - cg_speed(plant_, y); });
    look_for(Event::pitched_over, [](const double* y) { return std::abs(y[2]) - overturning_pitch; });
    for (const int row : waiting_)
      if (look_for(Event::row, [&](const double* y) { return row_motion(plant_, row, y)[0]; })) entering_ = row;
    return event;
  }

  void look(double t) { derivatives(plant_, around_, t, y_.data(), rate_.data(), &moment_); }

  /// State and moment at `t`, from the solver where it has them at hand.
  const Moment& instant(double t) {
    if constexpr (has_quadratures) {
      solver_.state(t, y_.data());
    } else {
      if (const auto* known = solver_.known(t, y_.data())) return *known;
    }
    look(t);
    return moment_;
  }

  /// From a solver's step or, right after a start, from the state it started with.
  double time_to_corner_from(double t) {
    if (t > started_) {
      solver_.state(t, y_.data());
      look(t);
    }
    return time_to_corner(plant_, moment_);
  }
  /// Where a bed has narrow pieces a load may come and go between two instants of the grid; steps end at their corners.
  void look_aside(double t) {
    solver_.state(t, y_.data());
    look(t);
    observer_.see_between(t, y_.data(), around_, moment_);
  }

  void see(const Stretch& passed, int index, double t) {
    const auto& moment = instant(t);
    if (any_follower_) write_ruts(plant_, around_, moment);
    if constexpr (!has_quadratures) {
      add_energy(t, passed.part(), index, moment);
      if (observer_.interval() == 0.0) observer_.see(t, y_.data(), around_, moment, 0.0);
    }
  }

  /// Simpson over pairs of parts of a step.
  void add_energy(double t, double part, int index, const Moment& moment) {
    const auto now = powers(plant_, around_, y_.data(), moment);
    if (index % 2 == 1) {
      half_ = now;
      return;
    }
    for (std::size_t i = 0; i < sinks; ++i) dissipated_[i] += part / 3.0 * (power_[i] + 4.0 * half_[i] + now[i]);
    power_ = now;
    settled_ = t;
  }

  double dissipated_at(double t) {
    double sum = 0.0;
    if constexpr (has_quadratures) {
      std::array<double, sinks> now{};
      if (t > 0.0) solver_.integrals(t, now.data());
      for (const double each : now) sum += each;
    } else {
      for (std::size_t i = 0; i < sinks; ++i) sum += dissipated_[i] + power_[i] * (t - settled_);
    }
    return sum;
  }

  void restart(double until) {
    around_.in_bed[static_cast<std::size_t>(entering_)] = true;
    std::erase(waiting_, entering_);
    if constexpr (has_quadratures) {
      solver_.start(until, y_, {dissipated_.begin(), dissipated_.end()});
    } else {
      solver_.start(until, y_);
    }
    look(until);
    started_ = until;
    write_ruts(plant_, around_, moment_);
    power_ = powers(plant_, around_, y_.data(), moment_);
  }

  const Plant& plant_;
  Surroundings& around_;
  Solver& solver_;
  Observer& observer_;
  double time_limit_;
  std::vector<double> y_, rate_;
  std::vector<int> waiting_;
  int entering_ = -1;
  bool any_follower_ = false, narrow_ = false;
  Moment moment_;
  std::array<double, sinks> dissipated_{}, power_{}, half_{};
  double settled_ = 0.0, next_look_ = 0.0, started_ = 0.0;
  double way_ = 0.0;  ///< X at the end of the last stretch
  long looks_ = 0;
  bool slow_ = false;     ///< at the end of the last stretch: the drag fades
  double unfaded_ = 0.0;  ///< m/s², as in Ending
};

}  // namespace apc::simulation
