#include "apc/learning/background.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apc/base/parallel.h"
#include "apc/base/require.h"

namespace apc::learning {
namespace {

/// A guided run's way is the measured speed's: its scale and bias are in the stop.
double stop_deviation(const Run& run) {
  if (!run.stop) return 0.5;
  double scale = 0.003, bias = 0.0;
  if (const Channel* speed = run.find(Quantity::speed)) scale = std::max(scale, speed->scale), bias = speed->bias;
  const double seconds = 1.6 * *run.stop / std::max(5.0, run.overrun.entry_speed);
  return std::hypot(std::hypot(run.stop_noise, scale * *run.stop), bias * seconds);
}

double range_of(const Background& b, Quantity quantity) {
  double low = 1e300, high = -1e300;
  for (std::size_t r = 0; r < b.training; ++r)
    for (const Channel& c : b.runs[r].channels)
      if (c.quantity == quantity)
        for (const double v : c.value) low = std::min(low, v), high = std::max(high, v);
  return std::max(0.0, high - low);
}

/// Places of survey readings in units in which the noise's correlation grid (0.03–1) makes sense: 10 m.
std::vector<double> rut_places(const Run& run, const std::vector<std::size_t>& rows) {
  std::vector<double> place;
  for (const std::size_t i : rows) place.push_back(run.survey->distance[i] / 10.0);
  return place;
}

void make_whiteners(Background& b) {
  b.whiteners.assign(b.training, {});
  for (std::size_t r = 0; r < b.training; ++r) {
    const Run& run = b.runs[r];
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const auto end = run.channels[c].time.begin() + static_cast<std::ptrdiff_t>(b.rows[r].samples[c]);
      NoiseModel noise = b.noise.at(run.channels[c].quantity);
      noise.white = std::max(noise.white, run.channels[c].noise);
      b.whiteners[r].emplace_back(std::vector<double>(run.channels[c].time.begin(), end), noise);
    }
    b.whiteners[r].emplace_back(run.survey ? rut_places(run, b.rows[r].nose_rut) : std::vector<double>{}, b.rut_noise);
    b.whiteners[r].emplace_back(run.survey ? rut_places(run, b.rows[r].main_rut) : std::vector<double>{}, b.rut_noise);
  }
}

/// First guess: quoted noise, slow part 4 % of the channel's range.
void quoted_noise(Background& b) {
  for (std::size_t r = 0; r < b.training; ++r)
    for (const Channel& c : b.runs[r].channels) {
      NoiseModel& noise = b.noise[c.quantity];
      noise.white = std::max(noise.white == 1.0 ? 0.0 : noise.white, c.noise);
      noise.slow = c.quantity == Quantity::speed ? 0.4 : 0.05 * range_of(b, c.quantity);
      noise.correlation = c.quantity == Quantity::speed ? 1.0 : 0.3;
    }
  b.rut_noise = {0.02, 0.01, 0.2};
}

void learn_noise(Background& b) {
  std::map<Quantity, std::vector<Series>> series;
  std::vector<Series> ruts;
  for (std::size_t r = 0; r < b.training; ++r) {
    const Run& run = b.runs[r];
    const Eigen::VectorXd misfit =
        b.measured[r] - predict(run, b.rows[r], b.traces[r], b.layout.runs[r], b.eta, b.data->aircraft);
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const auto n = static_cast<Eigen::Index>(b.rows[r].samples[c]);
      Series one{{run.channels[c].time.begin(), run.channels[c].time.begin() + n},
                 misfit.segment(b.rows[r].channel_start[c], n)};
      series[run.channels[c].quantity].push_back(std::move(one));
    }
    const auto& rows = b.rows[r];
    if (!rows.nose_rut.empty())
      ruts.push_back({rut_places(run, rows.nose_rut),
                      misfit.segment(rows.nose_rut_start, static_cast<Eigen::Index>(rows.nose_rut.size()))});
    if (!rows.main_rut.empty())
      ruts.push_back({rut_places(run, rows.main_rut),
                      misfit.segment(rows.main_rut_start, static_cast<Eigen::Index>(rows.main_rut.size()))});
  }
  for (auto& [quantity, list] : series) {
    double least = 1e300;
    for (std::size_t r = 0; r < b.training; ++r)
      for (const Channel& c : b.runs[r].channels)
        if (c.quantity == quantity) least = std::min(least, c.noise);
    const double range = range_of(b, quantity);
    b.noise[quantity] = fit_noise(list, least, 0.005 * range, 0.2 * range);
  }
  if (!ruts.empty()) b.rut_noise = fit_noise(ruts, 0.012, 0.003, 0.08);
  make_whiteners(b);
}

/// Misfits and traces of all training runs at `eta`; the objective.
double visit(const Background& b, const Eigen::VectorXd& eta, std::vector<Eigen::VectorXd>& misfits,
             std::vector<Trace>& traces) {
  misfits.resize(b.training), traces.resize(b.runs.size());
  parallel_for(b.training, b.threads,
               [&](std::size_t r) { misfits[r] = whitened_misfit(b, r, eta, b.added, &traces[r]); });
  double sum = prior_term(b, eta);
  for (const auto& m : misfits) sum += m.squaredNorm();
  return sum;
}

/// Gauss–Newton steps with halving on the sensitivities at hand: they cost a hundred simulations per run, a step one.
void improve(Background& b, int steps, double tolerance) {
  const Eigen::LLT<Eigen::MatrixXd> factor(b.information + b.prior.precision);
  std::vector<Eigen::VectorXd> misfits(b.training);
  for (std::size_t r = 0; r < b.training; ++r) misfits[r] = b.linear[r].misfit;
  for (int i = 0; i < steps; ++i) {
    Eigen::VectorXd gradient = -b.prior.precision * b.offset();
    for (std::size_t r = 0; r < b.training; ++r) {
      const RunLinear& l = b.linear[r];
      const Eigen::VectorXd part = l.S.transpose() * misfits[r];
      for (std::size_t k = 0; k < l.columns.size(); ++k) gradient[l.columns[k]] += part[static_cast<Eigen::Index>(k)];
    }
    const Eigen::VectorXd step = factor.solve(gradient);
    const double before = b.objective;
    bool moved = false;
    for (double share = 1.0; share > 0.2; share *= 0.5) {
      std::vector<Trace> traces;
      std::vector<Eigen::VectorXd> there;
      double after = 0.0;
      try {
        after = visit(b, b.eta + share * step, there, traces);
      } catch (const SolveError&) {
        continue;
      }
      if (after >= before) continue;
      b.eta += share * step;
      b.objective = after;
      std::copy(std::make_move_iterator(traces.begin()),
                std::make_move_iterator(traces.begin() + static_cast<std::ptrdiff_t>(b.training)), b.traces.begin());
      misfits = std::move(there);
      moved = true;
      break;
    }
    if (!moved || before - b.objective < tolerance) break;
  }
  assemble(b);
}

}  // namespace

double prior_term(const Background& b, const Eigen::VectorXd& eta) {
  const Eigen::VectorXd d = eta - b.prior.mean;
  return d.dot(b.prior.precision * d);
}

void whiten_rows(const Background& b, std::size_t r, Eigen::Ref<Eigen::MatrixXd> columns) {
  const Rows& rows = b.rows[r];
  for (std::size_t c = 0; c < rows.samples.size(); ++c)
    b.whiteners[r][c].apply(columns.middleRows(rows.channel_start[c], static_cast<Eigen::Index>(rows.samples[c])));
  b.whiteners[r][rows.samples.size()].apply(
      columns.middleRows(rows.nose_rut_start, static_cast<Eigen::Index>(rows.nose_rut.size())));
  b.whiteners[r][rows.samples.size() + 1].apply(
      columns.middleRows(rows.main_rut_start, static_cast<Eigen::Index>(rows.main_rut.size())));
  if (rows.stop || rows.exit) columns.row(rows.last) /= stop_deviation(b.runs[r]);
}

Eigen::VectorXd whitened_misfit(const Background& b, std::size_t r, const Eigen::VectorXd& eta,
                                const std::vector<effects::Applied>& added, Trace* trace) {
  Trace local = simulate_run(*b.data, b.layout, r, b.runs[r], eta, added, b.guides[r]);
  Eigen::MatrixXd misfit =
      b.measured[r] - predict(b.runs[r], b.rows[r], local, b.layout.runs[r], eta, b.data->aircraft);
  whiten_rows(b, r, misfit);
  if (trace) *trace = std::move(local);
  return misfit;
}

void renew_guides(Background& b) {
  for (std::size_t r = 0; r < b.training; ++r) b.guides[r] = make_guide(b.runs[r], b.layout.runs[r], b.eta);
}

void linearise(Background& b) {
  const Eigen::VectorXd deviation = prior_deviation(b.layout, *b.data, b.runs, b.scatter);
  b.linear.assign(b.training, {});
  std::vector<std::pair<std::size_t, std::size_t>> jobs;  // run, column
  for (std::size_t r = 0; r < b.training; ++r) {
    RunLinear& l = b.linear[r];
    l.columns = b.layout.simulated(r);
    const std::size_t simulated = l.columns.size();
    for (const Eigen::Index i : instrument_indices(b.layout.runs[r])) l.columns.push_back(i);
    l.plain = Eigen::MatrixXd::Zero(b.rows[r].size, static_cast<Eigen::Index>(l.columns.size()));
    for (std::size_t k = 0; k < simulated; ++k) jobs.emplace_back(r, k);
  }
  parallel_for(b.training, b.threads, [&](std::size_t r) {
    b.linear[r].misfit = whitened_misfit(b, r, b.eta, b.added, &b.traces[r]);
    const auto instruments =
        instrument_columns(b.runs[r], b.rows[r], b.traces[r], b.layout.runs[r], b.eta, b.data->aircraft);
    b.linear[r].plain.rightCols(instruments.cols()) = instruments;
  });
  std::vector<Eigen::VectorXd> base(b.training);
  for (std::size_t r = 0; r < b.training; ++r)
    base[r] = predict(b.runs[r], b.rows[r], b.traces[r], b.layout.runs[r], b.eta, b.data->aircraft);
  parallel_for(jobs.size(), b.threads, [&](std::size_t j) {
    const auto [r, k] = jobs[j];
    const Eigen::Index index = b.linear[r].columns[k];
    Eigen::VectorXd eta = b.eta;
    for (const double step : {0.5 * deviation[index], -0.5 * deviation[index]}) {
      eta[index] = b.eta[index] + step;
      try {
        const Trace trace = simulate_run(*b.data, b.layout, r, b.runs[r], eta, b.added, b.guides[r]);
        b.linear[r].plain.col(static_cast<Eigen::Index>(k)) =
            (predict(b.runs[r], b.rows[r], trace, b.layout.runs[r], b.eta, b.data->aircraft) - base[r]) / step;
        return;
      } catch (const SolveError&) {
        continue;  // the other side; a column that fails on both stays zero
      }
    }
  });
  assemble(b);
}

void assemble(Background& b) {
  parallel_for(b.training, b.threads, [&](std::size_t r) {
    Eigen::MatrixXd misfit =
        b.measured[r] - predict(b.runs[r], b.rows[r], b.traces[r], b.layout.runs[r], b.eta, b.data->aircraft);
    whiten_rows(b, r, misfit);
    b.linear[r].misfit = misfit;
    b.linear[r].S = b.linear[r].plain;
    whiten_rows(b, r, b.linear[r].S);
  });
  b.information = Eigen::MatrixXd::Zero(b.layout.size, b.layout.size);
  b.right = Eigen::VectorXd::Zero(b.layout.size);
  b.objective = prior_term(b, b.eta);
  const Eigen::VectorXd offset = b.offset();
  for (std::size_t r = 0; r < b.training; ++r) {
    const RunLinear& l = b.linear[r];
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(l.S.cols(), l.S.cols());
    square.selfadjointView<Eigen::Lower>().rankUpdate(l.S.transpose());
    square = Eigen::MatrixXd(square.selfadjointView<Eigen::Lower>());
    Eigen::VectorXd local(l.S.cols());
    for (std::size_t k = 0; k < l.columns.size(); ++k) local[static_cast<Eigen::Index>(k)] = offset[l.columns[k]];
    const Eigen::VectorXd right = l.S.transpose() * l.misfit + square * local;
    for (std::size_t i = 0; i < l.columns.size(); ++i) {
      b.right[l.columns[i]] += right[static_cast<Eigen::Index>(i)];
      for (std::size_t k = 0; k < l.columns.size(); ++k)
        b.information(l.columns[i], l.columns[k]) += square(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
    }
    b.objective += l.misfit.squaredNorm();
  }
}

double log_evidence(const Background& b) {
  const Eigen::LLT<Eigen::MatrixXd> factor(b.information + b.prior.precision);
  double value = -0.5 * b.objective + 0.5 * b.prior.log_determinant - factor.matrixLLT().diagonal().array().log().sum();
  for (const auto& run : b.whiteners)
    for (const Whitener& w : run) value -= 0.5 * w.log_determinant();
  return value;
}

Background fit_background(const Case& data, const BackgroundOptions& options) {
  Background b;
  b.data = &data;
  b.runs = data.runs;
  b.training = data.runs.size();
  b.runs.insert(b.runs.end(), data.held_out.begin(), data.held_out.end());
  b.threads = options.threads;
  b.layout = make_layout(data, b.runs);
  b.scatter.strength = data.block_strength;
  b.scatter.correlation = data.correlation;
  b.prior = make_prior(b.layout, data, b.runs, b.scatter);
  for (const Run& run : b.runs) {
    b.rows.push_back(make_rows(run, data));
    b.measured.push_back(measured(run, b.rows.back()));
  }
  quoted_noise(b);
  make_whiteners(b);
  b.eta = b.prior.mean;
  for (std::size_t r = 0; r < b.training; ++r) b.guides.push_back(make_guide(b.runs[r], b.layout.runs[r], b.eta));
  b.traces.resize(b.runs.size());
  const auto tell = [&](double share, const char* what) {
    if (options.report) options.report(share, what);
  };
  tell(0.05, "fitting the background");
  linearise(b);
  improve(b, 4, 10.0);
  learn_noise(b);
  assemble(b);
  improve(b, 4, 5.0);
  tell(0.5, "fitting the background with learned noise");
  // Noise and nuisances are fitted in turn until the evidence no longer rises. A background stopped short of that lacks
  // what an effect would then be called in for.
  Background best;
  double highest = -std::numeric_limits<double>::infinity();
  int idle = 0;
  for (int i = 0; i < options.iterations && idle < 2; ++i) {
    if (i < 2) renew_guides(b);  // then they stay: a new guide is a new excitation, and nothing would settle
    linearise(b);
    improve(b, 6, 1.0);
    learn_noise(b);
    assemble(b);
    improve(b, 6, 1.0);
    const double evidence = log_evidence(b);
    idle = evidence > highest + 3.0 ? 0 : idle + 1;
    if (i < 2 || evidence > highest) highest = evidence, best = b;
    tell(0.5 + 0.5 * (i + 1) / options.iterations, "fitting the background until it settles");
  }
  tell(1.0, "background fitted");
  return best;
}

Background refit_background(const Background& start, const std::vector<effects::Applied>& added, int linearisations,
                            const Report& report) {
  Background b = start;
  b.added = added;
  for (int i = 0; i < linearisations; ++i) {
    linearise(b);
    improve(b, 5, 2.0);
  }
  if (report) report(1.0, "refitted");
  return b;
}

}  // namespace apc::learning
