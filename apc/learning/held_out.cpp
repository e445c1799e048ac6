#include "apc/learning/held_out.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"

namespace apc::learning {
namespace {

double logarithm(const RunError& error) { return std::log(std::max(1.0, error.total)); }

}  // namespace

double HeldOut::least_fall() const {
  const auto n = static_cast<double>(std::max<std::size_t>(1, runs.size()));
  double mean = 0.0, square = 0.0;
  for (const LeftOut& one : runs) {
    const double help = logarithm(one.before) - logarithm(one.after);
    mean += help / n, square += help * help;
  }
  const double own = runs.size() < 2 ? 0.0 : std::sqrt(std::max(0.0, (square - n * mean * mean) / (n - 1.0)));
  return 1.0 - std::exp(-std::max(scatter_of_help, own) / std::sqrt(n));
}

HeldOut held_out_of(std::vector<LeftOut> runs) {
  HeldOut result{std::move(runs), 0.0, 0.0};
  if (result.runs.empty()) return result;
  const auto share = 1.0 / static_cast<double>(result.runs.size());
  for (const LeftOut& one : result.runs) {
    result.before += share * logarithm(one.before);
    result.after += share * logarithm(one.after);
  }
  result.before = std::exp(result.before), result.after = std::exp(result.after);
  return result;
}

HeldOut leave_one_out(const FreeRuns& f, const std::vector<effects::Applied>& effects, double strength) {
  std::vector<LeftOut> runs;
  const std::size_t n = f.samples.size();
  std::vector<std::size_t> telling;
  for (std::size_t r = 0; r < n; ++r)
    if (f.samples[r].size > 0) telling.push_back(r);
  if (telling.size() < 2) return {};
  for (const std::size_t r : telling) try {
      std::vector<char> others(n, 1);
      others[r] = 0;
      const FreeFit without = fit_strength(f, others), with = fit_free(f, effects, strength, others);
      const auto error = [&](const FreeFit& fit) {
        Eigen::VectorXd eta = f.eta;
        eta[f.layout.bed_strength] = fit.strength;
        return compare(*f.data, f.layout, r, f.data->runs[r], eta, fit.effects);
      };
      LeftOut one{f.data->runs[r].id, error(without), error(with), 0.0};
      one.gain = told_by_a_run * std::log(std::max(1e-6, one.before.total) / std::max(1e-6, one.after.total));
      runs.push_back(std::move(one));
    } catch (const SolveError&) {
      continue;
    }
  return held_out_of(std::move(runs));
}

}  // namespace apc::learning
