/// The verdict: which effect is missing, what cannot be told from it, and how large anything missed could be.
#pragma once

#include "apc/learning/along.h"
#include "apc/learning/free_evidence.h"
#include "apc/learning/held_out.h"
#include "apc/learning/refine.h"
#include "apc/learning/screen.h"

namespace apc::learning {

enum class Verdict { found, ambiguous, nothing, unexplained, sensor };
const char* text(Verdict);

/// One explanation: no effect, one, or two — or an instrument, or a learned force.
struct Explanation {
  std::vector<std::string> ids;  ///< effect ids, sorted; empty for nothing, sensors and learned forces
  Hypothesis::Kind kind = Hypothesis::Kind::effect;
  std::string label;  ///< sensors and learned forces: which
  SetFit fit;         ///< effects only
  bool fitted = false;
  double log_evidence = 0.0;   ///< over nothing: along the measured motion, else through guided runs
  double free_evidence = 0.0;  ///< over nothing: of free runs
  double probability = 0.0;
};

struct Claim {
  std::string id;
  double probability = 0.0;  ///< that it is missing: summed over explanations
  double p_family_wise = 1.0;
  effects::Applied applied;            ///< as in the best explanation that holds it
  std::vector<double> deviation;       ///< per parameter; NaN when it was held
  std::map<std::string, double> work;  ///< J, per run
};

struct Rival {
  std::string a, b;
  double correlation = 0.0, separability = 0.0;
};

struct SensorClaim {
  std::string run, what;  ///< run empty: all runs
  double value = 0.0, deviation = 0.0, log_evidence = 0.0;
};

struct NextRun {
  double speed = 0.0, mass = 0.0;
  std::vector<Quantity> sensors;
  double separation = 0.0;
  bool survey = false;  ///< of the ruts
};

struct Diagnosis {
  Verdict verdict = Verdict::nothing;
  std::vector<Explanation> explanations;        ///< most probable first
  std::vector<Claim> claims;                    ///< most probable first
  std::vector<std::vector<std::string>> set90;  ///< smallest set of explanations holding 90 %
  std::vector<Rival> rivals;
  std::vector<SensorClaim> sensors;
  std::map<std::string, double> smallest_detectable;  ///< "inertial.C", SI
  double unexplained_share = 0.0;
  std::string learned;  ///< what a learned force depends on; empty
  std::vector<NextRun> next;
  std::vector<effects::Applied> augmented;  ///< what `add` would add
  bool tried = false;                       ///< `augmented` proved itself on runs left out, and is no claim
  double seconds = 0.0;
};

struct DiagnoseOptions {
  unsigned threads = 0;
  unsigned seed = 1;
  std::vector<effects::Effect> effects;  ///< catalogue and own
  Report report;
};

/// Everything `diagnose` looked at, for reports and predictions.
struct Study {
  Background background;
  std::optional<Along> along;        ///< where every run was surveyed: the balance along the measured motion
  Screen screen;                     ///< along the measured motion where there is one, else through the simulator
  std::optional<FreeEvidence> free;  ///< where free runs can be simulated
  Diagnosis diagnosis;
  double strength = 0.0;  ///< ln of the bed's strength over its data sheet's, fitted with the effects of the diagnosis
  HeldOut held_out;       ///< what those effects do to runs they were not fitted to
};

Study diagnose(const Case&, const DiagnoseOptions&);

/// ∫ ΔF dx of one effect from entry to rest, at the states of the fitted motion, J.
double work_of(const Background&, std::size_t run, const effects::Applied&);

}  // namespace apc::learning
