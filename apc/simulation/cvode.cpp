#include "apc/simulation/cvode.h"

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <sundials/sundials_context.hpp>
#include <utility>

#include "apc/base/require.h"

namespace apc::simulation {

struct Cvode::Engine {
  OdeProblem problem;
  OdeTolerances tolerances;
  sundials::Context context;
  void* memory = nullptr;
  N_Vector y = nullptr, absolute = nullptr, q = nullptr;
  N_Vector* s = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver solver = nullptr;
  std::vector<double> rows;  ///< the caller's row-major Jacobian
  std::exception_ptr failure;
  std::string complaint;    ///< CVODES' own last message
  SolverStatistics before;  ///< counts of earlier starts
  bool started = false;

  ~Engine() {
    if (s) N_VDestroyVectorArray(s, problem.parameters);
    for (N_Vector v : {y, absolute, q})
      if (v) N_VDestroy(v);
    if (memory) CVodeFree(&memory);
    if (solver) SUNLinSolFree(solver);
    if (matrix) SUNMatDestroy(matrix);
  }

  /// Runs a callback; exceptions are kept, values that are not numbers ask CVODES for a smaller step.
  template <class Work>
  int guarded(const double* result, std::size_t count, const Work& work) {
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
      return -1;
    }
    for (std::size_t i = 0; i < count; ++i)
      if (!std::isfinite(result[i])) return 1;
    return 0;
  }

  static int rate(double t, N_Vector at, N_Vector result, void* self) {
    auto& e = *static_cast<Engine*>(self);
    double* out = N_VGetArrayPointer(result);
    return e.guarded(out, static_cast<std::size_t>(e.problem.states),
                     [&] { e.problem.rate(t, N_VGetArrayPointer(at), out); });
  }
  static int jacobian(double t, N_Vector at, N_Vector, SUNMatrix result, void* self, N_Vector, N_Vector, N_Vector) {
    auto& e = *static_cast<Engine*>(self);
    const int status =
        e.guarded(e.rows.data(), e.rows.size(), [&] { e.problem.jacobian(t, N_VGetArrayPointer(at), e.rows.data()); });
    if (status != 0) return status;
    const int n = e.problem.states;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) SM_ELEMENT_D(result, i, j) = e.rows[static_cast<std::size_t>(i * n + j)];
    return 0;
  }
  static int integrand(double t, N_Vector at, N_Vector result, void* self) {
    auto& e = *static_cast<Engine*>(self);
    double* out = N_VGetArrayPointer(result);
    return e.guarded(out, static_cast<std::size_t>(e.problem.quadratures),
                     [&] { e.problem.integrand(t, N_VGetArrayPointer(at), out); });
  }
  static int sensitivity(int, double t, N_Vector at, N_Vector, int which, N_Vector s, N_Vector result, void* self,
                         N_Vector, N_Vector) {
    auto& e = *static_cast<Engine*>(self);
    double* out = N_VGetArrayPointer(result);
    return e.guarded(out, static_cast<std::size_t>(e.problem.states),
                     [&] { e.problem.sensitivity(t, N_VGetArrayPointer(at), which, N_VGetArrayPointer(s), out); });
  }
  static void message(int code, const char*, const char*, char* text, void* self) {
    if (code < 0) static_cast<Engine*>(self)->complaint = text;
  }

  void check(int status, const char* what) const {
    if (status < 0) throw SolveError(concat("CVODES could not ", what, " (code ", status, ") ", complaint));
  }

  void create(double t) {
    memory = CVodeCreate(CV_BDF, context);
    if (!memory) throw SolveError("CVODES could not be created");
    check(CVodeSetErrHandlerFn(memory, message, this), "take its message handler");
    check(CVodeInit(memory, rate, t, y), "start");
    check(CVodeSetUserData(memory, this), "start");
    check(CVodeSVtolerances(memory, tolerances.relative, absolute), "take its tolerances");
    matrix = SUNDenseMatrix(problem.states, problem.states, context);
    solver = SUNLinSol_Dense(y, matrix, context);
    check(CVodeSetLinearSolver(memory, solver, matrix), "take its linear solver");
    check(CVodeSetJacFn(memory, jacobian), "take its Jacobian");
    check(CVodeSetMaxNumSteps(memory, 200000), "start");
    if (tolerances.longest_step > 0.0) check(CVodeSetMaxStep(memory, tolerances.longest_step), "start");
    if (q) {
      check(CVodeQuadInit(memory, integrand, q), "start its quadratures");
      check(CVodeSetQuadErrCon(memory, SUNFALSE), "start its quadratures");
    }
    if (s) {
      check(CVodeSensInit1(memory, problem.parameters, CV_STAGGERED1, sensitivity, s), "start its sensitivities");
      auto scale = problem.parameter_scales;
      scale.resize(static_cast<std::size_t>(problem.parameters), 1.0);
      check(CVodeSetSensParams(memory, nullptr, scale.data(), nullptr), "start its sensitivities");
      check(CVodeSensEEtolerances(memory), "take its sensitivity tolerances");
      check(CVodeSetSensErrCon(memory, SUNTRUE), "start its sensitivities");
    }
  }

  SolverStatistics current() const {
    SolverStatistics counts;
    if (!memory) return counts;
    long extra = 0;
    CVodeGetNumSteps(memory, &counts.steps);
    CVodeGetNumRhsEvals(memory, &counts.rhs_calls);
    CVodeGetNumLinRhsEvals(memory, &extra);
    CVodeGetNumJacEvals(memory, &counts.jacobians);
    CVodeGetNumErrTestFails(memory, &counts.error_test_failures);
    CVodeGetNumNonlinSolvConvFails(memory, &counts.newton_failures);
    counts.rhs_calls += extra;
    return counts;
  }
};

namespace {

void add(SolverStatistics& sum, const SolverStatistics& more) {
  sum.steps += more.steps;
  sum.rhs_calls += more.rhs_calls;
  sum.jacobians += more.jacobians;
  sum.error_test_failures += more.error_test_failures;
  sum.newton_failures += more.newton_failures;
}

}  // namespace

Cvode::Cvode(OdeProblem problem, OdeTolerances tolerances) : engine_(std::make_unique<Engine>()) {
  auto& e = *engine_;
  e.problem = std::move(problem);
  e.tolerances = std::move(tolerances);
  const auto n = static_cast<std::size_t>(e.problem.states);
  expect(e.tolerances.absolute.size() == n, "one absolute tolerance per state");
  e.rows.resize(n * n);
  e.y = N_VNew_Serial(e.problem.states, e.context);
  e.absolute = N_VNew_Serial(e.problem.states, e.context);
  std::copy(e.tolerances.absolute.begin(), e.tolerances.absolute.end(), N_VGetArrayPointer(e.absolute));
  if (e.problem.quadratures > 0) e.q = N_VNew_Serial(e.problem.quadratures, e.context);
  if (e.problem.parameters > 0) e.s = N_VCloneVectorArray(e.problem.parameters, e.y);
}

Cvode::~Cvode() = default;

void Cvode::start(double t, const std::vector<double>& y, const std::vector<double>& integrals,
                  const std::vector<double>& s) {
  auto& e = *engine_;
  const auto n = static_cast<std::size_t>(e.problem.states);
  std::copy(y.begin(), y.end(), N_VGetArrayPointer(e.y));
  if (e.q) {
    N_VConst(0.0, e.q);
    std::copy(integrals.begin(), integrals.end(), N_VGetArrayPointer(e.q));
  }
  for (int p = 0; p < e.problem.parameters; ++p) {
    N_VConst(0.0, e.s[p]);
    if (!s.empty())
      std::copy_n(s.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(p) * n), n,
                  N_VGetArrayPointer(e.s[p]));
  }
  if (!e.memory) {
    e.create(t);
  } else {
    add(e.before, e.current());
    e.check(CVodeReInit(e.memory, t, e.y), "restart");
    if (e.q) e.check(CVodeQuadReInit(e.memory, e.q), "restart its quadratures");
    if (e.s) e.check(CVodeSensReInit(e.memory, CV_STAGGERED1, e.s), "restart its sensitivities");
  }
  previous_ = time_ = t;
}

void Cvode::stop_at(double t) {
  constexpr double far = 1e6;  // s; version 6.4 cannot take a bound away
  engine_->check(CVodeSetStopTime(engine_->memory, std::min(t, time_ + far)), "take a stop time");
}

double Cvode::step() {
  auto& e = *engine_;
  const double before = time_;
  double reached = time_;
  const int status = CVode(e.memory, time_ + 1.0, e.y, &reached, CV_ONE_STEP);
  if (e.failure) std::rethrow_exception(std::exchange(e.failure, nullptr));
  if (status < 0) {
    const double* y = N_VGetArrayPointer(e.y);
    std::string state;
    if (e.problem.describe)
      state = e.problem.describe(y);
    else
      for (int i = 0; i < e.problem.states; ++i) state += concat(i ? ", " : "state ", y[i]);
    throw SolveError(
        concat("CVODES gave up at t = ", time_, " s (", CVodeGetReturnFlagName(status), "; ", e.complaint, "): ", state,
               ". Try a looser tolerance, and look for damping, friction or stops out of proportion"),
        time_);
  }
  if (!(reached - before > 1e-15 * (1.0 + std::abs(before))))
    throw SolveError(concat("CVODES stands still at t = ", time_, " s: its steps no longer move the time",
                            e.problem.describe ? ": " + e.problem.describe(N_VGetArrayPointer(e.y)) : std::string(),
                            ". Try a looser tolerance, and look for laws that end or jump there"),
                     time_);
  previous_ = before;
  time_ = reached;
  return time_;
}

void Cvode::state(double t, double* y) const {
  const N_Vector view = N_VMake_Serial(engine_->problem.states, y, engine_->context);
  const int status = CVodeGetDky(engine_->memory, t, 0, view);
  N_VDestroy(view);
  engine_->check(status, "interpolate");
}

void Cvode::integrals(double t, double* q) const {
  const N_Vector view = N_VMake_Serial(engine_->problem.quadratures, q, engine_->context);
  const int status = CVodeGetQuadDky(engine_->memory, t, 0, view);
  N_VDestroy(view);
  engine_->check(status, "interpolate its quadratures");
}

void Cvode::sensitivities(double t, double* s) const {
  for (int p = 0; p < engine_->problem.parameters; ++p) {
    const N_Vector view = N_VMake_Serial(engine_->problem.states, s + p * engine_->problem.states, engine_->context);
    const int status = CVodeGetSensDky1(engine_->memory, t, 0, p, view);
    N_VDestroy(view);
    engine_->check(status, "interpolate its sensitivities");
  }
}

SolverStatistics Cvode::statistics() const {
  auto counts = engine_->current();
  add(counts, engine_->before);
  counts.method = "CVODE BDF";
  counts.rtol = engine_->tolerances.relative;
  return counts;
}

}  // namespace apc::simulation
