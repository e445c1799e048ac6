/// Runs the fleet through trial beds: every case of every trial an overrun, on all cores, each one remembered under the
/// exact bits of the trial. An optimiser that is started again walks through what is remembered without a single run,
/// so a design stopped at any moment continues where it was.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "apc/design/constraint.h"
#include "apc/design/profile.h"
#include "apc/simulation/sensitivity.h"
#include "apc/study/store.h"

namespace apc::design {

struct Problem {
  Fleet fleet;
  std::vector<simulation::Model> models;  ///< one per case of the fleet; the model's bed is not used
  simulation::Options solver{simulation::Method::fast, 1e-8, 0.002, 120.0};
  unsigned threads = 0;  ///< 0 = all
  study::Solve solve;
  /// Derivatives of an overrun by another way than differences, to check gradients with; may be left out.
  std::function<simulation::Sensitivity(const simulation::Model&, const simulation::Overrun&,
                                        const simulation::ScalarParameter&, const simulation::Options&)>
      sensitivity;
  std::function<void(long runs)> progress;  ///< told the number of overruns so far, from any thread
};

/// A trial: a bed, and all speeds multiplied (1 except when speed is what is looked for).
struct Trial {
  Profile profile;
  double speed_factor = 1.0;
};

/// Windows of the profile: every 6 m for the nose gear's drag, one per piece for other loads.
Watch watch_of(const Profile&);

class Evaluator {
 public:
  Evaluator(const Problem&, study::Store&);
  /// Figures of the given cases (indices into the fleet) for each trial: [trial][case].
  std::vector<std::vector<Figures>> run(const std::vector<Trial>&, const std::vector<std::size_t>& cases);
  /// Figures of every case of the fleet in a given bed continued beyond its end, without windows.
  std::vector<Figures> in_bed(const bed::Bed&, double speed_factor);
  /// Numbers worked out by `work` unless they are remembered under `key`.
  std::vector<double> remembered(const std::string& key, const std::function<std::vector<double>()>& work);
  const Problem& problem() const { return problem_; }
  long runs() const { return runs_; }        ///< overruns simulated, those remembered not counted
  long gave_up() const { return gave_up_; }  ///< overruns the solver could not finish: judged as worst
  double reach() const;                      ///< m, length of trial beds: long enough for any stop that matters

 private:
  struct Run {
    std::size_t fleet_case;
    double speed_factor;
  };
  Figures one(const Trial&, std::size_t fleet_case);
  Figures solve(const Run&, const bed::Bed&, double bed_length, const Watch&, const simulation::Options&);

  const Problem& problem_;
  study::Store& store_;
  std::atomic<long> runs_{0}, gave_up_{0};
};

}  // namespace apc::design
