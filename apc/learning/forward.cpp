#include "apc/learning/forward.h"

#include <algorithm>
#include <cmath>

#include "apc/effects/catalogue.h"

namespace apc::learning {
namespace {

constexpr double slowest = 3.0;  ///< m/s; below it stopping dominates and nothing is compared

double end_time(const Run& run) {
  const Channel* speed = run.find(Quantity::speed);
  if (!speed || speed->time.empty()) return 1e9;
  double last = speed->time.front();
  for (std::size_t i = 0; i < speed->time.size(); ++i)
    if (speed->value[i] > slowest) last = speed->time[i];
  return last;
}

const simulation::History::Gear& gear_history(const simulation::History& history, const aircraft::Aircraft& aircraft,
                                              bool nose) {
  for (std::size_t g = 0; g < aircraft.gears.size(); ++g)
    if (aircraft.gears[g].is_nose() == nose) return history.gears[g];
  return history.gears.front();
}

std::vector<double> sum_of_main(const simulation::History& history, const aircraft::Aircraft& aircraft,
                                std::vector<double> simulation::History::Gear::*member) {
  std::vector<double> sum(history.time.size(), 0.0);
  for (std::size_t g = 0; g < aircraft.gears.size(); ++g)
    if (!aircraft.gears[g].is_nose())
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (history.gears[g].*member)[i];
  return sum;
}

std::vector<double> true_signal(const simulation::History& h, const Channel& channel, const aircraft::Aircraft& a) {
  using Gear = simulation::History::Gear;
  switch (channel.quantity) {
    case Quantity::speed:
      return h.speed;
    case Quantity::acceleration_x:
      return h.acceleration_x;
    case Quantity::acceleration_z: {
      std::vector<double> value = h.acceleration_z;
      if (channel.lever_arm != 0.0)
        for (std::size_t i = 1; i < value.size(); ++i)
          value[i] +=
              channel.lever_arm * (h.pitch_rate[i] - h.pitch_rate[i - 1]) / std::max(1e-6, h.time[i] - h.time[i - 1]);
      return value;
    }
    case Quantity::pitch:
      return h.pitch;
    case Quantity::pitch_rate:
      return h.pitch_rate;
    case Quantity::nose_stroke:
      return gear_history(h, a, true).stroke;
    case Quantity::main_stroke:
      return gear_history(h, a, false).stroke;
    case Quantity::nose_drag:
      return gear_history(h, a, true).drag;
    case Quantity::nose_vertical:
      return gear_history(h, a, true).vertical;
    case Quantity::main_drag:
      return sum_of_main(h, a, &Gear::drag);
    case Quantity::main_vertical:
      return sum_of_main(h, a, &Gear::vertical);
    case Quantity::nose_spin:
      return gear_history(h, a, true).spin;
    case Quantity::main_spin:
      return gear_history(h, a, false).spin;
    case Quantity::nose_distance:
      return h.distance;
  }
  return {};
}

}  // namespace

double at_place(const std::vector<double>& x, const std::vector<double>& y, double place) {
  const auto after = std::upper_bound(x.begin(), x.end(), place);
  if (after == x.begin()) return y.front();
  if (after == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(after - x.begin());
  const double u = (place - x[i - 1]) / std::max(1e-9, x[i] - x[i - 1]);
  return (1.0 - u) * y[i - 1] + u * y[i];
}

Rows make_rows(const Run& run, const Case&) {
  Rows rows;
  const double end = end_time(run);
  for (const Channel& c : run.channels) {
    rows.channel_start.push_back(rows.size);
    const auto used = static_cast<std::size_t>(std::upper_bound(c.time.begin(), c.time.end(), end) - c.time.begin());
    rows.samples.push_back(used);
    rows.size += static_cast<Eigen::Index>(used);
  }
  rows.nose_rut_start = rows.size;
  if (run.survey)
    for (std::size_t i = 0; i < run.survey->distance.size(); ++i)
      if (std::isfinite(run.survey->nose_rut[i])) rows.nose_rut.push_back(i);
  rows.size += static_cast<Eigen::Index>(rows.nose_rut.size());
  rows.main_rut_start = rows.size;
  if (run.survey)
    for (std::size_t i = 0; i < run.survey->distance.size(); ++i)
      if (std::isfinite(run.survey->main_rut[i])) rows.main_rut.push_back(i);
  rows.size += static_cast<Eigen::Index>(rows.main_rut.size());
  rows.last = rows.size;
  rows.stop = run.stop.has_value();
  rows.exit = !rows.stop && run.exit_speed.has_value();
  if (rows.stop || rows.exit) ++rows.size;
  return rows;
}

Eigen::VectorXd measured(const Run& run, const Rows& rows) {
  Eigen::VectorXd y(rows.size);
  for (std::size_t c = 0; c < run.channels.size(); ++c)
    for (std::size_t i = 0; i < rows.samples[c]; ++i)
      y[rows.channel_start[c] + static_cast<Eigen::Index>(i)] = run.channels[c].value[i];
  for (std::size_t i = 0; i < rows.nose_rut.size(); ++i)
    y[rows.nose_rut_start + static_cast<Eigen::Index>(i)] = run.survey->nose_rut[rows.nose_rut[i]];
  for (std::size_t i = 0; i < rows.main_rut.size(); ++i)
    y[rows.main_rut_start + static_cast<Eigen::Index>(i)] = run.survey->main_rut[rows.main_rut[i]];
  if (rows.stop) y[rows.last] = *run.stop;
  if (rows.exit) y[rows.last] = *run.exit_speed;
  return y;
}

simulation::Model model_of(const Case& data, const Layout& layout, const Eigen::VectorXd& eta) {
  simulation::Model model{data.aircraft, data.bed, data.tables};
  model.aircraft.cg_height += eta[layout.cg_height];
  model.aircraft.aero.CD *= std::exp(eta[layout.drag]);
  return model;
}

simulation::Overrun overrun_of(const Case& data, const Layout& layout, std::size_t r, const Run& run,
                               const Eigen::VectorXd& eta, const std::vector<effects::Applied>& added) {
  const RunLayout& at = layout.runs[r];
  simulation::Overrun o = run.overrun;
  o.entry_speed += eta[at.entry_speed];
  o.mass *= std::exp(eta[at.mass]);
  o.cg_behind_nose_gear += eta[at.cg] + eta[layout.cg];
  // The quoted inertia belongs to the quoted mass; a mass nobody knew takes its inertia along.
  o.pitch_inertia *= std::exp(eta[at.inertia] + (run.mass_known ? 0.0 : eta[at.mass]));
  o.headwind += eta[at.wind];
  o.sinking = {1.0 + eta[layout.sinking], eta[layout.sinking_drag]};
  effects::Alterations& a = o.alterations;
  a.effects = added;
  a.conditions = run.conditions;
  a.bed_strength = std::exp(eta[layout.bed_strength]);
  a.place_shift = eta[at.shift], a.place_stretch = eta[at.stretch];
  const auto profile = [&](Eigen::Index first) {
    effects::StrengthProfile p;
    p.spacing = layout.spacing;
    p.log_strength.assign(eta.data() + first, eta.data() + first + at.blocks);
    return p;
  };
  const effects::StrengthProfile nose = profile(at.nose_blocks), main = profile(at.main_blocks);
  for (std::size_t g = 0; g < data.aircraft.gears.size(); ++g) {
    a.strength.push_back(data.aircraft.gears[g].is_nose() ? nose : main);
    effects::TableError error;
    const double* number =
        eta.data() + layout.table + table_numbers * static_cast<Eigen::Index>(layout.table_of_gear[g]);
    static constexpr double speeds[3] = {-0.68, 0.0,
                                         1.0};  // of the table error's knots, in steps of 18.5 m/s from 17.5
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        error.drag[3 * i + j] = number[j] + speeds[i] * number[3 + j];
        error.vertical[3 * i + j] = number[6 + j] + speeds[i] * number[9 + j];
      }
    a.table_errors.push_back(error);
  }
  return o;
}

Trace simulate_run(const Case& data, const Layout& layout, std::size_t r, const Run& run, const Eigen::VectorXd& eta,
                   const std::vector<effects::Applied>& added, std::shared_ptr<const effects::Guide> guide) {
  simulation::Options options;
  options.method = simulation::Method::fast;
  options.sampling = 0.01;
  options.rtol = 3e-5;
  simulation::Overrun overrun = overrun_of(data, layout, r, run, eta, added);
  overrun.alterations.guide = guide;
  Trace trace;
  trace.result = simulation::simulate(model_of(data, layout, eta), overrun, options);
  simulation::Result& result = trace.result;
  double lost = 0.0;  // speed the guiding force has added so far
  if (guide) {
    simulation::History& h = result.history;
    double before = 0.0;
    for (std::size_t i = 0; i < h.time.size(); ++i) {
      const double push = h.time[i] > 0.0 ? guide->gain * (guide->speed_at(h.time[i]) - h.speed[i]) : 0.0;
      if (i > 0) lost += 0.5 * (push + before) * (h.time[i] - h.time[i - 1]);
      before = push;
      h.speed[i] -= lost;
      h.deceleration[i] += push;
      h.acceleration_x[i] -= push;
    }
  }
  const double length = data.bed.length();
  const double a = std::max(0.3, result.mean_deceleration);
  if (result.outcome == simulation::Outcome::left_bed || result.exit_speed > 0.0) {
    trace.exit_speed = result.exit_speed - lost;
    trace.stop = length + result.exit_speed * result.exit_speed / (2.0 * a);
  } else {
    trace.stop = result.stop_distance;
    trace.exit_speed = -std::sqrt(2.0 * a * std::max(0.0, length - result.stop_distance));
  }
  return trace;
}

std::shared_ptr<const effects::Guide> make_guide(const Run& run, const RunLayout& at, const Eigen::VectorXd& eta) {
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Channel& channel = run.channels[c];
    if (channel.quantity != Quantity::speed || channel.time.size() < 10) continue;
    // Within twice the quoted errors: a guide must not follow a fit that has gone astray.
    const auto limited = [](double value, double most) { return std::clamp(value, -most, most); };
    const double delay =
        std::clamp(eta[at.lag[c]], 0.0, 2.0 * channel.lag) + limited(eta[at.clock], 2.0 * run.uncertainty.clock);
    const double bias = limited(eta[at.bias[c]], 2.0 * channel.bias), scale = limited(eta[at.scale[c]], 0.05);
    const double end = end_time(run) - delay;
    constexpr double interval = 0.05, jerk = 30.0;
    const auto n = static_cast<Eigen::Index>(std::max(20.0, std::ceil(end / interval))) + 1;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    const double weight = 1.0 / (channel.noise * channel.noise);
    for (std::size_t i = 0; i < channel.time.size(); ++i) {
      const double place = (channel.time[i] - delay) / interval;
      if (place < 0.0 || place >= static_cast<double>(n - 1)) continue;
      const auto k = static_cast<Eigen::Index>(place);
      const double u = place - static_cast<double>(k), v = (channel.value[i] - bias) / (1.0 + scale);
      normal(k, k) += weight * (1.0 - u) * (1.0 - u);
      normal(k, k + 1) += weight * u * (1.0 - u);
      normal(k + 1, k) += weight * u * (1.0 - u);
      normal(k + 1, k + 1) += weight * u * u;
      right[k] += weight * (1.0 - u) * v;
      right[k + 1] += weight * u * v;
    }
    const double stiff = 1.0 / (jerk * interval * interval * interval);
    for (Eigen::Index k = 1; k + 1 < n; ++k) {
      const double d[3] = {1.0, -2.0, 1.0};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) normal(k - 1 + i, k - 1 + j) += stiff * d[i] * d[j];
    }
    const Eigen::VectorXd smooth = normal.ldlt().solve(right);
    auto guide = std::make_shared<effects::Guide>();
    for (Eigen::Index k = 0; k < n; ++k)
      guide->time.push_back(interval * static_cast<double>(k)), guide->speed.push_back(smooth[k]);
    // Beyond the last sample: on with the last second's trend, until it has stopped for certain.
    const Eigen::Index second = std::min<Eigen::Index>(n - 1, 20);
    const double slope =
        std::min(-0.5, (smooth[n - 1] - smooth[n - 1 - second]) / (interval * static_cast<double>(second)));
    while (guide->speed.back() > -1.0)
      guide->time.push_back(guide->time.back() + interval),
          guide->speed.push_back(guide->speed.back() + slope * interval);
    return guide;
  }
  return nullptr;
}

Signal::Signal(const simulation::History& history, const Channel& channel, const aircraft::Aircraft& aircraft)
    : time_(history.time), value_(true_signal(history, channel, aircraft)) {
  // At the very end the aircraft rocks to rest; the trend is taken before that, while it still rolls.
  std::size_t last = time_.size();
  while (last > 2 && history.speed[last - 1] < 1.0) --last;
  std::size_t from = last;
  while (from > 1 && time_[last - 1] - time_[from - 1] < 0.3) --from;
  if (channel.quantity == Quantity::speed || channel.quantity == Quantity::nose_distance)
    last_slope_ = (value_[last - 1] - value_[from - 1]) / std::max(1e-3, time_[last - 1] - time_[from - 1]);
  else {
    double mean = 0.0;
    for (std::size_t i = from - 1; i < last; ++i) mean += value_[i] / static_cast<double>(last - from + 1);
    value_[last - 1] = mean;
  }
  time_.resize(last), value_.resize(last);
}

double Signal::operator()(double time) const {
  if (time >= time_.back()) return value_.back() + last_slope_ * (time - time_.back());
  if (time <= time_.front())
    return value_.front() + (value_[1] - value_[0]) / (time_[1] - time_[0]) * (time - time_.front());
  const auto i = static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), time) - time_.begin());
  const double u = (time - time_[i - 1]) / (time_[i] - time_[i - 1]);
  return (1.0 - u) * value_[i - 1] + u * value_[i];
}

double Signal::slope(double time) const { return ((*this)(time + 0.01) - (*this)(time - 0.01)) / 0.02; }

Eigen::VectorXd predict(const Run& run, const Rows& rows, const Trace& trace, const RunLayout& at,
                        const Eigen::VectorXd& eta, const aircraft::Aircraft& aircraft) {
  Eigen::VectorXd h(rows.size);
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Channel& channel = run.channels[c];
    const Signal signal(trace.result.history, channel, aircraft);
    const double delay = eta[at.lag[c]] + eta[at.clock];
    for (std::size_t i = 0; i < rows.samples[c]; ++i)
      h[rows.channel_start[c] + static_cast<Eigen::Index>(i)] =
          (1.0 + eta[at.scale[c]]) * signal(channel.time[i] - delay) + eta[at.bias[c]];
  }
  const auto& nose = gear_history(trace.result.history, aircraft, true);
  const auto& main = gear_history(trace.result.history, aircraft, false);
  for (std::size_t i = 0; i < rows.nose_rut.size(); ++i)
    h[rows.nose_rut_start + static_cast<Eigen::Index>(i)] =
        at_place(nose.distance, nose.rut, run.survey->distance[rows.nose_rut[i]]);
  for (std::size_t i = 0; i < rows.main_rut.size(); ++i)
    h[rows.main_rut_start + static_cast<Eigen::Index>(i)] =
        at_place(main.distance, main.rut, run.survey->distance[rows.main_rut[i]]);
  if (rows.stop) h[rows.last] = trace.stop;
  if (rows.exit) h[rows.last] = trace.exit_speed;
  return h;
}

std::vector<Eigen::Index> instrument_indices(const RunLayout& at) {
  std::vector<Eigen::Index> result = {at.clock};
  for (std::size_t c = 0; c < at.bias.size(); ++c) result.insert(result.end(), {at.bias[c], at.scale[c], at.lag[c]});
  return result;
}

Eigen::MatrixXd instrument_columns(const Run& run, const Rows& rows, const Trace& trace, const RunLayout& at,
                                   const Eigen::VectorXd& eta, const aircraft::Aircraft& aircraft) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows.size, static_cast<Eigen::Index>(1 + 3 * run.channels.size()));
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    const Channel& channel = run.channels[c];
    const Signal signal(trace.result.history, channel, aircraft);
    const double delay = eta[at.lag[c]] + eta[at.clock];
    const auto first = static_cast<Eigen::Index>(1 + 3 * c);
    for (std::size_t i = 0; i < rows.samples[c]; ++i) {
      const Eigen::Index row = rows.channel_start[c] + static_cast<Eigen::Index>(i);
      const double time = channel.time[i] - delay, slope = -(1.0 + eta[at.scale[c]]) * signal.slope(time);
      columns(row, 0) = slope;
      columns(row, first) = 1.0;
      columns(row, first + 1) = signal(time);
      columns(row, first + 2) = slope;
    }
    if (channel.quantity == Quantity::speed && rows.stop) {  // the way is the integral of the measured speed
      columns(rows.last, first) = -trace.result.stop_time;
      columns(rows.last, first + 1) = -trace.stop;
      columns(rows.last, first + 2) = -run.overrun.entry_speed;
      columns(rows.last, 0) = -run.overrun.entry_speed;
    }
  }
  return columns;
}

}  // namespace apc::learning
