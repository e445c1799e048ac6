#include "apc/learning/layout.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc::learning {
namespace {

// The response to sinking is derived for a rigid wheel; a tire flattens.
constexpr double sinking_deviation = 0.4, sinking_drag_deviation = 0.3;
constexpr double drag_deviation = 0.08, cg_height_deviation = 0.02;

/// Covariance of block strengths of all runs of one lane, in the order run by run: nose knots, main knots.
Eigen::MatrixXd block_covariance(const Layout& layout, const std::vector<std::size_t>& members,
                                 const Scatter& scatter) {
  Eigen::Index size = 0;
  for (const std::size_t r : members) size += 2 * layout.runs[r].blocks;
  Eigen::MatrixXd covariance(size, size);
  const double main = 0.5 * (1.0 + scatter.lateral);  // variance of the mean over two tracks
  Eigen::Index row = 0;
  for (const std::size_t a : members) {
    const Eigen::Index na = layout.runs[a].blocks;
    Eigen::Index column = 0;
    for (const std::size_t b : members) {
      const Eigen::Index nb = layout.runs[b].blocks;
      const double share = a == b ? 1.0 : scatter.shared;
      for (Eigen::Index i = 0; i < 2 * na; ++i)
        for (Eigen::Index j = 0; j < 2 * nb; ++j) {
          const bool nose_i = i < na, nose_j = j < nb;
          const double gear = nose_i && nose_j ? 1.0 : nose_i == nose_j ? main : scatter.lateral;
          const double apart = std::abs(static_cast<double>(i % na) - static_cast<double>(j % nb)) * layout.spacing;
          double value = scatter.strength * scatter.strength * gear * share * std::exp(-apart / scatter.correlation);
          if (a == b) value += scatter.run_to_run * scatter.run_to_run;
          if (a == b && i == j) value += 1e-8;
          covariance(row + i, column + j) = value;
        }
      column += 2 * nb;
    }
    row += 2 * na;
  }
  return covariance;
}

}  // namespace

std::vector<Eigen::Index> Layout::simulated(std::size_t run) const {
  const RunLayout& r = runs[run];
  std::vector<Eigen::Index> result = {bed_strength, cg, drag, cg_height, sinking, sinking_drag};
  for (Eigen::Index i = 0; i < table_numbers * static_cast<Eigen::Index>(tables); ++i) result.push_back(table + i);
  for (const Eigen::Index i : {r.entry_speed, r.mass, r.cg, r.inertia, r.wind}) result.push_back(i);
  for (Eigen::Index i = 0; i < r.blocks; ++i) result.push_back(r.nose_blocks + i);
  for (Eigen::Index i = 0; i < r.blocks; ++i) result.push_back(r.main_blocks + i);
  return result;
}

Layout make_layout(const Case& data, const std::vector<Run>& runs) {
  Layout layout;
  std::vector<std::string> names;
  for (const auto& table : data.tables) {
    const auto found = std::find(names.begin(), names.end(), table.tire().name);
    layout.table_of_gear.push_back(static_cast<std::size_t>(found - names.begin()));
    if (found == names.end()) names.push_back(table.tire().name);
  }
  layout.tables = names.size();
  const double block = data.bed.block_length > 0.0 ? data.bed.block_length : 1.22;
  layout.spacing = block * std::clamp(std::round(data.correlation / (2.0 * block)), 2.0, 4.0);
  Eigen::Index next = 0;
  layout.bed_strength = next++, layout.cg = next++, layout.drag = next++, layout.cg_height = next++;
  layout.sinking = next++, layout.sinking_drag = next++;
  layout.table = next;
  next += table_numbers * static_cast<Eigen::Index>(layout.tables);
  for (const Run& run : runs) {
    RunLayout r;
    r.entry_speed = next++, r.mass = next++, r.cg = next++, r.inertia = next++, r.wind = next++, r.clock = next++;
    r.shift = next++, r.stretch = next++;
    for (std::size_t c = 0; c < run.channels.size(); ++c)
      r.bias.push_back(next++), r.scale.push_back(next++), r.lag.push_back(next++);
    const double reach = std::min(data.bed.length(), run.stop ? *run.stop + 6.0 : data.bed.length());
    r.blocks = std::max<Eigen::Index>(3, static_cast<Eigen::Index>(std::ceil(reach / layout.spacing)) + 1);
    r.nose_blocks = next, next += r.blocks;
    r.main_blocks = next, next += r.blocks;
    layout.runs.push_back(r);
  }
  layout.size = next;
  return layout;
}

Eigen::VectorXd prior_mean(const Layout& layout, const std::vector<Run>& runs) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(layout.size);
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::size_t c = 0; c < runs[r].channels.size(); ++c)
      mean[layout.runs[r].lag[c]] = mean_lag * runs[r].channels[c].lag;
  return mean;
}

Eigen::VectorXd prior_deviation(const Layout& layout, const Case& data, const std::vector<Run>& runs,
                                const Scatter& scatter) {
  Eigen::VectorXd deviation = Eigen::VectorXd::Ones(layout.size);
  deviation[layout.bed_strength] = data.bed_strength;
  deviation[layout.cg] = runs.empty() ? 0.02 : runs.front().uncertainty.cg;
  deviation[layout.drag] = drag_deviation;
  deviation[layout.cg_height] = cg_height_deviation;
  deviation[layout.sinking] = sinking_deviation, deviation[layout.sinking_drag] = sinking_drag_deviation;
  for (std::size_t gear = 0; gear < layout.table_of_gear.size(); ++gear) {
    const auto first = layout.table + table_numbers * static_cast<Eigen::Index>(layout.table_of_gear[gear]);
    for (Eigen::Index i = 0; i < table_numbers; ++i)
      deviation[first + i] = std::clamp(i < 6 ? data.drag_rms[gear] : data.vertical_rms[gear], 0.01, 0.08);
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const RunLayout& at = layout.runs[r];
    const Run& run = runs[r];
    deviation[at.entry_speed] = run.uncertainty.entry_speed;
    deviation[at.mass] = run.uncertainty.mass / run.overrun.mass;
    deviation[at.cg] = run.uncertainty.cg;
    deviation[at.inertia] = run.uncertainty.pitch_inertia / run.overrun.pitch_inertia;
    deviation[at.wind] = run.uncertainty.wind;
    deviation[at.clock] = run.uncertainty.clock;
    // A late clock is a way too short; a speed read too high stretches it.
    double scale = 0.003, bias = 0.05;
    if (const Channel* speed = run.find(Quantity::speed)) scale = speed->scale, bias = speed->bias;
    const double entry = std::max(5.0, run.overrun.entry_speed);
    deviation[at.shift] = std::hypot(run.uncertainty.clock * entry, 0.1);
    deviation[at.stretch] = std::hypot(scale, bias / (0.6 * entry), 1e-3);
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      deviation[at.bias[c]] = std::max(run.channels[c].bias, 1e-3 * run.channels[c].noise);
      deviation[at.scale[c]] = std::max(run.channels[c].scale, 1e-5);
      deviation[at.lag[c]] = std::max(lag_deviation * run.channels[c].lag, 1e-4);
    }
    for (Eigen::Index i = 0; i < at.blocks; ++i)
      deviation[at.nose_blocks + i] = scatter.strength, deviation[at.main_blocks + i] = scatter.strength;
  }
  for (Eigen::Index i = 0; i < deviation.size(); ++i)
    expect(deviation[i] > 0.0, "prior deviation ", i, " is not positive");
  return deviation;
}

Prior make_prior(const Layout& layout, const Case& data, const std::vector<Run>& runs, const Scatter& scatter) {
  Prior prior;
  prior.mean = prior_mean(layout, runs);
  const Eigen::VectorXd deviation = prior_deviation(layout, data, runs, scatter);
  prior.precision = Eigen::MatrixXd::Zero(layout.size, layout.size);
  std::vector<char> is_block(static_cast<std::size_t>(layout.size), 0);
  std::map<std::string, std::vector<std::size_t>> lanes;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    lanes[runs[r].lane].push_back(r);
    for (Eigen::Index i = 0; i < 2 * layout.runs[r].blocks; ++i)
      is_block[static_cast<std::size_t>(layout.runs[r].nose_blocks + i)] = 1;
  }
  for (Eigen::Index i = 0; i < layout.size; ++i)
    if (!is_block[static_cast<std::size_t>(i)]) {
      prior.precision(i, i) = 1.0 / (deviation[i] * deviation[i]);
      prior.log_determinant -= 2.0 * std::log(deviation[i]);
    }
  for (const auto& [lane, members] : lanes) {
    const Eigen::MatrixXd covariance = block_covariance(layout, members, scatter);
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    expect(factor.info() == Eigen::Success, "block covariance of lane ", lane, " is not positive");
    const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
    prior.log_determinant -= 2.0 * factor.matrixLLT().diagonal().array().log().sum();
    Eigen::Index row = 0;
    for (const std::size_t a : members) {
      const Eigen::Index na = 2 * layout.runs[a].blocks;
      Eigen::Index column = 0;
      for (const std::size_t b : members) {
        const Eigen::Index nb = 2 * layout.runs[b].blocks;
        prior.precision.block(layout.runs[a].nose_blocks, layout.runs[b].nose_blocks, na, nb) =
            inverse.block(row, column, na, nb);
        column += nb;
      }
      row += na;
    }
  }
  return prior;
}

}  // namespace apc::learning
