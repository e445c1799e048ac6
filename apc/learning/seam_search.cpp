#include "apc/learning/seam_search.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "apc/base/parallel.h"
#include "apc/base/require.h"

namespace apc::learning {
namespace {

constexpr int harmonics = 4, per_gear = 1 + 2 * harmonics, offsets = 24;
constexpr double widths[] = {0.06, 0.12, 0.2};                   // m
constexpr double depths[] = {0.03, 0.07, 0.13, 0.2, 0.3, 0.45};  // evenly likely
constexpr double two_pi = 2.0 * std::numbers::pi;

/// Strength × (1 − q cos(2πmx/p − phase)) under the nose or the other tires; m = 0: × (1 − q).
effects::Effect harmonic(int m, double pitch, double phase, bool nose) {
  effects::Effect e;
  e.id = "harmonic";
  e.parameters = {{"q", "", dimension::none, -1.0, 1.0, 0.1, 0.0}};
  e.bed = [m, pitch, phase, nose](const effects::TireState& state, effects::Values q, effects::TireChange& change) {
    if (state.bed_distance > 0.0 && state.nose == nose)
      change.strength *= 1.0 - q[0] * std::cos(two_pi * m * state.bed_distance / pitch - phase);
  };
  return e;
}

/// Fourier coefficient of raised-cosine joints of half-width w every p.
double coefficient(int m, double width, double pitch) {
  if (m == 0) return width / pitch;
  const double k = two_pi * m / pitch, kw = k * width / std::numbers::pi;
  if (std::abs(kw - 1.0) < 1e-6) return width / pitch;
  return 2.0 / pitch * std::sin(k * width) / (k * (1.0 - kw * kw));
}

/// The responses of one run to all harmonics, and where along the bed each row was taken.
struct Responses {
  Eigen::MatrixXd columns;  ///< rows × 2 × (1 + 2 · harmonics): nose: uniform, cos 1, sin 1, cos 2, …; then the others
  Eigen::VectorXd place;  ///< of the nose wheel
  double behind = 0.0;    ///< the other gears, mean, m
};

Eigen::VectorXd places_of(const Background& b, std::size_t r) {
  const Run& run = b.runs[r];
  const Rows& rows = b.rows[r];
  const auto& history = b.traces[r].result.history;
  Eigen::VectorXd place = Eigen::VectorXd::Zero(rows.size);
  std::size_t k = 0;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    k = 0;
    for (std::size_t i = 0; i < rows.samples[c]; ++i) {
      while (k + 1 < history.time.size() && history.time[k + 1] < run.channels[c].time[i]) ++k;
      place[rows.channel_start[c] + static_cast<Eigen::Index>(i)] = history.distance[k];
    }
  }
  for (std::size_t i = 0; i < rows.nose_rut.size(); ++i)
    place[rows.nose_rut_start + static_cast<Eigen::Index>(i)] = run.survey->distance[rows.nose_rut[i]];
  for (std::size_t i = 0; i < rows.main_rut.size(); ++i)
    place[rows.main_rut_start + static_cast<Eigen::Index>(i)] = run.survey->distance[rows.main_rut[i]];
  return place;
}

/// Column for depth 1 of joints at `offset` seen through a stretched way, whitened.
Eigen::MatrixXd column_of(const Background& b, std::size_t r, const Responses& responses, double pitch, double width,
                          double offset, double stretch) {
  const Eigen::Index rows = responses.columns.rows();
  Eigen::MatrixXd column = coefficient(0, width, pitch) * (responses.columns.col(0) + responses.columns.col(per_gear));
  // Every harmonic is the first one's phase, multiplied; the other gears lie behind the nose wheel, less stretched.
  Eigen::ArrayXcd turn(rows), power = Eigen::ArrayXcd::Ones(rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    turn[i] = std::polar(1.0, two_pi * (offset - stretch * responses.place[i]) / pitch);
  const std::complex<double> back = std::polar(1.0, two_pi * stretch * responses.behind / pitch);
  std::complex<double> back_power = 1.0;
  for (int m = 1; m <= harmonics; ++m) {
    power *= turn, back_power *= back;
    const double c = coefficient(m, width, pitch);
    const auto add = [&](const Eigen::ArrayXcd& phase, int first) {
      column.array() += c * (phase.real() * responses.columns.col(first + 2 * m - 1).array() +
                             phase.imag() * responses.columns.col(first + 2 * m).array());
    };
    add(power, 0);
    add(power * back_power, per_gear);
  }
  whiten_rows(b, r, column);
  return column;
}

/// What one run says to joints at its own offset and stretch: score and information, the run's nuisances integrated
/// out.
struct Word {
  double score = 0.0, information = 0.0;
};

class RunView {
 public:
  RunView(const Background& b, std::size_t r) : S_(b.linear[r].S) {
    const RunLinear& l = b.linear[r];
    const auto n = static_cast<Eigen::Index>(l.columns.size());
    Eigen::MatrixXd M = S_.transpose() * S_;
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index k = 0; k < n; ++k)
        M(i, k) += b.prior.precision(l.columns[static_cast<std::size_t>(i)], l.columns[static_cast<std::size_t>(k)]);
    factor_.compute(M);
    misfit_ = l.misfit;
  }
  /// At the fit the nuisances are settled (Sᵀ misfit = P⁻¹ offset), so the score is the plain product.
  Word hear(const Eigen::MatrixXd& column) const {
    const Eigen::VectorXd half = factor_.matrixL().solve(S_.transpose() * column);
    return {column.col(0).dot(misfit_), column.squaredNorm() - half.squaredNorm()};
  }

 private:
  const Eigen::MatrixXd& S_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd misfit_;
};

double log_sum(double a, double b) {
  const double high = std::max(a, b);
  return std::isinf(high) ? high : high + std::log1p(std::exp(std::min(a, b) - high));
}

/// All words of one run: width × offset × stretch.
struct Words {
  std::vector<double> stretches;
  std::vector<Word> word;
  const Word& at(std::size_t w, int o, std::size_t e) const {
    return word[(w * static_cast<std::size_t>(offsets) + static_cast<std::size_t>(o)) * stretches.size() + e];
  }
};

/// Joints shallower than the scatter from block to block (5 to 12 %) cannot be told from it; what the search finds
/// there is what the model of the bounce lacks.
constexpr double least_depth = 0.05;

SeamFit fit_pitch(const Background& b, const effects::Effect& seams, double pitch) {
  const std::size_t runs = b.training;
  std::vector<Responses> responses(runs);
  constexpr int columns = 2 * per_gear;
  double behind = 0.0, wheels = 0.0;
  for (const auto& gear : b.data->aircraft.gears)
    if (!gear.is_nose()) behind += gear.behind_nose_gear * gear.wheels(), wheels += gear.wheels();
  std::vector<Eigen::VectorXd> base(runs);
  for (std::size_t r = 0; r < runs; ++r) {
    base[r] = predict(b.runs[r], b.rows[r], b.traces[r], b.layout.runs[r], b.eta, b.data->aircraft);
    responses[r] = {Eigen::MatrixXd::Zero(b.rows[r].size, columns), places_of(b, r), behind / wheels};
  }
  parallel_for(runs * columns, b.threads, [&](std::size_t job) {
    const std::size_t r = job / columns;
    const int column = static_cast<int>(job % columns), k = column % per_gear, m = (k + 1) / 2;
    auto added = b.added;
    constexpr double step = 0.05;
    added.push_back(effects::applied(
        harmonic(m, pitch, k % 2 == 0 && k > 0 ? 0.5 * std::numbers::pi : 0.0, column < per_gear), step));
    try {
      const Trace trace = simulate_run(*b.data, b.layout, r, b.runs[r], b.eta, added, b.guides[r]);
      responses[r].columns.col(column) =
          (predict(b.runs[r], b.rows[r], trace, b.layout.runs[r], b.eta, b.data->aircraft) - base[r]) / step;
    } catch (const SolveError&) {
      return;  // this run stays silent on this harmonic
    }
  });

  std::vector<Words> words(runs);
  parallel_for(runs, b.threads, [&](std::size_t r) {
    const RunView view(b, r);
    const RunLayout& at = b.layout.runs[r];
    const double deviation = 1.0 / std::sqrt(b.prior.precision(at.stretch, at.stretch));
    const double way = std::max(10.0, responses[r].place.maxCoeff());
    const int reach = std::max(1, static_cast<int>(std::ceil(2.5 * deviation * way / (0.2 * pitch))));
    for (int i = -reach; i <= reach; ++i) words[r].stretches.push_back(2.5 * deviation * i / reach);
    for (const double width : widths)
      for (int o = 0; o < offsets; ++o)
        for (const double stretch : words[r].stretches)
          words[r].word.push_back(view.hear(column_of(b, r, responses[r], pitch, width, pitch * o / offsets, stretch)));
  });

  SeamFit fit;
  fit.applied = effects::applied(seams, 0.0);
  fit.applied.values[1] = pitch;
  fit.places.resize(runs);
  double best = -std::numeric_limits<double>::infinity(), sum = best;
  std::vector<std::array<double, 2>> places(runs);
  std::vector<Word> chosen(runs), best_words(runs);
  std::vector<std::pair<double, double>> best_spots(runs);
  for (std::size_t w = 0; w < std::size(widths); ++w)
    for (int o = 0; o < offsets; ++o)
      for (const double depth : depths) {
        double total = 0.0;
        std::vector<std::pair<double, double>> spots(runs);  // own offset, stretch
        for (std::size_t r = 0; r < runs; ++r) {
          const RunLayout& at = b.layout.runs[r];
          const double shift_precision = b.prior.precision(at.shift, at.shift),
                       stretch_precision = b.prior.precision(at.stretch, at.stretch);
          double likely = -std::numeric_limits<double>::infinity(), weight = likely, highest = likely;
          for (int own = 0; own < offsets; ++own) {
            double away = pitch * (own - o) / offsets;
            away -= pitch * std::round(away / pitch);
            for (std::size_t e = 0; e < words[r].stretches.size(); ++e) {
              const double stretch = words[r].stretches[e];
              const double prior = -0.5 * (away * away * shift_precision + stretch * stretch * stretch_precision);
              const Word& word = words[r].at(w, own, e);
              const double value = prior + depth * word.score - 0.5 * depth * depth * word.information;
              likely = log_sum(likely, value), weight = log_sum(weight, prior);
              if (value > highest) {
                highest = value, chosen[r] = word, places[r] = {-away, stretch};
                spots[r] = {pitch * own / offsets, stretch};
              }
            }
          }
          total += likely - weight;
        }
        sum = log_sum(sum, total);
        if (total > best) {
          best = total, fit.places = places, best_words = chosen, best_spots = spots;
          fit.applied.values[2] = widths[w], fit.applied.values[3] = pitch * o / offsets;
        }
      }
  // Evidence of the search less that of the chosen column alone (half-normal amplitude, as it will be weighed).
  const double evidence = sum - std::log(static_cast<double>(std::size(widths) * offsets * std::size(depths)));
  double score = 0.0, information = 0.0;
  for (const Word& word : best_words) score += word.score, information += word.information;
  const auto& amplitude = seams.parameters.front();
  const double precision = std::pow(1.96 / (amplitude.high - amplitude.neutral), 2);
  const double alone =
      0.5 * score * score / (information + precision) - 0.5 * std::log1p(information / precision) + std::log(2.0);
  fit.log_weight = std::min(0.0, evidence - alone);
  fit.depth = score / (information + precision);
  for (std::size_t r = 0; r < runs; ++r)
    fit.columns.push_back(
        column_of(b, r, responses[r], pitch, fit.applied.values[2], best_spots[r].first, best_spots[r].second));
  return fit;
}

}  // namespace

std::vector<SeamFit> search_seams(const Background& b, const effects::Effect& seams) {
  expect(seams.parameters.size() == 4, "joints have depth, pitch, width and offset");
  const double block = b.data->bed.block_length > 0.0 ? b.data->bed.block_length : 1.2192;
  std::vector<SeamFit> result;
  for (const double pitch : {block, 2.0 * block}) {  // blocks end at one pitch or at whole multiples of it
    if (pitch < seams.parameters[1].low || pitch > seams.parameters[1].high) continue;
    if (SeamFit fit = fit_pitch(b, seams, pitch); fit.depth >= least_depth) result.push_back(std::move(fit));
  }
  return result;
}

}  // namespace apc::learning
