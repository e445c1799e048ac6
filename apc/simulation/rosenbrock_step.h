/// The arithmetic of one attempted RODAS4 step: linear algebra and sums over stages, in vectors of fixed width, once
/// per instruction set with the same order of operations in each.
///
/// (E I − J) k = r with E = 1/(hγ) and x′ = v:  k_x = (r_x + k_v)/E,  k_ω = s (r_ω + D r_x/E) + G k_v per spin, and
///     k_v = M⁻¹ r_v + K r_x + L r_ω,   M = E − B − A/E − C G
/// with A, B, C the derivatives of the accelerations by positions, rates and spins, D of the spin rates by positions,
/// s = 1/(E − ∂ω′/∂ω), G = s (∂ω′/∂v + D/E). M⁻¹, K and L are formed once per attempt: every stage is then a few
/// products of columns, without the long dependent chains of triangular solves.
#pragma once

#include "apc/simulation/equations.h"

namespace apc::simulation {

using StateVector = std::array<double, 48>;  ///< every state, or three columns of up to 16

struct StepWork {
  int degrees = 0, spins = 0, states = 0;
  alignas(64) StateVector y{}, next{}, f0{}, dfdt{}, f{}, at{};
  alignas(64) std::array<StateVector, 6> u{};  ///< stages, as columns of positions, rates and spins
  StateVector weight{}, weight_by_size{};      ///< what one unit of relative tolerance means: constant + slope × |y|
  std::array<double, most_states * most_states> jacobian{};
  // Columns of the eliminated system.
  double e = 0.0, per_e = 0.0;
  alignas(64) std::array<double, most_degrees * 16> inverse{}, by_position{}, spin_by_rate{}, spin_by_position{};
  alignas(64) std::array<double, most_rows * 16> by_spin{};
  alignas(64) std::array<double, 16> spin_inverse{};
};

/// Stage `i` = 0 … 5: where the right-hand side is wanted (`work.at`; `work.next` from stage 4 on), and, once
/// `work.f` holds it, the stage's solution `work.u[i]`. Stage 0 takes `work.f0`.
struct StepKernel {
  bool (*eliminate)(StepWork&, double h);  ///< false: singular
  void (*place)(StepWork&, int stage);
  void (*solve)(StepWork&, int stage, double h, double time_share);  ///< time_share: h d_i when dfdt counts, else 0
  /// Coefficients of dense output.
  void (*dense)(const StepWork&, double* second, double* third);
  /// Error of `next` in the weights' units.
  double (*norm)(const StepWork&);
};
/// For the number of states at hand.
const StepKernel& step_kernel(const StepWork&);

/// The method's coefficients, in the form of Hairer and Wanner's code.
inline constexpr double stage_gamma = 0.25;
inline constexpr double stage_a[4][4] = {
    {1.544},
    {0.9466785280815826, 0.2557011698983284},
    {3.314825187068521, 2.896124015972201, 0.9986419139977817},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950}};
inline constexpr double stage_c[5][5] = {
    {-5.6688},
    {-2.430093356833875, -0.2063599157091915},
    {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
    {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
    {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}};
inline constexpr double dense_second[5] = {10.12623508344586, -7.487995877610167, -34.80091861555747,
                                           -7.992771707568823, 1.025137723295662};
inline constexpr double dense_third[5] = {-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386,
                                          -6.594389125716872};
inline constexpr double stage_time[6] = {0.0, 0.386, 0.21, 0.63, 1.0, 1.0};
inline constexpr double stage_time_share[6] = {0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0};

}  // namespace apc::simulation
