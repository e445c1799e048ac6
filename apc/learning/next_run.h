/// Which run to do next: where, how fast, how heavy and with which instruments the explanations that the runs so far
/// leave standing would show themselves apart, and what each of them would show there.
///
/// Every explanation is first fitted to the runs at hand (its amplitudes with bed strength, table errors and
/// aerodynamics, Gauss–Newton through free simulations, on the numbers of segments.h). A candidate run is then
/// predicted by each, with mean h and covariance V; two of them are Δ apart,
///     Δ² = ½ dᵀ(V_j⁻¹ + V_k⁻¹) d + ½ tr(V_j⁻¹V_k + V_k⁻¹V_j − 2),   d = h_j − h_k
/// (the divergence of Box and Hill, Technometrics 9 (1967) 57; dᵀV⁻¹d where the covariances are alike). V holds
/// instruments, blocks, what steady tables leave open, entry conditions, and what the runs at hand leave uncertain of
/// bed, tables and amplitudes. Where a single explanation stands, a candidate is worth what it takes off the
/// uncertainty of the effects that were not found.
#pragma once

#include <array>

#include "apc/learning/diagnose.h"

namespace apc::learning {

/// One explanation, as far as predictions need it; no effects: nothing is missing.
struct Contender {
  std::vector<effects::Applied> effects;  ///< with amplitudes fitted to the runs at hand
  Eigen::VectorXd eta;                    ///< bed, tables and aerodynamics fitted with them, as in Layout
  double misfit = 0.0;                    ///< root mean square of what it leaves of the runs at hand, in deviations
  std::string name() const;               ///< "inertial + slope", "nothing missing"
};

/// Instruments of a candidate run; where it stopped is measured in any case.
struct SensorSet {
  std::vector<Quantity> channels;
  bool survey = false;  ///< of the ruts
  std::vector<std::string> names() const;
};

/// What one explanation expects of a run, SI.
struct Expectation {
  double stop = 0.0, exit_speed = 0.0;  ///< NaN where it leaves the bed; 0 where it stops
  double peak_deceleration = 0.0, mean_deceleration = 0.0;
  double peak_nose_drag = 0.0, mean_nose_drag = 0.0;  ///< N, whole gear group
  double nose_rut = 0.0, main_rut = 0.0;              ///< m, mean along the way
};

struct CandidateRun {
  double speed = 0.0, mass = 0.0;
  bool simulated = false, stops = false;   ///< by every explanation
  std::vector<double> separation;          ///< per sensor set, of the two explanations hardest to tell apart
  std::vector<std::vector<double>> pairs;  ///< per sensor set, of each pair of NextPlan::pairs
  std::vector<Expectation> expects;        ///< per contender
  std::size_t a = 0, b = 0;                ///< the two, with all sensors
};

struct NextPlan {
  std::vector<Contender> contenders;
  bool sharpens = false;  ///< a single explanation stands: `separation` is how many deviations an effect of usual size
                          ///< would stand out, in the median over the catalogue, with the run added
  double sharpness_now = 0.0;                     ///< the same without the run
  std::vector<std::array<std::size_t, 2>> pairs;  ///< of contenders
  std::vector<bool> hopeless;                     ///< pairs that no run of the grid separates by one deviation
  std::vector<double> speeds, masses;
  std::vector<SensorSet> sets;           ///< cheapest first
  std::vector<CandidateRun> candidates;  ///< speed by speed, masses within
  std::vector<std::size_t> best;         ///< indices of the three best, and the sensor set each needs
  std::vector<std::size_t> best_set;
  const CandidateRun& at(std::size_t speed, std::size_t mass) const { return candidates[speed * masses.size() + mass]; }
  std::vector<NextRun> recommended() const;
};

struct NextOptions {
  std::vector<double> speeds, masses;  ///< empty: every 5 kt inside the tables, five masses in service
  bool coarse = false;                 ///< every 10 kt and three masses
  unsigned threads = 0;
  Report report;
};

/// `sets`: explanations, the likeliest first (empty members: nothing missing); `catalogue`: what a single explanation's
/// next run should be sharp for. InputError when no run of the grid can be simulated.
NextPlan plan_next(const Case&, const std::vector<std::vector<effects::Applied>>& sets,
                   const std::vector<effects::Effect>& catalogue, const NextOptions&);

/// The members of a 90 % set; where it has only one, those that cannot be told from it (separability below 3) beside
/// it. Parameters are those of `claims`, else the usual ones: amplitudes are fitted anyway. InputError on an unknown
/// id.
std::vector<std::vector<effects::Applied>> contenders_of(const std::vector<std::vector<std::string>>& set90,
                                                         const std::vector<Rival>&,
                                                         const std::vector<effects::Applied>& claims,
                                                         const std::vector<effects::Effect>& known);

}  // namespace apc::learning
