#include "apc/learning/next_run.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/next_fit.h"
#include "apc/learning/weighing.h"

namespace apc::learning {
namespace {

using effects::Applied;
using effects::Effect;

Expectation expected(const Field& f, const Trace& trace) {
  Expectation e;
  const auto& result = trace.result;
  const auto& h = result.history;
  const bool stopped = result.exit_speed <= 0.0;
  e.stop = stopped ? trace.stop : std::nan(""), e.exit_speed = stopped ? 0.0 : result.exit_speed;
  e.peak_deceleration = result.peak_deceleration, e.mean_deceleration = result.mean_deceleration;
  for (std::size_t g = 0; g < f.data.aircraft.gears.size(); ++g) {
    const auto& gear = h.gears[g];
    const bool nose = f.data.aircraft.gears[g].is_nose();
    double rut = 0.0, count = 0.0, drag = 0.0;
    for (std::size_t i = 0; i < h.time.size(); ++i) {
      if (gear.distance[i] < 0.0 || h.speed[i] < 1.0) continue;
      rut += gear.rut[i], drag += gear.drag[i], count += 1.0;
      if (nose) e.peak_nose_drag = std::max(e.peak_nose_drag, gear.drag[i]);
    }
    (nose ? e.nose_rut : e.main_rut) = rut / std::max(1.0, count);
    if (nose) e.mean_nose_drag = drag / std::max(1.0, count);
  }
  return e;
}

std::vector<Eigen::Index> read_by(const SensorSet& set, const Run& run, const Segments& s) {
  std::vector<Eigen::Index> list;
  for (std::size_t k = 0; k < s.features.size(); ++k) {
    const Feature& f = s.features[k];
    const bool channel = f.kind == Feature::Kind::mean || f.kind == Feature::Kind::slowing;
    const Quantity q = run.channels[channel ? f.channel : 0].quantity;
    const bool rut = f.kind == Feature::Kind::nose_rut || f.kind == Feature::Kind::main_rut;
    if (rut ? !set.survey : channel && std::find(set.channels.begin(), set.channels.end(), q) == set.channels.end())
      continue;
    list.push_back(static_cast<Eigen::Index>(k));
  }
  return list;
}

/// The state of knowledge about one effect that was not found, besides the explanation that stands.
struct Unseen {
  Applied effect;
  Fitted fitted;  ///< with the effect at its neutral amplitude
  double deviation() const {
    return std::sqrt(fitted.covariance(fitted.covariance.rows() - 1, fitted.covariance.cols() - 1));
  }
};

double median(std::vector<double> list) {
  if (list.empty()) return 0.0;
  std::sort(list.begin(), list.end());
  return list[list.size() / 2];
}

double usual_size(const Effect& e) { return std::abs(e.parameters.front().usual - e.parameters.front().neutral); }

/// Sensitivities of a run with those of one at the same speed and another mass: relative changes are the same.
void borrow(const Numbers& neighbour, Numbers& n) {
  n.columns = neighbour.columns;
  n.by_unknown = neighbour.by_unknown;
  for (Eigen::Index k = 0; k < n.value.size(); ++k) {
    const double ratio = n.value[k] / neighbour.value[k];
    if (std::isfinite(ratio)) n.by_unknown.row(k) *= std::clamp(ratio, 0.5, 2.0);
  }
}

/// What is uncertain of the shared unknowns once the amplitudes are known.
Eigen::MatrixXd given_amplitudes(const Fitted& fitted, Eigen::Index globals) {
  const Eigen::Index n = fitted.covariance.rows() - globals;
  const Eigen::MatrixXd all = fitted.covariance.topLeftCorner(globals, globals);
  if (n == 0) return all;
  const Eigen::MatrixXd cross = fitted.covariance.topRightCorner(globals, n);
  return all - cross * fitted.covariance.bottomRightCorner(n, n).ldlt().solve(cross.transpose());
}

/// `neighbour`: another candidate at this speed, or empty; becomes this one's numbers.
void weigh_candidate(const Case& data, const Field& known, const std::vector<Fitted>& fits,
                     const std::vector<Unseen>& unseen, const std::vector<SensorSet>& sets,
                     const std::vector<std::array<std::size_t, 2>>& pairs, Numbers& neighbour,
                     CandidateRun& candidate) {
  const Field f = field_with(data, candidate_run(data, candidate.speed, candidate.mass));
  const std::size_t r = data.runs.size();
  const Eigen::Index globals = known.globals();
  std::vector<Trace> traces;
  std::vector<Eigen::VectorXd> eta;
  double shortest = data.bed.length();
  candidate.stops = true;
  for (const Fitted& fit : fits) {
    eta.push_back(Eigen::VectorXd::Zero(f.layout.size));
    eta.back().head(globals) = fit.contender.eta.head(globals);
    traces.push_back(simulate_run(f.data, f.layout, r, f.runs[r], eta.back(), fit.contender.effects));
    shortest = std::min(shortest, traces.back().stop);
    candidate.stops = candidate.stops && traces.back().result.exit_speed <= 0.0;
    candidate.expects.push_back(expected(f, traces.back()));
  }
  Numbers n;
  n.segments = make_segments(f.runs[r], shortest);
  n.trace = traces.front();
  n.value = simulated_features(f.runs[r], n.segments, n.trace, f.data.aircraft);
  if (neighbour.value.size() == n.value.size())
    borrow(neighbour, n);
  else
    differentiate(f, r, eta.front(), fits.front().contender.effects, n);
  neighbour = n;
  const Eigen::MatrixXd own = own_covariance(f, r, n);
  std::vector<Eigen::VectorXd> value;
  std::vector<Eigen::MatrixXd> predictive;
  for (std::size_t j = 0; j < fits.size(); ++j) {
    value.push_back(simulated_features(f.runs[r], n.segments, traces[j], f.data.aircraft));
    const Eigen::MatrixXd spread = amplitude_spread(f, r, n.segments, value[j], fits[j]), J = joint_columns(f, n, {}),
                          C = given_amplitudes(fits[j], globals);
    predictive.push_back(own + J * C * J.transpose() + spread * spread.transpose());
  }
  std::vector<Eigen::MatrixXd> unseen_columns;
  for (const Unseen& u : unseen) {
    std::vector<Applied> effects = u.fitted.contender.effects;
    std::vector<Eigen::VectorXd> amplitudes;
    for (std::size_t k = 0; k < effects.size(); ++k)
      amplitudes.push_back(by_amplitude(f, r, n.segments, n.value, eta.front(), effects, k, 1.0));
    unseen_columns.push_back(joint_columns(f, n, amplitudes));
  }
  for (const SensorSet& set : sets) {
    const auto rows = read_by(set, f.runs[r], n.segments);
    if (!unseen.empty()) {
      std::vector<double> sizes;
      for (std::size_t u = 0; u < unseen.size(); ++u) {
        const Eigen::MatrixXd J = unseen_columns[u](rows, Eigen::all), &C = unseen[u].fitted.covariance;
        const Eigen::VectorXd seen = J * C.col(C.cols() - 1);
        const Eigen::MatrixXd V = own(rows, rows) + J * C * J.transpose();
        const double left = C(C.rows() - 1, C.cols() - 1) - seen.dot(V.ldlt().solve(seen));
        sizes.push_back(usual_size(unseen[u].effect.effect) / std::sqrt(std::max(1e-300, left)));
      }
      candidate.separation.push_back(median(sizes));
      continue;
    }
    std::vector<double>& apart = candidate.pairs.emplace_back();
    std::vector<Eigen::LDLT<Eigen::MatrixXd>> factor;
    for (const auto& V : predictive) factor.emplace_back(Eigen::MatrixXd(V(rows, rows)));
    for (const auto& [j, k] : pairs) {
      const Eigen::VectorXd d = (value[j] - value[k])(rows);
      const Eigen::MatrixXd Vj = predictive[j](rows, rows), Vk = predictive[k](rows, rows);
      const double means = 0.5 * (d.dot(factor[j].solve(d)) + d.dot(factor[k].solve(d))),
                   spreads = 0.5 * (factor[j].solve(Vk).trace() + factor[k].solve(Vj).trace()) -
                             static_cast<double>(d.size());
      apart.push_back(std::sqrt(std::max(0.0, means + spreads)));
    }
  }
  candidate.simulated = true;
}

std::vector<double> even(double low, double high, double step) {
  std::vector<double> list;
  for (double x = std::ceil(low / step - 1e-6) * step; x <= high + 1e-6 * step; x += step) list.push_back(x);
  return list;
}

/// Every 5 (10) kt from where half of the way is rolled inside the tables to the fastest that all tables hold.
std::vector<double> speeds_for(const Case& data, bool coarse) {
  double low = 0.0, high = 1e9;
  for (const auto& table : data.tables)
    low = std::max(low, table.speed_range()[0]), high = std::min(high, table.speed_range()[1]);
  auto list = even(std::max(1.42 * low, 15.0 * units::kt), high, (coarse ? 10.0 : 5.0) * units::kt);
  if (list.empty()) list.push_back(high);
  return list;
}

/// Evenly over the masses in service: the runs', the file's, its ramp mass; where no file says so, from 0.75 to 1.1 of
/// the file's.
std::vector<double> masses_for(const Case& data, bool coarse) {
  double low = 0.75 * data.aircraft.mass,
         high = data.aircraft.ramp_mass > 0.0 ? data.aircraft.ramp_mass : 1.1 * data.aircraft.mass;
  for (const Run& run : data.runs)
    if (run.mass_known) low = std::min(low, run.overrun.mass), high = std::max(high, run.overrun.mass);
  std::vector<double> list;
  const int n = coarse ? 3 : 5;
  for (int i = 0; i < n; ++i) list.push_back(low + (high - low) * i / (n - 1.0));
  return list;
}

/// Separation of every candidate: of the pair hardest to tell apart among those that some run of the grid separates at
/// all. A pair that none does (two effects of the date, all runs on one day) would hide what the others tell.
void separate(NextPlan& plan) {
  plan.hopeless.assign(plan.pairs.size(), true);
  for (const CandidateRun& c : plan.candidates)
    if (c.simulated)
      for (std::size_t p = 0; p < plan.pairs.size(); ++p)
        if (c.pairs.back()[p] >= 1.0) plan.hopeless[p] = false;
  const bool none = std::all_of(plan.hopeless.begin(), plan.hopeless.end(), [](bool h) { return h; });
  for (CandidateRun& c : plan.candidates)
    if (c.simulated)
      for (const auto& pairs : c.pairs) {
        double least = 1e300;
        for (std::size_t p = 0; p < plan.pairs.size(); ++p)
          if ((none || !plan.hopeless[p]) && pairs[p] < least)
            least = pairs[p], c.a = plan.pairs[p][0], c.b = plan.pairs[p][1];
        c.separation.push_back(least);
      }
}

void choose(NextPlan& plan) {
  std::vector<std::size_t> order;
  const bool some_stop = std::any_of(plan.candidates.begin(), plan.candidates.end(),
                                     [](const CandidateRun& c) { return c.simulated && c.stops; });
  for (std::size_t i = 0; i < plan.candidates.size(); ++i)
    if (plan.candidates[i].simulated && (plan.candidates[i].stops || !some_stop)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return plan.candidates[a].separation.back() > plan.candidates[b].separation.back();
  });
  // The best, and two that are not its neighbours: what a neighbour would show is nearly the same.
  const auto far = [&](std::size_t i, std::size_t k) {
    const auto step = [&](std::size_t x, std::size_t y) { return x > y ? x - y : y - x; };
    const std::size_t n = plan.masses.size();
    return step(i / n, k / n) > 1 || step(i % n, k % n) > 1;
  };
  for (const std::size_t i : order) {
    if (plan.best.size() == 3) break;
    if (!std::all_of(plan.best.begin(), plan.best.end(), [&](std::size_t k) { return far(i, k); })) continue;
    plan.best.push_back(i);
    // The cheapest instruments that bring nine tenths of what all of them do.
    const auto& s = plan.candidates[i].separation;
    const double without = plan.sharpens ? plan.sharpness_now : 0.0,
                 wanted = std::min(s.back(), without + 0.9 * (s.back() - without));
    plan.best_set.push_back(
        static_cast<std::size_t>(std::find_if(s.begin(), s.end(), [&](double x) { return x >= wanted; }) - s.begin()));
  }
}

}  // namespace

std::string Contender::name() const {
  std::string text;
  for (const std::string& id : ids_of(effects)) text += (text.empty() ? "" : " + ") + id;
  return text.empty() ? "nothing missing" : text;
}

std::vector<std::string> SensorSet::names() const {
  std::vector<std::string> list = {"stop distance"};
  for (const Quantity q : channels) list.push_back(name_of(q));
  if (survey) list.emplace_back("rut survey");
  return list;
}

std::vector<NextRun> NextPlan::recommended() const {
  std::vector<NextRun> list;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const CandidateRun& c = candidates[best[i]];
    const SensorSet& set = sets[best_set[i]];
    list.push_back({c.speed, c.mass, set.channels, c.separation[best_set[i]], set.survey});
  }
  return list;
}

std::vector<std::vector<Applied>> contenders_of(const std::vector<std::vector<std::string>>& set90,
                                                const std::vector<Rival>& rivals, const std::vector<Applied>& claims,
                                                const std::vector<Effect>& known) {
  std::vector<std::vector<std::string>> sets = set90;
  if (sets.size() == 1)
    for (const Rival& rival : rivals)
      for (const auto& [a, b] : {std::pair{rival.a, rival.b}, std::pair{rival.b, rival.a}}) {
        std::vector<std::string> other = set90.front();
        const auto found = std::find(other.begin(), other.end(), a);
        if (rival.separability >= 3.0 || found == other.end() ||
            std::find(other.begin(), other.end(), b) != other.end())
          continue;
        *found = b;
        sets.push_back(std::move(other));
      }
  std::vector<std::vector<Applied>> result;
  for (const auto& ids : sets) {
    std::vector<Applied>& set = result.emplace_back();
    for (const std::string& id : ids) {
      const auto claim =
          std::find_if(claims.begin(), claims.end(), [&](const Applied& c) { return c.effect.id == id; });
      if (claim != claims.end()) {
        set.push_back(*claim);
        continue;
      }
      const Effect& effect = effects::find_effect(known, id);
      set.push_back(effects::applied(effect, effect.parameters.front().usual));
    }
  }
  return result;
}

NextPlan plan_next(const Case& data, const std::vector<std::vector<Applied>>& sets,
                   const std::vector<Effect>& catalogue, const NextOptions& options) {
  NextPlan plan;
  plan.speeds = options.speeds.empty() ? speeds_for(data, options.coarse) : options.speeds;
  plan.masses = options.masses.empty() ? masses_for(data, options.coarse) : options.masses;
  using enum Quantity;
  plan.sets = {{{}, false},
               {{speed}, false},
               {{speed, acceleration_x}, false},
               {{speed, acceleration_x}, true},
               {{speed, acceleration_x, nose_drag}, false},
               {{speed, acceleration_x, nose_drag}, true}};
  plan.sharpens = sets.size() < 2;
  const Field known = field_with(data, candidate_run(data, plan.speeds.front(), plan.masses.front()));
  const std::vector<Applied> first = sets.empty() ? std::vector<Applied>{} : sets.front();
  if (options.report) options.report(0.0, "fitting what stands to the runs at hand");
  const Training training = train(known, first, options.threads);
  std::vector<Fitted> fits;
  for (const auto& set : sets) fits.push_back(fit(known, training, set, options.threads, 4));
  if (fits.empty()) fits.push_back(fit(known, training, {}, options.threads, 4));
  std::vector<Unseen> unseen;
  if (plan.sharpens)
    for (const Effect& e : catalogue) {
      const auto ids = ids_of(first);
      if (e.fine || usual_size(e) == 0.0 || std::find(ids.begin(), ids.end(), e.id) != ids.end()) continue;
      std::vector<Applied> with = fits.front().contender.effects;
      with.push_back(effects::applied(e, e.parameters.front().neutral));
      unseen.push_back({with.back(), fit(known, training, with, options.threads, 1)});
    }
  std::vector<double> sizes;
  for (const Unseen& u : unseen) sizes.push_back(usual_size(u.effect.effect) / u.deviation());
  plan.sharpness_now = median(sizes);
  for (const Fitted& f : fits) plan.contenders.push_back(f.contender);
  for (std::size_t k = 1; k < fits.size(); ++k)
    for (std::size_t j = 0; j < k; ++j) plan.pairs.push_back({j, k});
  for (const double speed : plan.speeds)
    for (const double mass : plan.masses)
      plan.candidates.emplace_back().speed = speed, plan.candidates.back().mass = mass;
  std::mutex guard;
  std::size_t done = 0;
  const std::size_t n = plan.masses.size();
  parallel_for(plan.speeds.size(), options.threads, [&](std::size_t i) {
    Numbers neighbour;
    for (std::size_t k = 0; k < n; ++k) {
      CandidateRun& candidate = plan.candidates[i * n + k];
      try {
        weigh_candidate(data, known, fits, unseen, plan.sets, plan.pairs, neighbour, candidate);
      } catch (const SolveError&) {
        candidate.simulated = false;  // a run that cannot be simulated is none to recommend
      }
      const std::lock_guard lock(guard);
      ++done;
      if (options.report)
        options.report(0.3 + 0.7 * static_cast<double>(done) / static_cast<double>(plan.candidates.size()),
                       "trying runs");
    }
  });
  if (!plan.sharpens) separate(plan);
  choose(plan);
  require(!plan.best.empty(), "no run of this grid can be simulated. Choose other speeds or masses.");
  return plan;
}

}  // namespace apc::learning
