#include "apc/learning/free_evidence.h"

#include <algorithm>
#include <cmath>

#include "apc/base/require.h"
#include "apc/learning/shapes.h"

namespace apc::learning {
namespace {

using effects::Applied;
using effects::Effect;

constexpr std::size_t most_fits = 14;
/// Below this a fit is not worth a search: evidence of free runs is never counted below 0.
constexpr double hopeless = -1.0;

struct Promising {
  Applied shape;
  double amplitude = 0.0, gain = 0.0;
};

/// The linear model around strength and levels fitted without effects.
class Linear {
 public:
  explicit Linear(const FreeEvidence& e) : e_(e) {
    const double sigma = e.runs.data->bed_strength, step = 0.5 * sigma;
    const Column by_strength = column(free_misfits(e.runs, e.none.strength + step, {}, {}, e.none.levels), step);
    weight_ = told_by(e.runs).weight(e.none.square);
    nuisance_.push_back(by_strength);
    std::vector<double> here = {e.none.strength}, deviation = {sigma};
    for (std::size_t r = 0; r < e.runs.samples.size(); ++r) {
      if (e.runs.samples[r].size == 0) continue;
      Column level = by_strength;  // the strength, but of one run
      for (std::size_t k = 0; k < level.size(); ++k)
        if (k != r) level[k].setZero();
      nuisance_.push_back(std::move(level));
      here.push_back(e.none.levels[r]), deviation.push_back(e.runs.level_deviation[r]);
    }
    const auto n = static_cast<Eigen::Index>(nuisance_.size());
    Eigen::MatrixXd information(n, n);
    gradient_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double precision = 1.0 / (deviation[k] * deviation[k]);
      information.col(i) = shared_with(nuisance_[k]);
      information(i, i) += precision;
      gradient_[i] = dot(nuisance_[k], e.none.misfit) - precision * here[k];
    }
    factor_.compute(information);
  }

  Promising at(const Applied& shape) const {
    const effects::Parameter& p = shape.effect.parameters.front();
    const double step = 0.3 * (p.usual - p.neutral);
    Applied moved = shape;
    moved.values.front() = p.neutral + step;
    const auto by_amplitude = column(free_misfits(e_.runs, e_.none.strength, {moved}, {}, e_.none.levels), step);
    const Eigen::VectorXd shared = shared_with(by_amplitude);
    const double gradient = dot(by_amplitude, e_.none.misfit) - shared.dot(factor_.solve(gradient_));
    const double information =
        dot(by_amplitude, by_amplitude) + 1.0 / std::pow(amplitude_deviation(p), 2) - shared.dot(factor_.solve(shared));
    const double amplitude =
        std::clamp(gradient / information, std::min(0.0, p.low - p.neutral), std::max(0.0, p.high - p.neutral));
    return {shape, amplitude, amplitude * gradient - 0.5 * amplitude * amplitude * information};
  }

 private:
  using Column = std::vector<Eigen::VectorXd>;
  Column column(Column moved, double step) const {
    for (std::size_t r = 0; r < moved.size(); ++r) moved[r] = (e_.none.misfit[r] - moved[r]) / step;
    return moved;
  }
  double dot(const Column& a, const Column& b) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < a.size(); ++r) sum += a[r].dot(b[r]);
    return weight_ * sum;
  }
  Eigen::VectorXd shared_with(const Column& a) const {
    Eigen::VectorXd shared(static_cast<Eigen::Index>(nuisance_.size()));
    for (std::size_t k = 0; k < nuisance_.size(); ++k) shared[static_cast<Eigen::Index>(k)] = dot(a, nuisance_[k]);
    return shared;
  }

  const FreeEvidence& e_;
  std::vector<Column> nuisance_;  ///< strength, then levels
  Eigen::VectorXd gradient_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  double weight_ = 0.0;
};

FreeSet searched_set(const FreeEvidence& e, FreeSet set) {
  set.fit = searched(e.runs, std::move(set.fit));
  set.log_evidence = log_evidence_of(set.fit, e.none);
  return set;
}

/// From the linear model's amplitude, and from half the usual one where that leads nowhere.
std::optional<FreeSet> fitted(const FreeEvidence& e, const Promising& start) {
  std::optional<FreeSet> best;
  const effects::Parameter& p = start.shape.effect.parameters.front();
  for (const double amplitude : {start.amplitude, 0.5 * (p.usual - p.neutral)}) try {
      Applied applied = start.shape;
      applied.values.front() = p.neutral + amplitude;
      FreeSet set{fit_free(e.runs, {applied}, e.none.strength), 0.0};
      set.log_evidence = log_evidence_of(set.fit, e.none);
      if (!best || best->log_evidence < set.log_evidence) best = std::move(set);
      if (best->log_evidence > 1.0) break;
    } catch (const SolveError&) {
      continue;  // the other start
    }
  if (best && best->log_evidence > hopeless) best = searched_set(e, std::move(*best));
  return best;
}

}  // namespace

bool known_by_date(const Effect& effect) {
  if (!effect.bed) return false;
  std::vector<double> values;
  for (const auto& p : effect.parameters) values.push_back(p.usual);
  effects::TireState state;
  state.bed_distance = state.nose_distance = 20.0, state.speed = 20.0, state.bed_depth = 0.4, state.penetration = 0.2;
  state.tire_width = 0.3, state.tire_radius = 0.5, state.density = 300.0, state.temperature = 293.15;
  const auto strength = [&](double years, double temperature) {
    state.years = years, state.temperature = temperature;
    effects::TireChange change;
    effect.bed(state, values, change);
    return change.strength;
  };
  return strength(1.0, 293.15) != strength(9.0, 293.15) || strength(1.0, 273.15) != strength(1.0, 303.15);
}

double FreeEvidence::of(const std::vector<std::string>& ids) const {
  const auto own = sets.find(ids);
  double best = own == sets.end() ? 0.0 : own->second.log_evidence;
  if (own == sets.end() && ids.size() > 1)
    for (const std::string& id : ids)
      if (const auto one = sets.find({id}); one != sets.end()) best = std::max(best, one->second.log_evidence);
  return std::max(0.0, best);
}

std::optional<FreeEvidence> weigh_free(const Case& data, const std::vector<Effect>& effects, unsigned threads,
                                       const Report& report) {
  FreeEvidence e;
  e.runs = free_runs(data, threads);
  if (std::none_of(e.runs.samples.begin(), e.runs.samples.end(), [](const FreeSamples& s) { return s.size > 0; }))
    return std::nullopt;
  std::vector<Promising> promising;
  std::map<std::string, double> forms;
  try {
    e.none = searched(e.runs, fit_strength(e.runs));
    const Linear linear(e);
    double longest = 0.0;
    for (const Run& run : data.runs)
      longest = std::max(longest, std::min(run.stop.value_or(data.bed.length()), data.bed.length()));
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const Effect& effect = effects[i];
      if (effect.fine) continue;
      forms[effect.id] += 1.0;
      std::optional<Promising> best;
      for (const Applied& shape : shapes_of(effect, longest)) try {
          const Promising one = linear.at(shape);
          if (!best || best->gain < one.gain) best = one;
        } catch (const SolveError&) {
          continue;  // a shape that cannot be run
        }
      if (best) promising.push_back(*best);
      if (report) report(0.5 * static_cast<double>(i + 1) / static_cast<double>(effects.size()), "free runs");
    }
  } catch (const SolveError&) {
    return std::nullopt;
  }
  std::stable_sort(promising.begin(), promising.end(),
                   [](const Promising& a, const Promising& b) { return a.gain > b.gain; });
  const std::size_t count = std::min(most_fits, promising.size());
  std::map<std::string, double> sum;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& id = promising[i].shape.effect.id;
    auto set = fitted(e, promising[i]);
    if (set) {
      sum[id] += std::exp(set->log_evidence) / forms[id];
      const auto [at, fresh] = e.sets.try_emplace({id}, *set);
      if (!fresh && at->second.log_evidence < set->log_evidence) at->second = std::move(*set);
    }
    if (report) report(0.5 + 0.5 * static_cast<double>(i + 1) / static_cast<double>(count), "fitting free runs");
  }
  for (auto& [ids, set] : e.sets) set.log_evidence = std::log(sum[ids.front()]);
  return e;
}

void add_pair(FreeEvidence& e, const std::vector<Applied>& pair) {
  std::vector<std::string> ids;
  std::vector<FreeSet> single;
  for (const Applied& a : pair) {
    if (a.effect.fine) return;
    ids.push_back(a.effect.id);
    const auto own = e.sets.find({a.effect.id});
    single.push_back(own != e.sets.end() ? own->second : FreeSet{e.none, -1e300});
    if (own == e.sets.end()) single.back().fit.effects = {a};
  }
  std::sort(ids.begin(), ids.end());
  if (e.sets.contains(ids)) return;
  const bool first = single[0].log_evidence > single[1].log_evidence;
  const FreeFit& better = single[first ? 0 : 1].fit;
  Applied other = single[first ? 1 : 0].fit.effects.front();
  const effects::Parameter& p = other.effect.parameters.front();
  std::optional<FreeSet> best;
  for (const double amplitude : {other.values.front(), p.neutral + 0.3 * (p.usual - p.neutral)}) try {
      other.values.front() = amplitude;
      FreeSet set{fit_free(e.runs, {better.effects.front(), other}, better.strength), 0.0};
      set.log_evidence = log_evidence_of(set.fit, e.none);
      if (!best || best->log_evidence < set.log_evidence) best = std::move(set);
    } catch (const SolveError&) {
      continue;
    }
  if (!best) return;
  e.sets[ids] = std::move(*best);  // its start was searched; a search in one more direction finds more of what is rough
}

}  // namespace apc::learning
