/// Critical speeds integrated in closed form against plain hit or miss, which knows nothing of critical speeds: exit
/// speeds drawn like everything else, one overrun each, counted.
#include <gtest/gtest.h>

#include <cmath>

#include "apc/design/constraint.h"
#include "apc/reliability/reliability.h"
#include "apc/simulation/simulate_each.h"
#include "apc/study/critical_speed.h"
#include "loadtables/find_tables.h"
#include "tests/support/simulation_models.h"

namespace apc::reliability {
namespace {

ReliabilityInput shipped_case(const std::string& aircraft, const std::string& bed) {
  ReliabilityInput input;
  const auto plane = testing::shipped_aircraft(aircraft);
  auto place = bed::load_bed(shipped("designs/beds") / (bed + ".json"));
  std::vector<loadtables::LoadTable> tables;
  for (const auto& gear : plane.gears)
    tables.push_back(loadtables::find_table(shipped("loadtables/data"), place.material,
                                            simulation::table_tire(plane.tires.at(gear.tire))));
  input.model = simulation::make_model(plane, std::move(place), tables);
  input.asked_speed = input.centre.entry_speed = 70 * units::kt;
  return input;
}

TEST(HitOrMiss, AgreesWithCriticalSpeedsOfAShippedAircraft) {
  auto input = shipped_case("CRJ-200", "emas_14in_50psi");
  design::Limits limits;
  limits.table_range = false;
  limits.criterion = study::Criterion::ultimate;
  input.use = [&](const simulation::Result& result) { return design::worst_use(result, input.model, limits); };
  study::Store store;
  ReliabilityOptions options;
  options.samples = 600;
  const auto out = assess(input, side_by_side(), store, options);
  EXPECT_EQ(out.gave_up, 0u);

  constexpr std::size_t count = 1500;
  auto endless = input.model;
  endless.bed = study::continued(input.model.bed);
  std::vector<simulation::Overrun> runs;
  Draws speeds(77);
  for (const auto& u : latin_hypercube(count, 4242)) {
    runs.push_back(drawn(input.model, input.centre, input.scatter, u, 900000 + runs.size()));
    const auto& law = input.exit_speeds;
    const double share = (static_cast<double>(runs.size()) - speeds.next()) / count;  // one speed of each stratum
    runs.back().entry_speed = law.scale * std::pow(-std::log(share), 1 / law.shape);
  }
  std::vector<simulation::Errand> errands;
  std::size_t arrested = 0, intact = 0, lost = 0;
  for (const auto& each : runs) {
    if (each.entry_speed < 2.0)
      ++arrested, ++intact;          // stops before the bed is felt
    else if (each.entry_speed < 55)  // faster ones all leave this bed
      errands.push_back({&endless, &each, &options.solver});
  }
  for (const auto& each : simulation::simulate_each(errands)) {
    if (each.failure) {
      ++lost;
      continue;
    }
    const bool stopped = each.result.stop_distance <= input.model.bed.length();
    arrested += stopped, intact += stopped && input.use(each.result) <= 1.0;
  }
  const auto expect = [&](std::size_t hits, const Estimate& estimate, const char* what) {
    const double share = static_cast<double>(hits) / static_cast<double>(count - lost);
    const double sigma = std::sqrt(share * (1 - share) / static_cast<double>(count - lost));
    EXPECT_NEAR(share, estimate.value, 3 * sigma + 0.5 * (estimate.high - estimate.low)) << what;
    std::printf("%s: hit or miss %.4f ± %.4f, critical speeds %.4f (%.4f to %.4f)\n", what, share, sigma,
                estimate.value, estimate.low, estimate.high);
  };
  EXPECT_EQ(lost, 0u);
  expect(arrested, out.arrest, "arrest");
  expect(intact, out.intact, "no damage");
}

}  // namespace
}  // namespace apc::reliability
