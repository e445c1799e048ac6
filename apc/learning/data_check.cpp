#include "apc/learning/data_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::learning {
namespace {

using Action = DataRemark::Action;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/// The known unit mix-up nearest to `ratio`, or 0: within 15 %.
double mixed_up(double ratio) {
  static const std::array<double, 9> factors = {9.80665, 1.0 / 9.80665, 1.94384,   0.514444, 3.28084,
                                                0.3048,  3.6,           1.0 / 3.6, 57.29578};
  for (const double factor : factors)
    if (std::abs(std::log(std::abs(ratio) / factor)) < 0.15) return factor;
  return 0.0;
}

/// Time that runs backwards or stands still: samples are dropped; a jump forward by more than 0.5 s is a gap.
void check_clock(Run& run, std::vector<DataRemark>& remarks) {
  for (Channel& c : run.channels) {
    std::size_t dropped = 0;
    std::vector<double> time, value;
    double latest = -1e9;
    for (std::size_t i = 0; i < c.time.size(); ++i) {
      if (c.time[i] <= latest) {
        ++dropped;
        continue;
      }
      latest = c.time[i];
      time.push_back(c.time[i]), value.push_back(c.value[i]);
    }
    if (dropped > 0) {
      remarks.push_back({run.id, c.column,
                         number(double(dropped)) + " samples whose time runs backwards or repeats are left out",
                         Action::repaired});
      c.time = time, c.value = value;
    }
  }
}

/// A flat top: more than 4 % of the samples equal the largest or the smallest value.
void check_clipping(Run& run, std::vector<DataRemark>& remarks) {
  for (Channel& c : run.channels) {
    if (c.value.size() < 50) continue;
    for (const double extreme :
         {*std::max_element(c.value.begin(), c.value.end()), *std::min_element(c.value.begin(), c.value.end())}) {
      const auto count = std::count(c.value.begin(), c.value.end(), extreme);
      const double spread =
          *std::max_element(c.value.begin(), c.value.end()) - *std::min_element(c.value.begin(), c.value.end());
      if (spread <= 0.0) {
        remarks.push_back({run.id, c.column, "does not move", Action::channel_dropped});
        c.value.clear(), c.time.clear();
        break;
      }
      if (static_cast<double>(count) > std::max(8.0, 0.04 * static_cast<double>(c.value.size())) &&
          spread > 10.0 * c.noise && std::abs(extreme) > 3.0 * c.noise) {
        remarks.push_back(
            {run.id, c.column,
             number(double(count)) + " samples stand at the limit " + number(extreme) + " (clipped); they are left out",
             Action::repaired});
        std::vector<double> time, value;
        for (std::size_t i = 0; i < c.value.size(); ++i)
          if (c.value[i] != extreme) time.push_back(c.time[i]), value.push_back(c.value[i]);
        c.time = time, c.value = value;
      }
    }
  }
}

void check_speed(Run& run, std::vector<DataRemark>& remarks) {
  for (Channel& c : run.channels) {
    if (c.quantity != Quantity::speed) continue;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < c.time.size(); ++i)
      if (c.time[i] < 0.35) sum += c.value[i], ++count;
    if (count < 3) continue;
    const double ratio = sum / count / run.overrun.entry_speed;
    if (std::abs(ratio - 1.0) < 0.2) continue;
    const double factor = mixed_up(ratio);
    if (factor > 0.0) {
      for (double& v : c.value) v /= ratio < 0.0 ? -factor : factor;
      remarks.push_back(
          {run.id, c.column,
           "reads " + number(ratio) + " times the entry speed: a unit was mixed up; divided by " + number(factor),
           Action::repaired});
    } else {
      remarks.push_back(
          {run.id, c.column, "reads " + number(ratio) + " times the entry speed", Action::channel_dropped});
      c.time.clear(), c.value.clear();
    }
  }
}

void check_acceleration(Run& run, std::vector<DataRemark>& remarks) {
  const Channel* speed = run.find(Quantity::speed);
  if (!speed || speed->time.size() < 10) return;
  for (Channel& c : run.channels) {
    if (c.quantity != Quantity::acceleration_x || c.time.size() < 20) continue;
    const KinematicFit fit = kinematic_fit(*speed, c, std::max(c.bias, 0.05));
    if (fit.samples < 8) continue;
    if (fit.scale > 0.7 && fit.scale < 1.4) {
      if (fit.residual > 12.0 * speed->noise + 0.8)
        remarks.push_back({run.id, c.column,
                           "does not integrate to the speed: " + number(fit.residual) +
                               " m/s rms apart; a jump in time or a broken channel",
                           Action::run_set_aside});
      continue;
    }
    // speed = v0 + scale ∫ax: the reading is true/scale.
    const double ratio = 1.0 / fit.scale, factor = mixed_up(ratio);
    if (std::abs(std::abs(ratio) - 1.0) < 0.3 && ratio < 0.0) {
      for (double& a : c.value) a = -a;
      remarks.push_back({run.id, c.column, "has the wrong sign (its integral runs against the speed); turned over",
                         Action::repaired});
    } else if (factor > 0.0) {
      for (double& a : c.value) a /= ratio < 0.0 ? -factor : factor;
      remarks.push_back(
          {run.id, c.column,
           "reads " + number(ratio) + " times what the speed says: a unit was mixed up; divided by " + number(factor),
           Action::repaired});
    } else {
      remarks.push_back(
          {run.id, c.column, "reads " + number(ratio) + " times what the speed says", Action::channel_dropped});
      c.time.clear(), c.value.clear();
    }
  }
}

/// ∫ speed dt up to the last sample against the recorded stop.
void check_stop(Run& run, std::vector<DataRemark>& remarks) {
  const Channel* speed = run.find(Quantity::speed);
  if (!run.stop || !speed || speed->time.size() < 10) return;
  double way = 0.0, longest = 0.0;
  for (std::size_t i = 1; i < speed->time.size(); ++i) {
    if (speed->time[i - 1] < 0.0) continue;
    way += 0.5 * (speed->value[i] + speed->value[i - 1]) * (speed->time[i] - speed->time[i - 1]);
    longest = std::max(longest, speed->time[i] - speed->time[i - 1]);
  }
  if (speed->value.back() > 3.0) return;
  const double ratio = way / *run.stop;
  if (std::abs(ratio - 1.0) < 0.12 + 0.02 * longest) return;
  const double factor = mixed_up(ratio);
  if (factor > 0.0 && std::abs(ratio - 1.0) > 0.4) {
    *run.stop *= factor;
    remarks.push_back(
        {run.id, "stop",
         "is off the integrated speed by " + number(ratio) + ": a unit was mixed up; multiplied by " + number(factor),
         Action::repaired});
    return;
  }
  remarks.push_back(
      {run.id, "",
       "stop distance and integrated speed differ by the factor " + number(ratio) + "; the run contradicts itself",
       Action::run_set_aside});
}

bool same_data(const Run& a, const Run& b) {
  if (a.channels.empty() || b.channels.empty()) return false;
  const Channel &x = a.channels.front(), &y = b.channels.front();
  return x.quantity == y.quantity && x.value.size() == y.value.size() && x.value.size() > 10 && x.value == y.value;
}

}  // namespace

KinematicFit kinematic_fit(const Channel& speed, const Channel& acceleration, double bias_prior) {
  // Columns: 1, ∫a dt, t; the bias t has a prior so that it cannot eat the deceleration.
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> rows;
  std::vector<double> wanted;
  double integral = 0.0;
  std::size_t j = 1;
  KinematicFit fit;
  for (std::size_t i = 0; i < speed.time.size(); ++i) {
    while (j < acceleration.time.size() && acceleration.time[j] <= speed.time[i]) {
      integral +=
          0.5 * (acceleration.value[j] + acceleration.value[j - 1]) * (acceleration.time[j] - acceleration.time[j - 1]);
      ++j;
    }
    if (speed.time[i] < acceleration.time.front() || speed.time[i] > acceleration.time.back() || speed.value[i] < 2.0)
      continue;
    const Eigen::Vector3d row(1.0, integral, speed.time[i]);
    rows.push_back(row);
    wanted.push_back(speed.value[i]);
    normal += row * row.transpose() / (speed.noise * speed.noise);
    right += row * speed.value[i] / (speed.noise * speed.noise);
  }
  fit.samples = static_cast<int>(rows.size());
  if (fit.samples < 4) return fit;
  normal(2, 2) += 1.0 / (bias_prior * bias_prior);
  normal(0, 0) += 1e-9, normal(1, 1) += 1e-9;
  const Eigen::Vector3d q = normal.ldlt().solve(right);
  fit.scale = q[1];
  fit.bias = q[2];
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) sum += std::pow(wanted[i] - rows[i].dot(q), 2);
  fit.residual = std::sqrt(sum / static_cast<double>(rows.size()));
  return fit;
}

void check_runs(Case& data) {
  for (Run& run : data.runs) {
    check_clock(run, data.remarks);
    check_clipping(run, data.remarks);
    check_speed(run, data.remarks);
    check_acceleration(run, data.remarks);
    check_stop(run, data.remarks);
    std::erase_if(run.channels, [](const Channel& c) { return c.time.size() < 5; });
    // Where a run ended is a measurement, too.
    if (run.channels.empty() && !run.stop && !run.exit_speed && !run.survey)
      data.remarks.push_back({run.id, "", "holds no usable channel, stop, exit or survey", Action::run_set_aside});
  }
  for (std::size_t i = 0; i < data.runs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (same_data(data.runs[i], data.runs[k])) {
        data.remarks.push_back({data.runs[i].id, "", "is a copy of " + data.runs[k].id, Action::run_set_aside});
        break;
      }
  std::erase_if(data.runs, [&](const Run& run) {
    return std::any_of(data.remarks.begin(), data.remarks.end(),
                       [&](const DataRemark& r) { return r.run == run.id && r.action == Action::run_set_aside; });
  });
}

}  // namespace apc::learning
