/// Stops per second, fast path against stock CVODE in the same run: 70 kt, braking 0.25, 0.457 m of foam, rtol 1e-6, no
/// history. Counters: solver steps, refused steps and right-hand sides per stop, the distance to the exact answer in
/// millimetres, and for the fast path how many times faster it is than CVODE was a moment before, by CPU time.
/// `stops_in_lanes`: 64 stops at once on one thread, all alike or each of its own speed (55 to 70 kt) and mass (85 to
/// 100 %), so that no two lanes stay in step.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <map>

#include "apc/base/require.h"
#include "apc/simulation/overrun_run.h"
#include "apc/simulation/simulate_each.h"
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

/// s, of this thread.
double processor_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::map<std::string, double> cvode_seconds;  ///< per stop; CVODE runs first

void stop(benchmark::State& state, const char* aircraft, Method method) {
  const auto model = model_of(aircraft);
  const auto overrun = braked_from_70_kt();
  const auto options = without_history(method, 1e-6);
  Result result;
  double seconds = 0.0;
  for (auto _ : state) {
    const double began = processor_time();
    result = simulate(model, overrun, options);
    seconds += processor_time() - began;
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

enum class Crowd { alike, mixed };

void stops_in_lanes(benchmark::State& state, const char* aircraft, Crowd crowd) {
  constexpr int count = 64;
  const auto model = model_of(aircraft);
  const auto options = without_history(Method::fast, 1e-6);
  std::vector<Overrun> overruns(count, braked_from_70_kt());
  std::vector<Errand> errands;
  for (int i = 0; i < count; ++i) {
    auto& overrun = overruns[static_cast<std::size_t>(i)];
    if (crowd == Crowd::mixed) {
      overrun.entry_speed = (55.0 + 15.0 * (i * 29 % count) / (count - 1.0)) * units::kt;
      overrun.mass = (0.85 + 0.15 * (i * 37 % count) / (count - 1.0)) * model.aircraft.mass;
    }
    errands.push_back({&model, &overrun, &options});
  }
  std::vector<Outturn> outturns;
  double seconds = 0.0;
  for (auto _ : state) {
    const double began = processor_time();
    outturns = simulate_each(errands);
    seconds += processor_time() - began;
  }
  seconds /= static_cast<double>(state.iterations()) * count;
  double steps = 0.0, refused = 0.0, rhs = 0.0;
  for (const auto& each : outturns) {
    expect(!each.failure, "a stop in lanes failed");
    steps += static_cast<double>(each.result.solver.steps) / count;
    refused += static_cast<double>(each.result.solver.error_test_failures) / count;
    rhs += static_cast<double>(each.result.solver.rhs_calls) / count;
  }
  state.counters["stops/s"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["steps"] = steps;
  state.counters["refused"] = refused;
  state.counters["rhs"] = rhs;
  if (crowd == Crowd::alike) {
    state.counters["error_mm"] = 1e3 * std::abs(outturns[0].result.stop_distance - exact_distance(aircraft));
    if (cvode_seconds.contains(aircraft)) state.counters["vs_cvode"] = cvode_seconds[aircraft] / seconds;
  }
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
BENCHMARK_CAPTURE(stops_in_lanes, CRJ_200, "CRJ-200", Crowd::alike)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stops_in_lanes, CRJ_200_mixed, "CRJ-200", Crowd::mixed)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stops_in_lanes, B737_800, "B737-800", Crowd::alike)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stops_in_lanes, B737_800_mixed, "B737-800", Crowd::mixed)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stops_in_lanes, B747_400, "B747-400", Crowd::alike)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stops_in_lanes, B747_400_mixed, "B747-400", Crowd::mixed)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(equations, B737_800_rhs, "B737-800", false);
BENCHMARK_CAPTURE(equations, B737_800_jacobian, "B737-800", true);
BENCHMARK_CAPTURE(equations, B747_400_rhs, "B747-400", false);
BENCHMARK_CAPTURE(equations, B747_400_jacobian, "B747-400", true);

}  // namespace
