/// Text of `apc sph bench`.
#include <fmt/format.h>

#include "apc/cli/sph_studies.h"
#include "apc/cli/text_table.h"

namespace apc::cli {
namespace {

std::string millions(double value) { return fmt::format("{:.2f}", value / 1e6); }
std::string giga(double value) { return fmt::format("{:.1f}", value / 1e9); }
std::string percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

}  // namespace

std::string bench_text(const sph::Throughput& t) {
  const auto& first = t.rows.front();
  const auto& all = t.rows.back();
  const bool several = t.rows.size() > 1;
  const auto with_columns = [&](TextTable table, const std::string& last) {
    for (const auto& row : t.rows)
      table.headings.push_back(fmt::format("{} {}", row.threads, row.threads == 1 ? "thread" : "threads"));
    if (several) table.headings.push_back(last);
    return table;
  };
  const auto add = [&](TextTable& table, std::vector<std::string> row, auto value, auto written, bool ratio) {
    for (const auto& each : t.rows) row.push_back(written(value(each)));
    if (several) row.push_back(ratio ? fmt::format("{:.2f}", value(all) / value(first)) : "");
    table.rows.push_back(row);
  };
  using Row = sph::ThreadRates;

  TextTable rates = with_columns({{"million particle-steps/s", "particles"}, {}}, "ratio");
  const std::string whole = fmt::format("{:.0f}", t.particles), window = fmt::format("{:.0f}", t.window_particles);
  add(
      rates, {"foam at rest", whole}, [](const Row& r) { return r.rest; }, millions, true);
  add(
      rates, {"rolling, whole bed awake", whole}, [](const Row& r) { return r.whole; }, millions, true);
  add(
      rates, {"its fastest 200 steps", whole}, [](const Row& r) { return r.whole_fastest; }, millions, true);
  add(
      rates, {"rolling in its window", window}, [](const Row& r) { return r.window; }, millions, true);
  add(
      rates, {"nominal: the window's run, whole bed counted", whole}, [](const Row& r) { return r.nominal; }, millions,
      true);
  std::string out = aligned(rates);
  out += fmt::format("Run in the window: {:.0f} steps", t.window_steps);
  for (const auto& row : t.rows) out += fmt::format(", {:.2f} s on {}", row.window_wall_s, row.threads);
  if (several)
    out += first.drag == all.drag && first.vertical == all.vertical ? "; loads of the same bits" : "; LOADS DIFFER";
  out += fmt::format(".\nFoam crushed to 75-85 % takes {:.2f} times the time of foam at 5-15 %.\n\n", t.crushed_cost);

  const auto& c = t.count;
  out += fmt::format(
      "Per particle-step at rest, counted by a step in counting arithmetic: {:.1f} thousand operations (a multiply-add "
      "is "
      "two),\n{:.0f} pairs of which {:.0f} lie within the support ({}), {:.2f} kB of neighbours' records and {:.2f} kB "
      "of "
      "its own.\nMemory: {:.0f} bytes per particle.\n\n",
      c.operations / 1e3, c.pairs, c.pairs_within, percent(c.pairs_within / c.pairs), c.neighbour_bytes / 1e3,
      c.own_bytes / 1e3, t.bytes_per_particle);

  TextTable limits = with_columns({{"this processor (" + t.instruction_set + "), measured"}, {}}, "ratio");
  add(
      limits, {"multiply-adds, single precision, Gflop/s"}, [](const Row& r) { return r.limits.operations; }, giga,
      true);
  add(
      limits, {"reading 256 KiB a thread, GB/s"}, [](const Row& r) { return r.limits.near_bytes; }, giga, true);
  add(
      limits, {"reading 64 MiB a thread, GB/s"}, [](const Row& r) { return r.limits.far_bytes; }, giga, true);
  out += aligned(limits) + "\n";

  const double bytes = c.neighbour_bytes + c.own_bytes, useful = c.pairs_within / c.pairs;
  TextTable shares = with_columns({{"foam at rest, share of the limit"}, {}}, "");
  add(
      shares, {"operations"}, [&](const Row& r) { return r.rest * c.operations / r.limits.operations; }, percent,
      false);
  add(
      shares, {"operations on pairs within the support"},
      [&](const Row& r) { return r.rest * c.operations * useful / r.limits.operations; }, percent, false);
  add(
      shares, {"bytes, from the second-level cache"},
      [&](const Row& r) { return r.rest * bytes / r.limits.near_bytes; }, percent, false);
  add(
      shares, {"limit of arithmetic alone, million particle-steps/s"},
      [&](const Row& r) { return r.limits.operations / c.operations; }, millions, false);
  return out + aligned(shares);
}

}  // namespace apc::cli
