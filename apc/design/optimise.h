/// Independent ways to the optimum of a programme, from NLopt (Johnson, 2.7.1): sequential quadratic programming
/// (SLSQP, Kraft 1994), moving asymptotes (MMA in its globally convergent form, Svanberg 2002), and linear
/// approximation without gradients (COBYLA, Powell 1994). That two of them end at the same bed, from different starts,
/// is what the certificate of a design rests on.
#pragma once

#include "apc/design/program.h"

namespace apc::design {

enum class Method { slsqp, mma, cobyla };
const char* text(Method);

struct Optimum {
  Method method = Method::slsqp;
  Eigen::VectorXd z;
  double objective = 0.0;
  double overstep = 0.0;  ///< largest g; at or below `tolerance` when a feasible point was met
  int evaluations = 0;    ///< points asked for, those for differences not counted
  std::string ended;      ///< why the method stopped
  bool feasible = false;
};

struct OptimiserOptions {
  int evaluations = 400;
  double tolerance = 2e-4;  ///< oversteps of constraints up to this count as met
  double step = 2e-4;       ///< of differences, scaled: 0.1 mm of a depth range of 0.5 m
  double start_step = 0.1;  ///< first simplex of COBYLA, scaled
  double ftol = 1e-6, xtol = 1e-5;
};

/// The best point met that keeps the constraints; without any, the one that oversteps least.
Optimum optimise(const Program&, Method, const Eigen::VectorXd& start, const OptimiserOptions& = {});

}  // namespace apc::design
