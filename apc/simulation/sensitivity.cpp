#include "apc/simulation/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apc/base/require.h"
#include "apc/simulation/carried_extremes.h"
#include "apc/simulation/carried_works.h"
#include "apc/simulation/cvode.h"
#include "apc/simulation/overrun_run.h"
#include "apc/simulation/sensitivity_result.h"

namespace apc::simulation {
namespace {

using PieceEnd = CarriedExtremes::PieceEnd;

constexpr double beside = 1e-6;         // s before and after a corner: one side of it
constexpr double look_interval = 1e-3;  // s

class Carried {
 public:
  Carried(const Model& model, const Overrun& overrun, const ScalarParameter& parameter, const Options& options)
      : options_(options),
        scale_(parameter.scale),
        runs_(model, overrun, parameter),
        y_(runs_.base.start),
        s_(runs_.start_slope()),
        up_(y_.size()),
        down_(y_.size()),
        solver_(problem(), tolerances()),
        extremes_(runs_, look_interval),
        works_(runs_) {
    const auto& plant = runs_.base.plant;
    for (int r = 1; r < static_cast<int>(plant.rows.size()); ++r)
      if (!runs_.base.around.in_bed[static_cast<std::size_t>(r)]) waiting_.push_back(r);
    for (const auto& row : plant.rows) ruts_ = ruts_ || row.ahead >= 0;
    next_corner_.resize(plant.rows.size());
    for (std::size_t r = 0; r < plant.rows.size(); ++r)
      while (has_corner(r) && way_to_corner(r, y_.data()) < at_corner) ++next_corner_[r];
  }

  Sensitivity run() {
    start(0.0);
    extremes_.see_instant(0.0, {y_, s_});
    write_ruts(0.0, s_);
    for (;;) {
      const double before = solver_.time();
      if (leap_to_corner(before)) continue;
      solver_.step();
      double until = solver_.time();
      Event event = Event::none;
      std::size_t row = 0;
      const Plant& plant = runs_.base.plant;
      if (crossed(before, until, [&](const double* y) { return nose_distance(plant, y) - plant.profile.length(); }))
        event = Event::far_end;
      if (crossed(before, until, [&](const double* y) { return creep_speed - cg_speed(plant, y); }))
        event = Event::rest;
      for (const auto r : waiting_)
        if (crossed(before, until, [&](const double* y) { return row_motion(plant, r, y)[0]; }))
          event = Event::entry, row = static_cast<std::size_t>(r);
      for (std::size_t r = 0; r < next_corner_.size(); ++r)
        if (has_corner(r) && crossed(before, until, [&](const double* y) { return -way_to_corner(r, y); }))
          event = Event::corner, row = r;
      const bool over = event == Event::rest || event == Event::far_end;
      pass(before, until, event == Event::none || over ? PieceEnd::smooth : PieceEnd::corner);
      load(until);
      if (over) return finish(event == Event::rest, until);
      if (event == Event::corner) pass_corner(row, until, 0.0);
      if (event == Event::entry) enter(static_cast<int>(row), until);
      if (until > options_.time_limit)
        throw SolveError(concat("still rolling after ", until, " s while carrying sensitivities. Raise the time limit"),
                         until);
    }
  }

 private:
  enum class Event { none, corner, entry, rest, far_end };

  OdeProblem problem() {
    OdeProblem p;
    p.states = runs_.base.plant.states();
    p.rate = [this](double t, const double* y, double* dydt) { rate(t, y, dydt); };
    p.jacobian = [this, unused = std::vector<double>(y_.size())](double t, const double* y, double* m) mutable {
      jacobian(runs_.base.plant, runs_.base.around, t, y, unused.data(), m);
    };
    p.describe = [this](const double* y) { return in_words(runs_.base.plant, y); };
    p.parameters = 1;
    p.parameter_scales = {scale_};
    p.sensitivity = [this](double t, const double* y, int, const double* s, double* ds) { slope_rate(t, y, s, ds); };
    return p;
  }
  void rate(double t, const double* y, double* dydt) const {
    derivatives(runs_.base.plant, runs_.base.around, t, y, dydt);
  }
  void slope_rate(double t, const double* y, const double* s, double* ds) {
    directional(runs_.base.plant, runs_.base.around, t, y, s, ds);
    derivatives(runs_.up.plant, runs_.up.around, t, y, up_.data());
    derivatives(runs_.down.plant, runs_.down.around, t, y, down_.data());
    for (std::size_t i = 0; i < up_.size(); ++i) ds[i] += (up_[i] - down_[i]) / (2.0 * runs_.epsilon);
  }

  OdeTolerances tolerances() const {
    const auto& plant = runs_.base.plant;
    return {options_.rtol, absolute_tolerances(plant, options_.rtol), longest_way(plant) / plant.entry_speed};
  }

  /// (Re)starts the solver at y_, s_.
  void start(double t) {
    started_ = t, start_y_ = y_, start_s_ = s_;
    start_rate_ = rate_at(t);
    solver_.start(t, start_y_, {}, start_s_);
  }

  /// State and sensitivity at t, in the solver's last step or where it started.
  void load(double t) {
    if (t > started_) {
      solver_.state(t, y_.data());
      solver_.sensitivities(t, s_.data());
    } else {  // an instant that was leapt over
      y_ = start_y_, s_ = start_s_;
      for (std::size_t i = 0; i < y_.size(); ++i) y_[i] += (t - started_) * start_rate_[i];
    }
  }

  /// Moves `until` to where `value` turns from < 0 to ≥ 0, if it does.
  template <class Value>
  bool crossed(double before, double& until, const Value& value) {
    load(until);
    if (value(y_.data()) < 0.0) return false;
    double low = before;
    for (int i = 0; i < 60 && until - low > 1e-13; ++i) {
      const double middle = 0.5 * (low + until);
      load(middle);
      (value(y_.data()) < 0.0 ? low : until) = middle;
    }
    return true;
  }

  static const std::vector<double>& corners(const Variant& variant, std::size_t row) {
    return variant.plant.groups[static_cast<std::size_t>(variant.plant.rows[row].group)].corners;
  }
  bool has_corner(std::size_t row) const { return next_corner_[row] < corners(runs_.base, row).size(); }
  double way_to_corner(std::size_t row, const double* y) const {
    return corners(runs_.base, row)[next_corner_[row]] - row_motion(runs_.base.plant, static_cast<int>(row), y)[0];
  }

  /// The slopes of the equations jump at a corner, and a solver that steps over it may cut its step until it gives up:
  /// it is stopped a hundredth of a millisecond before, and one Runge–Kutta step leads from there to the corner.
  bool leap_to_corner(double t) {
    constexpr double near = 1e-5;  // s
    load(t);
    const auto motion = rate_at(t);
    double soonest = std::numeric_limits<double>::infinity();
    std::size_t row = 0;
    for (std::size_t r = 0; r < next_corner_.size(); ++r) {
      if (!has_corner(r)) continue;
      const double speed = row_motion(runs_.base.plant, static_cast<int>(r), y_.data())[1];
      const double rough = std::max(0.0, way_to_corner(r, y_.data())) / speed;
      const double mean = speed + 0.5 * motion[static_cast<std::size_t>(runs_.base.plant.degrees())] * rough;
      if (!(mean > 0.5 * speed)) continue;
      const double time = rough * speed / mean;
      if (time < soonest) soonest = time, row = r;
    }
    if (soonest > 2.0 * near) {
      solver_.stop_at(t + soonest - near);
      return false;
    }
    runge_kutta(t, soonest);
    pass_corner(row, t + soonest, soonest);
    return true;
  }
  void runge_kutta(double t, double h) {
    const std::size_t n = y_.size();
    auto y = y_, s = s_;
    std::vector<double> k(n), l(n), sum_k(n), sum_l(n);
    const double ahead[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    for (int stage = 0; stage < 4; ++stage) {
      for (std::size_t i = 0; i < n; ++i)
        y[i] = y_[i] + ahead[stage] * h * k[i], s[i] = s_[i] + ahead[stage] * h * l[i];
      rate(t + ahead[stage] * h, y.data(), k.data());
      slope_rate(t + ahead[stage] * h, y.data(), s.data(), l.data());
      for (std::size_t i = 0; i < n; ++i) sum_k[i] += weight[stage] * k[i], sum_l[i] += weight[stage] * l[i];
    }
    for (std::size_t i = 0; i < n; ++i) y_[i] += h * sum_k[i], s_[i] += h * sum_l[i];
  }

  /// What a step of the solver passes, up to an event.
  void pass(double from, double until, PieceEnd end) {
    look_until(until);
    const auto loaded = [this](double t) {
      load(t);
      return CarriedExtremes::State{y_, s_};
    };
    extremes_.see_piece(from, until, loaded, end);
    add_work(from, until);
    write_ruts_between(from, until);
  }

  void look_until(double until) {
    for (double t = next_look_; t <= until; t = next_look_) {
      look(t);
      next_look_ = static_cast<double>(++looks_) * look_interval;
    }
  }
  void look(double t) {
    load(t);
    if (std::abs(y_[2]) > overturning_pitch)
      throw SolveError(concat("the aircraft pitches over at t = ", t, " s (", in_words(runs_.base.plant, y_.data()),
                              "): there is no stop to derive. Lower speed or depth"),
                       t);
    extremes_.see_instant(t, {y_, s_});
  }

  void add_work(double from, double until) {
    if (until - from < 4.0 * beside) return;
    const double begin = from + beside, end = until - beside;
    const auto powers = [&](double t) {
      load(t);
      return works_.at(t, y_, s_);
    };
    const auto first = powers(begin), middle = powers(0.5 * (begin + end));
    works_.add(until - from, first, middle, powers(end));
  }

  /// dt/dp of the instant at which a row comes to a place, which the parameter may move, too.
  template <class Place>
  double later_at(std::size_t row, const Place& place) {
    const auto way = [&](const Variant& v, const double* y) {
      return row_motion(v.plant, static_cast<int>(row), y)[0] - place(v);
    };
    return -runs_.total(y_, s_, way) / row_motion(runs_.base.plant, static_cast<int>(row), y_.data())[1];
  }

  struct Side {
    CarriedExtremes::Side extremes;
    CarriedWorks::Powers powers;
  };
  /// What is seen just before (−1) or after (+1) the state y_, which moves with the corner by `moving`.
  Side side(double t, const std::vector<double>& motion, const std::vector<double>& moving, double sign) {
    auto near = y_;
    for (std::size_t i = 0; i < y_.size(); ++i) near[i] += sign * beside * motion[i];
    return {extremes_.side(t, y_, moving, near, sign * beside), works_.at(t + sign * beside, near, s_)};
  }
  void see_corner(const Side& before, const Side& after, double later) {
    extremes_.see_corner(before.extremes, after.extremes);
    works_.jump(before.powers, after.powers, later);
  }
  std::vector<double> rate_at(double t) const {
    std::vector<double> motion(y_.size());
    rate(t, y_.data(), motion.data());
    return motion;
  }
  std::vector<double> moved(const std::vector<double>& motion, double later) const {
    auto moving = s_;
    for (std::size_t i = 0; i < s_.size(); ++i) moving[i] += motion[i] * later;
    return moving;
  }

  /// y_, s_ are those at the corner; the way to it took `leapt` seconds that no step covers.
  void pass_corner(std::size_t row, double t, double leapt) {
    const auto corner = next_corner_[row]++;
    const double later = later_at(row, [&](const Variant& v) { return corners(v, row)[corner]; });
    const auto motion = rate_at(t), moving = moved(motion, later);
    const auto before = side(t, motion, moving, -1.0);
    works_.add(leapt, before.powers, before.powers, before.powers);
    see_corner(before, side(t, motion, moving, +1.0), later);
    write_ruts(t, moving);
    constexpr double beyond = 1e-9;  // s: on the other side for sure
    for (std::size_t i = 0; i < y_.size(); ++i) y_[i] += beyond * motion[i];
    start(t + beyond);
  }

  /// A row meets the bed where the equations jump.
  void enter(int row, double t) {
    const double later = later_at(static_cast<std::size_t>(row), [](const Variant&) { return 0.0; });
    const auto outside = rate_at(t), moving = moved(outside, later);
    const auto before = side(t, outside, moving, -1.0);
    for (auto* variant : {&runs_.base, &runs_.up, &runs_.down})
      variant->around.in_bed[static_cast<std::size_t>(row)] = true;
    const auto inside = rate_at(t);
    for (std::size_t i = 0; i < s_.size(); ++i) s_[i] += (outside[i] - inside[i]) * later;
    see_corner(before, side(t, inside, moving, +1.0), later);
    write_ruts(t, moving);
    std::erase(waiting_, row);
    start(t);
  }

  /// What y_ leaves behind in each variant, which moves by `moving`: with time (s_) or, where a row is at a corner,
  /// with the corner, so that the track turns at the same place in all of them.
  void write_ruts(double t, const std::vector<double>& moving) {
    if (!ruts_) return;
    simulation::write_ruts(runs_.base.plant, runs_.base.around, t, y_.data());
    runs_.totals(y_, moving, [t](Variant& v, const double* y) {
      simulation::write_ruts(v.plant, v.around, t, y);
      return std::vector<double>{};
    });
  }
  void write_ruts_between(double before, double until) {
    if (!ruts_) return;
    load(before);
    const double from = y_[0];
    load(until);
    const int pieces = std::max(1, static_cast<int>(std::ceil((y_[0] - from) / rut_spacing)));
    for (int i = 1; i <= pieces; ++i) {
      const double t = before + (until - before) * i / pieces;
      load(t);
      if (!shortly_before_corner()) write_ruts(t, s_);
    }
  }
  /// So near that the log would not take the entry at the corner.
  bool shortly_before_corner() const {
    constexpr double near = 1.5e-3;  // m
    for (std::size_t r = 0; r < next_corner_.size(); ++r) {
      const double at = row_motion(runs_.base.plant, static_cast<int>(r), y_.data())[0];
      for (const double place : corners(runs_.base, r))
        if (at < place + 1e-9 && at > place - near) return true;
    }
    return false;
  }

  Sensitivity finish(bool stopped, double t) {
    auto result = sensitivity_at_end(runs_, stopped, t, y_, s_, works_);
    extremes_.fill(result);
    result.solver = solver_.statistics();
    return result;
  }

  Options options_;
  double scale_;
  Neighbours runs_;
  std::vector<double> y_, s_, up_, down_;
  double started_ = 0.0;
  std::vector<double> start_y_, start_s_, start_rate_;
  Cvode solver_;
  CarriedExtremes extremes_;
  CarriedWorks works_;
  std::vector<int> waiting_;
  std::vector<std::size_t> next_corner_;  ///< per row, of its group's
  bool ruts_ = false;
  double next_look_ = look_interval;
  long looks_ = 1;
};

}  // namespace

Sensitivity sensitivity(const Model& model, const Overrun& overrun, const ScalarParameter& parameter,
                        const Options& options) {
  require(parameter.step > 0.0 && parameter.scale > 0.0 && parameter.shift, "the parameter ", parameter.name,
          " needs a positive step, a positive scale and a shift");
  Carried carried(model, overrun, parameter, options);
  auto result = carried.run();
  result.parameter = parameter.name;
  return result;
}

}  // namespace apc::simulation
