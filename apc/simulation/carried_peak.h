/// The largest value of a signal F(t), and how it moves with a parameter p:
///
///   Ḟ changes its sign smoothly:   dF*/dp = dF/dp at the peak's time, which needs no time term
///   at a corner of the signal:     dF*/dp = D⁻ + Ḟ⁻ t′ = D⁺ + Ḟ⁺ t′, for the peak stays at the corner, whose time
///   moves
///                                  by t′ = dt/dp; D is dF/dp at a fixed time
/// Either way t′ = (D⁻ − D⁺)/(Ḟ⁺ − Ḟ⁻), so that dF*/dp = (D⁻ Ḟ⁺ − D⁺ Ḟ⁻)/(Ḟ⁺ − Ḟ⁻) from both sides of the peak alone;
/// where the corner is known (a kink of the ground), D + Ḟ t′ is differenced at states that move with it.
#pragma once

namespace apc::simulation {

class CarriedPeak {
 public:
  /// The signal at an instant, or on one side of it.
  struct Sample {
    double value, rate, slope;  ///< F, Ḟ, D
  };
  /// A value anywhere.
  void offer(double value, double slope);
  /// The peak between two samples near it, F rising at one and falling at the other.
  void offer_between(double value, const Sample& before, const Sample& after);
  /// One side of a known corner: F, Ḟ, and dF/dp at states that move with it.
  struct Side {
    double value, rate, moving;
  };
  void offer_corner(const Side& before, const Side& after);
  /// Instants of a signal without corners: a maximum between three is the vertex of their parabola.
  void see(double time, double value, double slope);

  double value() const { return value_; }
  double slope() const { return slope_; }

 private:
  struct Instant {
    double time, value, slope;
  };
  Instant last_{}, before_{};
  int count_ = 0;
  double value_ = -1e300, slope_ = 0.0;
};

}  // namespace apc::simulation
