#include "apc/design/optimise.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <stdexcept>

namespace apc::design {

const char* text(Method method) { return method == Method::slsqp ? "SLSQP" : method == Method::mma ? "MMA" : "COBYLA"; }

namespace {

/// What NLopt's callbacks share: the last point's values and gradients, the best point so far, and the exception that
/// ended the search, if any.
struct Search {
  const Program& program;
  const OptimiserOptions& options;
  Optimum best;
  Eigen::VectorXd z, values;
  Eigen::MatrixXd gradients;
  bool has_gradients = false;
  std::exception_ptr failure;

  void look_at(const double* x, unsigned n) {
    const Eigen::VectorXd point = Eigen::Map<const Eigen::VectorXd>(x, n);
    if (z.size() == point.size() && z == point) return;
    values = program.at(point), z = point, has_gradients = false;
    ++best.evaluations;
    const double overstep = values.size() > 1 ? values.tail(values.size() - 1).maxCoeff() : 0.0;
    const bool feasible = overstep <= options.tolerance;
    const bool better = feasible ? !best.feasible || values[0] < best.objective
                                 : !best.feasible && (best.z.size() == 0 || overstep < best.overstep);
    if (!better) return;
    best.z = z, best.objective = values[0], best.overstep = overstep, best.feasible = feasible;
  }
  void look_around() {
    if (!has_gradients) gradients = jacobian(program, z, options.step, Differences::forward);
    has_gradients = true;
  }
  /// C code lies between the callbacks and the caller: exceptions wait here.
  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
      throw nlopt::forced_stop();
    }
  }
};

double objective(unsigned n, const double* x, double* gradient, void* data) {
  auto& search = *static_cast<Search*>(data);
  search.guarded([&] {
    search.look_at(x, n);
    if (!gradient) return;
    search.look_around();
    Eigen::Map<Eigen::VectorXd>(gradient, n) = search.gradients.row(0);
  });
  return search.values[0];
}

void constraints(unsigned m, double* result, unsigned n, const double* x, double* gradient, void* data) {
  auto& search = *static_cast<Search*>(data);
  search.guarded([&] {
    search.look_at(x, n);
    Eigen::Map<Eigen::VectorXd>(result, m) = search.values.tail(m);
    if (!gradient) return;
    search.look_around();
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor>(gradient, m, n) = search.gradients.bottomRows(m);
  });
}

std::string ending(nlopt::result code) {
  switch (code) {
    case nlopt::FTOL_REACHED:
      return "objective settled";
    case nlopt::XTOL_REACHED:
      return "design settled";
    case nlopt::MAXEVAL_REACHED:
      return "evaluations used up";
    case nlopt::ROUNDOFF_LIMITED:
      return "limited by round-off";
    default:
      return "converged";
  }
}

std::vector<double> list(const Eigen::VectorXd& values) { return {values.data(), values.data() + values.size()}; }

}  // namespace

Optimum optimise(const Program& program, Method method, const Eigen::VectorXd& start, const OptimiserOptions& options) {
  Search search{program, options, {}, {}, {}, {}, false, {}};
  search.best.method = method;
  const auto n = static_cast<unsigned>(start.size());
  const auto algorithm = method == Method::slsqp ? nlopt::LD_SLSQP
                         : method == Method::mma ? nlopt::LD_MMA
                                                 : nlopt::LN_COBYLA;
  nlopt::opt solver(algorithm, n);
  solver.set_lower_bounds(list(program.low));
  solver.set_upper_bounds(list(program.high));
  solver.set_min_objective(objective, &search);
  const std::vector<double> tolerances(program.constraints.size(), 0.1 * options.tolerance);
  if (!tolerances.empty()) solver.add_inequality_mconstraint(constraints, &search, tolerances);
  solver.set_maxeval(options.evaluations);
  solver.set_ftol_rel(options.ftol);
  solver.set_xtol_rel(options.xtol);
  if (method == Method::cobyla) solver.set_initial_step(options.start_step);
  auto z = list(start.cwiseMax(program.low).cwiseMin(program.high));
  double value = 0.0;
  try {
    search.best.ended = ending(solver.optimize(z, value));
  } catch (const nlopt::roundoff_limited&) {
    search.best.ended = ending(nlopt::ROUNDOFF_LIMITED);
  } catch (const nlopt::forced_stop&) {
    search.best.ended = "stopped";
  } catch (const std::runtime_error& error) {
    search.best.ended = error.what();  // the best point met still counts
  }
  if (search.failure) std::rethrow_exception(search.failure);
  return search.best;
}

}  // namespace apc::design
