/// Stops per second, fast path against stock CVODE in the same run. Counters: solver steps and right-hand sides per
/// stop, and the distance between the two answers in millimetres.
#include <benchmark/benchmark.h>

#include <cmath>

#include "tests/support/simulation_models.h"

namespace {

using namespace apc;
using namespace apc::simulation;

void stop(benchmark::State& state, const char* aircraft, Method method, double rtol) {
  const auto model = apc::testing::foam_model(aircraft, apc::testing::foam_bed(0.4572, 15.24, 600.0));
  Overrun overrun;
  overrun.entry_speed = 70 * units::kt;
  overrun.braking = 0.25;
  Options options;
  options.method = method;
  options.rtol = rtol;
  options.sampling = 0.0;
  Result result;
  for (auto _ : state) {
    result = simulate(model, overrun, options);
    benchmark::DoNotOptimize(result.stop_distance);
  }
  Options exact;
  exact.rtol = 1e-10;
  exact.sampling = 0.0;
  state.counters["stops/s"] = benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["steps"] = static_cast<double>(result.solver.steps);
  state.counters["rhs"] = static_cast<double>(result.solver.rhs_calls);
  state.counters["error_mm"] = 1e3 * std::abs(result.stop_distance - simulate(model, overrun, exact).stop_distance);
}

BENCHMARK_CAPTURE(stop, CRJ_200_fast, "CRJ-200", Method::fast, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, CRJ_200_cvode, "CRJ-200", Method::reference, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B737_800_fast, "B737-800", Method::fast, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B737_800_cvode, "B737-800", Method::reference, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B747_400_fast, "B747-400", Method::fast, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B747_400_cvode, "B747-400", Method::reference, 1e-6)->Unit(benchmark::kMillisecond);

}  // namespace
