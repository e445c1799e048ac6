#include "apc/simulation/overrun_run.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/simulation/cvode.h"
#include "apc/simulation/rosenbrock.h"

namespace apc::simulation {

bool enters_with_a_jump(const Plant& plant, int row) {
  const auto& group = plant.groups[static_cast<std::size_t>(plant.rows[static_cast<std::size_t>(row)].group)];
  return plant.profile.steps_in() || group.braking != group.braking_in_bed;
}

Surroundings surroundings_at_entry(const Plant& plant) {
  Surroundings around;
  around.ruts.resize(plant.rows.size());
  for (std::size_t r = 0; r < plant.rows.size(); ++r)
    around.in_bed[r] = r == 0 || !enters_with_a_jump(plant, static_cast<int>(r));
  return around;
}

void write_ruts(const Plant& plant, Surroundings& around, const Moment& moment) {
  for (const auto& row : plant.rows) {
    if (row.ahead < 0) continue;
    const auto r = static_cast<std::size_t>(row.ahead);
    const auto& made = moment.rows[r];
    if (!around.in_bed[r] || made.distance < -1.0) continue;
    Rut rut;
    if (made.penetration > 0.0) {
      const auto& ground = made.ground;
      rut = {ground.load.rut_depth, ground.virgin_penetration, ground.virgin_drag, ground.virgin_vertical};
    }
    around.ruts[r].write(made.distance, rut);
  }
}

void write_ruts(const Plant& plant, Surroundings& around, double t, const double* y) {
  std::array<double, most_states> rate;
  Moment moment;
  derivatives(plant, around, t, y, rate.data(), &moment);
  write_ruts(plant, around, moment);
}

double longest_way(const Plant& plant) {
  double reach = 2.0;
  for (const auto& row : plant.rows)
    if (row.ahead >= 0)
      reach = std::min(reach, 0.7 * (plant.rows[static_cast<std::size_t>(row.ahead)].offset - row.offset));
  if (!plant.alterations) return reach;
  for (const auto& each : plant.alterations->effects) {  // narrow places (joints) must not be stepped over
    if (each.values.empty() || each.values.front() == each.effect.parameters.front().neutral) continue;
    for (std::size_t k = 1; k < each.values.size(); ++k)
      if (each.effect.parameters[k].name == "width") reach = std::min(reach, 0.8 * each.values[k]);
  }
  return reach;
}

std::vector<double> absolute_tolerances(const Plant& plant, double rtol) {
  const double scale = rtol / 1e-6;
  const int n = plant.degrees(), groups = static_cast<int>(plant.groups.size());
  std::vector<double> absolute;
  for (int i = 0; i < plant.states(); ++i) {
    const int k = i < n ? i : i - n;
    const bool angle = i < 2 * n && (k == 2 || k >= 3 + groups);
    absolute.push_back(scale * (i >= 2 * n || i == 0 ? 1e-5 : angle ? 1e-7 : 1e-6));
  }
  return absolute;
}

double cg_speed(const Plant& plant, const double* y) {
  const double* rate = y + plant.degrees();
  return rate[0] - rate[2] * (plant.cg.x * std::sin(y[2]) + plant.cg.z * std::cos(y[2]));
}

namespace {

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

enum class Event { none, row, stop, far_end };

template <class Solver>
class Course {
 public:
  Course(const Plant& plant, Surroundings& around, Solver& solver, Observer& observer)
      : plant_(plant),
        around_(around),
        solver_(solver),
        observer_(observer),
        y_(static_cast<std::size_t>(plant.states())),
        rate_(y_.size()) {
    for (int r = 1; r < static_cast<int>(plant.rows.size()); ++r)
      if (!around.in_bed[static_cast<std::size_t>(r)]) waiting_.push_back(r);
    for (const auto& row : plant.rows) any_follower_ = any_follower_ || row.ahead >= 0;
  }

  Ending run(const std::vector<double>& start, double time_limit) {
    y_ = start;
    solver_.start(0.0, y_);
    look(0.0);
    write_ruts(plant_, around_, moment_);
    if (observer_.interval() == 0.0) observer_.see(0.0, y_.data(), around_, moment_, 0.0);
    power_ = powers(plant_, around_, y_.data(), moment_);
    for (;;) {
      const double before = solver_.time();
      solver_.step();
      double until = solver_.time();
      const Event event = next_event(before, until);
      observe(before, until);
      if (event == Event::stop || event == Event::far_end) return ending(event, until);
      if (event == Event::row) {
        solver_.state(until, y_.data());
        restart(until);
      }
      if (until > time_limit)
        throw SolveError(concat("still rolling at ", cg_speed(plant_, y_.data()), " m/s after ", until, " s, ",
                                nose_distance(plant_, y_.data()),
                                " m into the bed. Is thrust larger than the drag? Raise the time limit otherwise"),
                         until);
    }
  }

 private:
  /// The earliest event in the step; `until` is moved to it.
  Event next_event(double before, double& until) {
    Event event = Event::none;
    const auto look_for = [&](Event kind, const auto& crossed) {
      solver_.state(until, y_.data());
      if (crossed(y_.data()) < 0.0) return false;
      until = crossing(solver_, before, until, y_.data(), crossed);
      event = kind;
      return true;
    };
    look_for(Event::far_end, [&](const double* y) { return nose_distance(plant_, y) - plant_.profile.length(); });
    look_for(Event::stop, [&](const double* y) { return creep_speed - cg_speed(plant_, y); });
    for (const int row : waiting_)
      if (look_for(Event::row, [&](const double* y) { return row_motion(plant_, row, y)[0]; })) entering_ = row;
    return event;
  }

  void look(double t) { derivatives(plant_, around_, t, y_.data(), rate_.data(), &moment_); }

  /// State and moment at `t`; where a step ends, the solver has the moment at hand.
  const Moment& instant(double t) {
    solver_.state(t, y_.data());
    if constexpr (!std::is_same_v<Solver, Cvode>)
      if (t == solver_.time()) return solver_.moment();
    look(t);
    return moment_;
  }

  /// Grid instants, ruts and (for solvers without quadratures of their own) energy in (before, until].
  void observe(double before, double until) {
    while (observer_.interval() > 0.0 && next_look_ <= until) {
      solver_.state(next_look_, y_.data());
      look(next_look_);
      observer_.see(next_look_, y_.data(), around_, moment_, dissipated_at(next_look_));
      next_look_ = static_cast<double>(++looks_) * observer_.interval();
    }
    constexpr bool has_quadratures = std::is_same_v<Solver, Cvode>;
    int pairs = 1;
    if (any_follower_) {
      solver_.state(before, y_.data());
      const double from = y_[0];
      solver_.state(until, y_.data());
      pairs = std::max(1, static_cast<int>(std::ceil(0.5 * (y_[0] - from) / rut_spacing)));
    }
    if (!has_quadratures || any_follower_) {
      const double part = 0.5 * (until - before) / pairs;
      for (int i = 1; i <= 2 * pairs; ++i) {
        const double t = i == 2 * pairs ? until : before + i * part;
        const auto& moment = instant(t);
        if (any_follower_) write_ruts(plant_, around_, moment);
        if constexpr (!has_quadratures) {
          add_energy(t, part, i, moment);
          if (observer_.interval() == 0.0) observer_.see(t, y_.data(), around_, moment, 0.0);
        }
      }
    }
    if constexpr (has_quadratures) solver_.integrals(until, dissipated_.data());
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
    if constexpr (std::is_same_v<Solver, Cvode>) {
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
    if constexpr (std::is_same_v<Solver, Cvode>) {
      solver_.start(until, y_, {dissipated_.begin(), dissipated_.end()});
    } else {
      solver_.start(until, y_);
    }
    look(until);
    write_ruts(plant_, around_, moment_);
    power_ = powers(plant_, around_, y_.data(), moment_);
  }

  Ending ending(Event event, double until) {
    solver_.state(until, y_.data());
    look(until);
    Ending end;
    end.left_bed = event == Event::far_end;
    end.time = until;
    end.state = y_;
    end.acceleration = moment_.cg_acceleration.x;
    end.dissipated = dissipated_;
    end.statistics = solver_.statistics();
    return end;
  }

  const Plant& plant_;
  Surroundings& around_;
  Solver& solver_;
  Observer& observer_;
  std::vector<double> y_, rate_;
  std::vector<int> waiting_;
  int entering_ = -1;
  bool any_follower_ = false;
  Moment moment_;
  std::array<double, sinks> dissipated_{}, power_{}, half_{};
  double settled_ = 0.0, next_look_ = 0.0;
  long looks_ = 0;
};

}  // namespace

Ending run_reference(const Plant& plant, const std::vector<double>& state, double rtol, double time_limit,
                     Observer& observer) {
  auto around = surroundings_at_entry(plant);
  OdeProblem problem;
  problem.states = plant.states();
  problem.rate = [&](double t, const double* y, double* dydt) { derivatives(plant, around, t, y, dydt); };
  std::vector<double> unused(state.size());
  problem.jacobian = [&](double t, const double* y, double* matrix) {
    jacobian(plant, around, t, y, unused.data(), matrix);
  };
  problem.quadratures = static_cast<int>(sinks);
  Moment moment;
  problem.integrand = [&, rate = std::vector<double>(state.size())](double t, const double* y, double* power) mutable {
    derivatives(plant, around, t, y, rate.data(), &moment);
    const auto now = powers(plant, around, y, moment);
    std::copy(now.begin(), now.end(), power);
  };
  OdeTolerances tolerances{rtol, absolute_tolerances(plant, rtol), longest_way(plant) / plant.entry_speed};
  Cvode solver(std::move(problem), std::move(tolerances));
  return Course<Cvode>(plant, around, solver, observer).run(state, time_limit);
}

Ending run_fast(const Plant& plant, const std::vector<double>& state, double rtol, double time_limit,
                Observer& observer) {
  auto around = surroundings_at_entry(plant);
  Rosenbrock solver(plant, around, rtol, longest_way(plant));
  return Course<Rosenbrock>(plant, around, solver, observer).run(state, time_limit);
}

}  // namespace apc::simulation
