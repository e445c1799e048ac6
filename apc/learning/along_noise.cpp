#include "apc/learning/along_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apc/base/parallel.h"
#include "apc/base/require.h"

namespace apc::learning {
namespace {

constexpr double knot = noise_knots;
constexpr double run_level = 0.02;  ///< share of the deceleration that is off in a whole run
constexpr double rut_memory = 3.0;  ///< m
/// In a run of our own, without scatter, instruments tell the main gear's load within 4 % (rms; the nose gear's within
/// 12 %): no less is believed, however quiet the readings.
constexpr double least_load_error = 0.04;
/// m: tables err in ruts by 1 to 2 % of a third of a metre, too.
constexpr double least_rut_error = 0.005;

/// Covariance of the deceleration's error at its knots.
Eigen::MatrixXd drag_error(const AlongRun& a, const AlongNoise& n) {
  const Motion& m = a.motion;
  const auto knots = std::max<Eigen::Index>(2, static_cast<Eigen::Index>(m.time.back() / knot) + 1);
  Eigen::VectorXd size(knots);
  for (Eigen::Index j = 0; j < knots; ++j) {
    const double at = std::clamp((static_cast<double>(j) * knot - m.time.front()) / m.interval, 0.0,
                                 static_cast<double>(m.size() - 1));
    size[j] = std::max(1.0, -a.response.base.along[static_cast<Eigen::Index>(at)]);
  }
  Eigen::MatrixXd K(knots, knots);
  for (Eigen::Index i = 0; i < knots; ++i)
    for (Eigen::Index j = 0; j < knots; ++j)
      K(i, j) =
          size[i] * size[j] *
          (n.drag * n.drag * std::exp(-std::abs(static_cast<double>(i - j)) * knot / n.memory) + run_level * run_level);
  return K;
}

/// How that error moves the readings: acceleration at once, speed as its integral, the stop as the second.
Eigen::MatrixXd drag_error_readings(const Run& run, const AlongRun& a, Eigen::Index knots) {
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(a.predicted.size(), knots);
  for (std::size_t i = 0; i < a.readings.size(); ++i) {
    const Reading& r = a.readings[i];
    const auto row = static_cast<Eigen::Index>(i);
    const bool stop = r.kind == Reading::Kind::stop;
    const double t = stop ? a.motion.time.back() : 0.5 * (r.from + r.to) - mean_delay(run, r);
    if (r.is(Quantity::acceleration_x) && t >= 0.0) {
      const auto j = std::min(static_cast<Eigen::Index>(t / knot), knots - 2);
      const double u = std::min(1.0, t / knot - static_cast<double>(j));
      B(row, j) += 1.0 - u, B(row, j + 1) += u;
    }
    if (!stop && !r.is(Quantity::speed)) continue;
    for (Eigen::Index j = 0; j < knots; ++j) {
      const double since = t - static_cast<double>(j) * knot;
      B(row, j) = knot * (stop ? std::max(0.0, since) : std::clamp(since / knot + 0.5, 0.0, 1.0));
    }
  }
  return B;
}

/// Log evidence without any effect; leaves the runs' factors as this noise makes them.
double evidence_under(Along& along, const Case& data, const Layout& layout, const AlongPrior& prior,
                      const AlongNoise& noise, unsigned threads, Eigen::VectorXd* likeliest = nullptr) {
  const AlongPrior wide = with_vertical_error(prior, layout, noise.vertical_table);
  const Eigen::Index n = wide.precision.rows();
  std::vector<Eigen::MatrixXd> information(along.runs.size());
  std::vector<Eigen::VectorXd> right(along.runs.size());
  std::vector<double> rest(along.runs.size());
  parallel_for(along.runs.size(), threads, [&](std::size_t r) {
    AlongRun& a = along.runs[r];
    a.factor = noise_factor(data.runs[r], a, noise);
    const Eigen::MatrixXd S = a.factor.triangularView<Eigen::Lower>().solve(a.unknowns(Eigen::all, a.touched));
    const Eigen::VectorXd y = a.factor.triangularView<Eigen::Lower>().solve(a.difference);
    information[r] = S.transpose() * S, right[r] = S.transpose() * y;
    rest[r] = -0.5 * y.squaredNorm() - a.factor.diagonal().array().log().sum();
  });
  Eigen::MatrixXd M = wide.precision;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
  double log_evidence = 0.5 * wide.log_determinant;
  for (std::size_t r = 0; r < along.runs.size(); ++r) {
    const auto& touched = along.runs[r].touched;
    M(touched, touched) += information[r], sum(touched) += right[r];
    log_evidence += rest[r];
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(M);
  if (factor.info() != Eigen::Success) throw SolveError("the normal matrix along the motion is not positive");
  const Eigen::VectorXd mean = factor.solve(sum);
  if (likeliest) *likeliest = mean;
  return log_evidence + 0.5 * sum.dot(mean) - factor.matrixLLT().diagonal().array().log().sum();
}

}  // namespace

Eigen::MatrixXd noise_factor(const Run& run, const AlongRun& a, const AlongNoise& n) {
  const Eigen::MatrixXd K = drag_error(a, n);
  const Eigen::MatrixXd B = drag_error_readings(run, a, K.rows());
  Eigen::MatrixXd C = B * K * B.transpose();
  Eigen::MatrixXd L(K.rows(), K.rows());
  for (Eigen::Index i = 0; i < L.rows(); ++i)
    for (Eigen::Index j = 0; j < L.rows(); ++j)
      L(i, j) = n.load * n.load * std::exp(-std::abs(static_cast<double>(i - j)) * knot / n.memory);
  for (const Eigen::MatrixXd& by : a.carried) C += by * L * by.transpose();
  for (std::size_t i = 0; i < a.readings.size(); ++i) {
    const Reading& p = a.readings[i];
    const auto row = static_cast<Eigen::Index>(i);
    C(row, row) += std::pow(p.deviation * (p.is(Quantity::acceleration_x) ? n.accelerometer : 1.0), 2);
    if (p.kind != Reading::Kind::rut) continue;
    for (std::size_t j = 0; j < a.readings.size(); ++j)
      if (a.readings[j].kind == p.kind && a.readings[j].gear == p.gear)
        C(row, static_cast<Eigen::Index>(j)) +=
            n.rut * n.rut * std::exp(-std::abs(p.from - a.readings[j].from) / rut_memory);
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(C);
  if (factor.info() != Eigen::Success) throw SolveError("the covariance of the readings is not positive");
  return factor.matrixL();
}

Eigen::VectorXd fit_noise(Along& along, const Case& data, const Layout& layout, const AlongPrior& prior, int passes,
                          unsigned threads) {
  const auto numbers = [](AlongNoise& n) {
    return std::array<double*, 6>{&n.rut, &n.drag, &n.load, &n.memory, &n.accelerometer, &n.vertical_table};
  };
  constexpr std::array<std::array<double, 2>, 6> range = {
      {{least_rut_error, 0.06}, {0.01, 0.3}, {least_load_error, 0.4}, {0.1, 2.0}, {1.0, 4.0}, {1.0, 4.0}}};
  double highest = evidence_under(along, data, layout, prior, along.noise, threads);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t p = 0; p < range.size(); ++p) {
      AlongNoise best = along.noise;
      for (const double factor : {0.7, 1.4}) {
        AlongNoise tried = along.noise;
        double& value = *numbers(tried)[p];
        const double before = value;
        value = std::clamp(value * factor, range[p][0], range[p][1]);
        if (value == before) continue;
        const double there = evidence_under(along, data, layout, prior, tried, threads);
        if (there > highest) highest = there, best = tried;
      }
      along.noise = best;
    }
  Eigen::VectorXd likeliest;
  along.log_evidence =
      evidence_under(along, data, layout, prior, along.noise, threads, &likeliest);  // the last one tried was another
  along.precision = with_vertical_error(prior, layout, along.noise.vertical_table).precision;
  return likeliest;
}

}  // namespace apc::learning
