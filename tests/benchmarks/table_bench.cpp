/// Load table: look-up inside and outside the fitted range, with slopes, and the fit itself.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "apc/base/file.h"
#include "loadtables/fit.h"
#include "loadtables/load_table_data.h"

namespace {

using namespace apc;
using namespace apc::loadtables;

const LoadTable& table() {
  static const LoadTable shipped_table = load_table(shipped("loadtables/data/H44.5x16.5-21_foam_50psi.h5"));
  return shipped_table;
}

/// Contacts along an overrun: slowing down, the ramp, the plateau, a tire that bounces a little.
std::vector<TireContact> overrun(double share_outside) {
  std::vector<TireContact> path;
  for (int i = 0; i < 1024; ++i) {
    const double depth = std::min(0.45, 0.002 * i), ratio = 0.7 + 0.1 * ((i * 37) % 64) / 64.0;
    const bool outside = (i * 53) % 1024 < 1024 * share_outside;
    path.push_back({36.0 - 0.03 * i, depth, table().maximum_penetration(depth) * (outside ? 1.4 : ratio)});
  }
  return path;
}

void look_up(benchmark::State& state, double share_outside) {
  const auto path = overrun(share_outside);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(table().load(path[i++ & 1023]));
}

void TableLookUp(benchmark::State& state) { look_up(state, 0.0); }
void TableLookUpOutside(benchmark::State& state) { look_up(state, 1.0); }

void TableLookUpWithSlopes(benchmark::State& state) {
  const auto path = overrun(0.0);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(table().load_with_slopes(path[i++ & 1023]));
}

void TableFit(benchmark::State& state) {
  const auto& samples = table().data().samples;
  for (auto _ : state) benchmark::DoNotOptimize(fit(samples, table().tire(), table().provenance()));
  state.counters["samples"] = static_cast<double>(samples.samples.size());
}

void TableLoadFromFile(benchmark::State& state) {
  const auto file = shipped("loadtables/data/H44.5x16.5-21_foam_50psi.h5");
  for (auto _ : state) benchmark::DoNotOptimize(load_table(file));
}

BENCHMARK(TableLookUp);
BENCHMARK(TableLookUpOutside);
BENCHMARK(TableLookUpWithSlopes);
BENCHMARK(TableFit)->Unit(benchmark::kMillisecond);
BENCHMARK(TableLoadFromFile)->Unit(benchmark::kMillisecond);

}  // namespace
