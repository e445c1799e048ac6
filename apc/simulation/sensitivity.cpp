#include "apc/simulation/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apc/base/require.h"
#include "apc/simulation/cvode.h"
#include "apc/simulation/observer.h"
#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"

namespace apc::simulation {
namespace {

/// Model, overrun and plant at p, p + ε or p − ε, with ruts of its own.
struct Variant {
  Model model;
  Overrun overrun;
  Plant plant;
  Surroundings around;
  std::vector<double> start;

  Variant(const Model& base, const Overrun& run, const ScalarParameter& parameter, double amount)
      : model(base), overrun(run) {
    if (amount != 0.0) parameter.shift(model, overrun, amount);
    effects::Site site{
        model.aircraft, model.bed, overrun.mass > 0.0 ? overrun.mass : model.aircraft.mass,
        overrun.cg_behind_nose_gear > 0.0 ? overrun.cg_behind_nose_gear : model.aircraft.cg_behind_nose_gear};
    effects::alter_site(overrun.alterations, site);
    overrun.headwind += site.headwind;
    plant = make_plant(model, overrun);
    around = surroundings_at_entry(plant);
    start = trim(plant, overrun.entry_speed).state;
  }
  Variant(const Variant&) = delete;
  Variant& operator=(const Variant&) = delete;
};

class Carried {
 public:
  Carried(const Model& model, const Overrun& overrun, const ScalarParameter& parameter, const Options& options)
      : epsilon_(parameter.step),
        options_(options),
        scale_(parameter.scale),
        base_(model, overrun, parameter, 0.0),
        up_(model, overrun, parameter, epsilon_),
        down_(model, overrun, parameter, -epsilon_),
        y_(base_.start),
        s_(y_.size()),
        rate_(y_.size()),
        solver_(problem(), tolerances()),
        peaks_(1 + 2 * base_.plant.groups.size()) {
    for (std::size_t i = 0; i < s_.size(); ++i) s_[i] = (up_.start[i] - down_.start[i]) / (2.0 * epsilon_);
    for (int r = 1; r < static_cast<int>(base_.plant.rows.size()); ++r)
      if (!base_.around.in_bed[static_cast<std::size_t>(r)]) waiting_.push_back(r);
    for (const auto& row : base_.plant.rows) ruts_ = ruts_ || row.ahead >= 0;
  }

  Sensitivity run() {
    solver_.start(0.0, y_, {}, s_);
    see(0.0);
    write_ruts(0.0);
    for (;;) {
      const double before = solver_.time();
      solver_.step();
      double until = solver_.time();
      Stop stop = Stop::none;
      const auto first = [&](Stop kind, const auto& crossed) {
        if (value_at(until, crossed) < 0.0) return false;
        double low = before;
        for (int i = 0; i < 60 && until - low > 1e-13; ++i) {
          const double middle = 0.5 * (low + until);
          (value_at(middle, crossed) < 0.0 ? low : until) = middle;
        }
        stop = kind;
        return true;
      };
      const Plant& plant = base_.plant;
      first(Stop::far_end, [&](const double* y) { return nose_distance(plant, y) - plant.profile.length(); });
      first(Stop::rest, [&](const double* y) { return creep_speed - cg_speed(plant, y); });
      int entering = -1;
      for (const int row : waiting_)
        if (first(Stop::row, [&](const double* y) { return row_motion(plant, row, y)[0]; })) entering = row;
      for (double t = next_look_; t <= until; t = next_look_) {
        see(t);
        next_look_ = static_cast<double>(++looks_) * 1e-3;
      }
      if (ruts_) write_ruts_between(before, until);
      if (stop == Stop::rest || stop == Stop::far_end) return finish(stop, until);
      if (stop == Stop::row) enter(entering, until);
      if (until > options_.time_limit)
        throw SolveError(concat("still rolling after ", until, " s while carrying sensitivities. Raise the time limit"),
                         until);
    }
  }

 private:
  enum class Stop { none, row, rest, far_end };

  OdeProblem problem() {
    OdeProblem p;
    p.states = base_.plant.states();
    p.rate = [this](double t, const double* y, double* dydt) { derivatives(base_.plant, base_.around, t, y, dydt); };
    p.jacobian = [this, unused = std::vector<double>(base_.start.size())](double t, const double* y,
                                                                          double* m) mutable {
      jacobian(base_.plant, base_.around, t, y, unused.data(), m);
    };
    p.describe = [this](const double* y) { return in_words(base_.plant, y); };
    p.parameters = 1;
    p.parameter_scales = {scale_};
    p.sensitivity = [this, up = std::vector<double>(base_.start.size()),
                     down = std::vector<double>(base_.start.size())](double t, const double* y, int, const double* s,
                                                                     double* ds) mutable {
      directional(base_.plant, base_.around, t, y, s, ds);
      derivatives(up_.plant, up_.around, t, y, up.data());
      derivatives(down_.plant, down_.around, t, y, down.data());
      for (std::size_t i = 0; i < up.size(); ++i) ds[i] += (up[i] - down[i]) / (2.0 * epsilon_);
    };
    return p;
  }

  OdeTolerances tolerances() const {
    return {options_.rtol, absolute_tolerances(base_.plant, options_.rtol),
            longest_way(base_.plant) / base_.plant.entry_speed};
  }

  template <class Crossed>
  double value_at(double t, const Crossed& crossed) {
    solver_.state(t, y_.data());
    return crossed(y_.data());
  }

  /// State and sensitivity at t, and the states of the neighbours p ± ε at the same time.
  void load(double t) {
    solver_.state(t, y_.data());
    solver_.sensitivities(t, s_.data());
    above_ = below_ = y_;
    for (std::size_t i = 0; i < s_.size(); ++i) above_[i] += epsilon_ * s_[i], below_[i] -= epsilon_ * s_[i];
  }

  /// d/dp of a function of (variant, state).
  template <class F>
  double total(const F& f) const {
    return (f(up_, above_.data()) - f(down_, below_.data())) / (2.0 * epsilon_);
  }

  std::vector<double> channels(const Variant& variant, double t, const double* y) {
    Moment moment;
    derivatives(variant.plant, variant.around, t, y, rate_.data(), &moment);
    std::vector<double> values{-moment.cg_acceleration.x};
    for (std::size_t g = 0; g < variant.plant.groups.size(); ++g)
      for (const double each : group_load(variant.plant, g, moment))
        values.push_back(each / variant.plant.groups[g].struts);
    return values;
  }

  /// Channel values and their derivatives at t; a maximum between three instants is taken at the parabola's vertex, the
  /// derivative there between its neighbours (it changes fast where the parameter moves the peak in time).
  void see(double t) {
    load(t);
    if (std::abs(y_[2]) > overturning_pitch)
      throw SolveError(concat("the aircraft pitches over at t = ", t, " s (", in_words(base_.plant, y_.data()),
                              "): there is no stop to derive. Lower speed or depth"),
                       t);
    const auto now = channels(base_, t, y_.data());
    const auto up = channels(up_, t, above_.data()), down = channels(down_, t, below_.data());
    std::vector<std::array<double, 2>> latest(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      latest[i] = {now[i], (up[i] - down[i]) / (2.0 * epsilon_)};
      if (now[i] > peaks_[i][0]) peaks_[i] = latest[i];
      if (before_.empty()) continue;
      const auto &a = before_[i], &b = last_[i];
      const double curvature = a[0] - 2.0 * b[0] + now[i];
      if (b[0] < a[0] || b[0] < now[i] || b[0] < peaks_[i][0] || curvature >= 0.0) continue;
      const double shift = 0.5 * (a[0] - now[i]) / curvature;  // in instants, within ±½
      const auto& side = shift < 0.0 ? a : latest[i];
      peaks_[i][1] = b[1] + std::abs(shift) * (side[1] - b[1]);
    }
    before_ = std::move(last_);
    last_ = std::move(latest);
  }

  void write_ruts(double t) {
    load(t);
    simulation::write_ruts(base_.plant, base_.around, t, y_.data());
    simulation::write_ruts(up_.plant, up_.around, t, above_.data());
    simulation::write_ruts(down_.plant, down_.around, t, below_.data());
  }

  void write_ruts_between(double before, double until) {
    solver_.state(before, y_.data());
    const double from = y_[0];
    solver_.state(until, y_.data());
    const int pieces = std::max(1, static_cast<int>(std::ceil((y_[0] - from) / rut_spacing)));
    for (int i = 1; i <= pieces; ++i) write_ruts(before + (until - before) * i / pieces);
  }

  void enter(int row, double t) {
    load(t);
    const double speed = row_motion(base_.plant, row, y_.data())[1];
    const double later =
        -total([row](const Variant& v, const double* y) { return row_motion(v.plant, row, y)[0]; }) / speed;
    std::vector<double> before(y_.size()), after(y_.size());
    derivatives(base_.plant, base_.around, t, y_.data(), before.data());
    for (auto* variant : {&base_, &up_, &down_}) variant->around.in_bed[static_cast<std::size_t>(row)] = true;
    derivatives(base_.plant, base_.around, t, y_.data(), after.data());
    for (std::size_t i = 0; i < s_.size(); ++i) s_[i] += (before[i] - after[i]) * later;
    std::erase(waiting_, row);
    const auto y = y_, s = s_;
    solver_.start(t, y, {}, s);
    if (ruts_) write_ruts(t);
  }

  Sensitivity finish(Stop stop, double t) {
    load(t);
    derivatives(base_.plant, base_.around, t, y_.data(), rate_.data());
    const auto n = static_cast<std::size_t>(base_.plant.degrees());
    const double deceleration_rate = rate_[n];
    const double distance = total([](const Variant& v, const double* y) { return nose_distance(v.plant, y); });
    const double speed = total([](const Variant& v, const double* y) { return cg_speed(v.plant, y); });
    const double nose_speed = row_motion(base_.plant, 0, y_.data())[1];
    Sensitivity result;
    if (stop == Stop::rest) {
      result.stop_distance = distance - nose_speed * speed / deceleration_rate;
    } else {
      result.outcome = Outcome::left_bed;
      result.stop_distance = std::numeric_limits<double>::quiet_NaN();
      result.exit_speed = speed - deceleration_rate * distance / nose_speed;
    }
    result.peak_deceleration = peaks_[0][1];
    for (std::size_t g = 0; g < base_.plant.groups.size(); ++g)
      result.gears.push_back({base_.plant.groups[g].name, peaks_[1 + 2 * g][1], peaks_[2 + 2 * g][1]});
    result.solver = solver_.statistics();
    return result;
  }

  double epsilon_;
  Options options_;
  double scale_;
  Variant base_, up_, down_;
  std::vector<double> y_, s_, rate_, above_, below_;
  Cvode solver_;
  std::vector<std::array<double, 2>> peaks_, last_, before_;  ///< {value, derivative} per channel
  std::vector<int> waiting_;
  bool ruts_ = false;
  double next_look_ = 1e-3;
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
