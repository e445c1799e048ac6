/// Stops per second, fast path against stock CVODE in the same run: 70 kt, braking 0.25, 0.457 m of foam, rtol 1e-6, no
/// history. Counters: solver steps, refused steps and right-hand sides per stop, the distance to the exact answer in
/// millimetres, and for the fast path how many times faster it is than CVODE was a moment before.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <map>

#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"
#include "tests/support/simulation_models.h"

namespace {

using namespace apc;
using namespace apc::simulation;

Model model_of(const std::string& aircraft) {
  return apc::testing::foam_model(aircraft, apc::testing::foam_bed(0.4572, 15.24, 600.0));
}

Overrun braked_from_70_kt() {
  Overrun overrun;
  overrun.entry_speed = 70 * units::kt;
  overrun.braking = 0.25;
  return overrun;
}

Options without_history(Method method, double rtol) {
  Options options;
  options.method = method;
  options.rtol = rtol;
  options.sampling = 0.0;
  return options;
}

double exact_distance(const std::string& aircraft) {
  static std::map<std::string, double> known;
  if (!known.contains(aircraft))
    known[aircraft] =
        simulate(model_of(aircraft), braked_from_70_kt(), without_history(Method::reference, 1e-10)).stop_distance;
  return known.at(aircraft);
}

void stop(benchmark::State& state, const char* aircraft, Method method) {
  const auto model = model_of(aircraft);
  const auto overrun = braked_from_70_kt();
  const auto options = without_history(method, 1e-6);
  static std::map<std::string, double> cvode_seconds;  // CVODE runs first
  Result result;
  double seconds = 0.0;
  for (auto _ : state) {
    const auto began = std::chrono::steady_clock::now();
    result = simulate(model, overrun, options);
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    const double distance = result.stop_distance;  // a copy: this library's DoNotOptimize may spoil what it is given
    benchmark::DoNotOptimize(distance);
  }
  seconds /= static_cast<double>(state.iterations());
  if (method == Method::reference) cvode_seconds[aircraft] = seconds;
  state.counters["stops/s"] = benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["steps"] = static_cast<double>(result.solver.steps);
  state.counters["refused"] = static_cast<double>(result.solver.error_test_failures);
  state.counters["rhs"] = static_cast<double>(result.solver.rhs_calls);
  state.counters["error_mm"] = 1e3 * std::abs(result.stop_distance - exact_distance(aircraft));
  if (method == Method::fast && cvode_seconds.contains(aircraft))
    state.counters["vs_cvode"] = cvode_seconds[aircraft] / seconds;
}

/// The pieces a step is made of, in the bed.
void equations(benchmark::State& state, const char* aircraft, bool with_slopes) {
  const auto model = model_of(aircraft);
  const auto overrun = braked_from_70_kt();
  const auto plant = make_plant(model, overrun);
  const auto around = surroundings_at_entry(plant);
  auto y = trim(plant, 25.0).state;
  y[0] += 60.0;
  y[1] -= 0.25;
  std::vector<double> rate(y.size()), matrix(y.size() * y.size());
  for (auto _ : state) {
    if (with_slopes) {
      jacobian(plant, around, 0.0, y.data(), rate.data(), matrix.data());
    } else {
      derivatives(plant, around, 0.0, y.data(), rate.data());
    }
    benchmark::DoNotOptimize(rate.data());
    benchmark::ClobberMemory();
  }
}

BENCHMARK_CAPTURE(stop, CRJ_200_cvode, "CRJ-200", Method::reference)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, CRJ_200_fast, "CRJ-200", Method::fast)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B737_800_cvode, "B737-800", Method::reference)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B737_800_fast, "B737-800", Method::fast)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B747_400_cvode, "B747-400", Method::reference)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stop, B747_400_fast, "B747-400", Method::fast)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(equations, B737_800_rhs, "B737-800", false);
BENCHMARK_CAPTURE(equations, B737_800_jacobian, "B737-800", true);
BENCHMARK_CAPTURE(equations, B747_400_rhs, "B747-400", false);
BENCHMARK_CAPTURE(equations, B747_400_jacobian, "B747-400", true);

}  // namespace
