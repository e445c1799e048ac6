/// What carried_peak.h watches along a run: the extremes of result.h.
#pragma once

#include <array>
#include <functional>

#include "apc/simulation/carried_peak.h"
#include "apc/simulation/neighbours.h"

namespace apc::simulation {

class CarriedExtremes {
 public:
  /// `interval` between instants, s; a tenth of a second is a multiple of it.
  CarriedExtremes(Neighbours&, double interval);

  /// State and its sensitivity at a time within a step of the solver.
  struct State {
    const std::vector<double>&y, &s;
  };
  using Load = std::function<State(double t)>;
  /// Part of a step in which the ground has no corner. A peak in it is looked for where the signal's rate changes sign.
  enum class PieceEnd { smooth, corner };
  void see_piece(double from, double until, const Load&, PieceEnd);
  /// An instant of the grid, for the mean over 0.1 s.
  void see_instant(double t, const State&);
  using Side = std::vector<CarriedPeak::Side>;
  /// One side of the corner at which the state is `y`, moving with it by `moving`; `near` is the state `offset` s
  /// after.
  Side side(double t, const std::vector<double>& y, const std::vector<double>& moving, const std::vector<double>& near,
            double offset);
  void see_corner(const Side& before, const Side& after);
  /// Peaks and margins of the run and of `gears`, which are there.
  void fill(Sensitivity&) const;

 private:
  /// Signals of the run, of each group (one strut), and of its most loaded tire.
  enum OfRun { deceleration, pitch_up, pitch_down, of_run };
  enum OfGroup { drag, vertical, tire, rut, penetration, stroke, of_group };
  std::vector<double> signals(const Variant&, double t, const double* y);
  /// All signals at `t`; the rate is that on the side of `offset`.
  struct Samples {
    double time;
    std::vector<CarriedPeak::Sample> each;
  };
  Samples sample(double t, double offset, const Load&);
  enum class Within { one_step, steps };
  void look_between(const Samples& a, const Samples& b, const Load&, Within);
  const CarriedPeak& peak(std::size_t group, OfGroup what) const { return peaks_[of_run + of_group * group + what]; }

  Neighbours& neighbours_;
  double interval_;
  std::vector<double> rate_;
  std::vector<CarriedPeak> peaks_;
  Samples last_{};                             ///< none right after a corner
  CarriedPeak mean_;                           ///< of the deceleration over 0.1 s
  std::vector<std::array<double, 2>> speeds_;  ///< of the cg at all instants, and its slope
  std::size_t mean_over_;                      ///< instants
};

}  // namespace apc::simulation
