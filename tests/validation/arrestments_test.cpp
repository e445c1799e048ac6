/// Real stops in installed beds, backwards: the published distances with the unknown inputs spread over their ranges
/// give the band of entry speeds that explains them. No open report holds speed at the bed's edge, weight, depth
/// profile and strength together, so none of these cases can prove the model; they can show that it asks for nothing
/// absurd. Every one ended within 240 ft: what they test is the lead-in of a bed, not its full depth.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/support/simulation_models.h"
#include "tests/validation/bands.h"

namespace apc::simulation {
namespace {

using apc::testing::halton, apc::testing::quantile, apc::testing::Range, apc::testing::root;
using units::ft, units::in, units::kt, units::lb;

/// One arrestment: nose-wheel distance in the bed, and the ranges of what was not published.
struct Arrestment {
  std::string id, aircraft;
  bool (*keeps)(const aircraft::Gear&);  ///< gears of the stand-in that stay; all when null
  double distance;                       ///< ft
  Range mass;                            ///< lb
  Range braking;                         ///< friction on the main wheels
  Range first_depth, full_depth;         ///< in, at the bed's edge and after the lead-in
};

/// Strength 50 to 80 psi: the grades of cellular cement on offer. Lead-in 50 to 200 ft.
constexpr Range strength{1.0, 1.6}, lead_in{50, 200};

Model model_of(const Arrestment& arrestment) {
  auto plane = apc::testing::shipped_aircraft(arrestment.aircraft);
  if (arrestment.keeps) std::erase_if(plane.gears, [&](const auto& gear) { return !arrestment.keeps(gear); });
  std::vector<loadtables::LoadTable> tables;
  for (const auto& [tire, data] : plane.tires)
    tables.push_back(loadtables::load_table(shipped("loadtables/data/" + tire + "_foam_50psi.h5")));
  return make_model(std::move(plane), bed::load_bed(shipped("designs/beds/emas_18in_50psi.json")), tables);
}

constexpr std::array names{"lead-in", "full depth", "first depth", "mass", "braking", "strength"};
using Shares = std::array<double, names.size()>;

/// The entry speed that ends at the published distance, the unknowns at these shares of their ranges; NaN if none.
double entry_speed(const Arrestment& arrestment, Model model, const Shares& share) {
  auto& bed = model.bed;
  const double full = arrestment.full_depth.at(share[1]) * in;
  bed.distance = {0.0, 1.0, lead_in.at(share[0]) * ft, 900.0};
  bed.depth = {0.0, arrestment.first_depth.at(share[2]) * in, full, full};
  Overrun overrun;
  overrun.mass = arrestment.mass.at(share[3]) * lb;
  overrun.braking = arrestment.braking.at(share[4]);
  overrun.alterations.bed_strength = strength.at_log(share[5]);
  Options options;
  options.method = Method::fast;
  options.sampling = 0.0;
  return root(
      [&](double speed) {
        overrun.entry_speed = speed;
        return simulate(model, overrun, options).stop_distance - arrestment.distance * ft;
      },
      8 * kt, 65 * kt, 0.3);
}

struct Band {
  double lowest = 0.0, median = 0.0, highest = 0.0;  ///< kt
};

Band entry_band(const Arrestment& arrestment, int points = 20) {
  const auto model = model_of(arrestment);
  std::vector<double> speeds;
  for (int i = 0; i < points; ++i) {
    Shares share;
    for (std::size_t k = 0; k < share.size(); ++k) share[k] = halton(i, static_cast<int>(k));
    speeds.push_back(entry_speed(arrestment, model, share) / kt);
    EXPECT_TRUE(std::isfinite(speeds.back())) << arrestment.id << ", point " << i;
  }
  const Band band{quantile(speeds, 0.0), quantile(speeds, 0.5), quantile(speeds, 1.0)};
  const auto mean_g = [&](double speed) {
    return std::pow(speed * kt, 2) / (2 * arrestment.distance * ft * units::g0);
  };
  fmt::print("{} by {}, nose {:.0f} ft: entry {:.0f} / {:.0f} / {:.0f} kt, mean {:.2f} / {:.2f} / {:.2f} g\n",
             arrestment.id, arrestment.aircraft, arrestment.distance, band.lowest, band.median, band.highest,
             mean_g(band.lowest), mean_g(band.median), mean_g(band.highest));
  return band;
}

/// How much each unknown moves the speed: from one end of its range to the other, the rest halfway.
void print_what_decides(const Arrestment& arrestment) {
  const auto model = model_of(arrestment);
  fmt::print(" ");
  for (std::size_t k = 0; k < names.size(); ++k) {
    Shares low, high;
    low.fill(0.5), high.fill(0.5);
    low[k] = 0.0, high[k] = 1.0;
    fmt::print(" {} {:+.1f}", names[k],
               (entry_speed(arrestment, model, high) - entry_speed(arrestment, model, low)) / kt);
  }
  fmt::print(" kt\n");
}

/// CRJ-200, 44,400 lb at take-off, nose wheel 128 ft into 405 ft, depth 6 to 20 in or 24 in (press), brakes on.
TEST(Arrestments, Charleston2010) {
  const Arrestment charleston{"CRW 2010", "CRJ-200", nullptr, 128, {43000, 44400}, {0.0, 0.3}, {6, 9}, {18, 24}};
  const auto band = entry_band(charleston);
  print_what_decides(charleston);
  EXPECT_GT(band.lowest, 15);
  EXPECT_LT(band.highest, 70) << "the bed was made for 70 kt in 405 ft";
}

/// B737-700, 71 ft into the bed behind 73 ft of set-back; the 737-800 stands in, at the lighter type's weights. An
/// analysis of its broadcasts puts the nose gear into the bed at 35 to 40 kt. With 71 ft of the nose wheel the mains
/// had crushed 20 ft only, and no bed in the box stops it from there; as a distance of the mains it comes near.
TEST(Arrestments, Burbank2018) {
  const Range mass{110000, 128000}, braking{0.0, 0.3}, first{6, 9}, full{12, 24};
  const auto nose = entry_band({"BUR 2018", "B737-800", nullptr, 71, mass, braking, first, full});
  const auto mains = entry_band({"BUR 2018, of the mains", "B737-800", nullptr, 71 + 51.2, mass, braking, first, full});
  EXPECT_LT(nose.highest, 35) << "the published speed no longer contradicts: say so in the document";
  EXPECT_GT(mains.highest, nose.highest + 5);
}

/// Gulfstream IV, about 100 ft into the bed, left the runway at 40 to 50 kt by the crew; set-back not known. The
/// CRJ-200 stands in: as many tires, of 9 in against 9.25 in.
TEST(Arrestments, Teterboro2010) {
  const auto band = entry_band({"TEB 2010", "CRJ-200", nullptr, 100, {45000, 55000}, {0.0, 0.3}, {6, 9}, {12, 24}});
  EXPECT_LT(band.median, 50) << "no faster than it left the runway";
}

/// Saab 340, 214 ft across the bed (a preliminary report), the gear 30 in deep at the end. The CRJ-200 stands in at the
/// Saab's weight: six tires with 45 in of width together against about 43.
TEST(Arrestments, Kennedy1999) {
  const auto band = entry_band({"JFK 1999", "CRJ-200", nullptr, 214, {25000, 28500}, {0.0, 0.3}, {6, 9}, {24, 30}});
  EXPECT_LT(band.highest, 65);
}

/// MD-11, about 470,000 lb, nose gear 115 ft into the bed behind 123 ft of set-back, brakes and reverse. Its ten main
/// tires lie between the 747's sixteen and the eight of its wing gears.
TEST(Arrestments, Kennedy2003) {
  const Range mass{470000, 470000}, braking{0.0, 0.3}, first{6, 9}, full{24, 30};
  const auto keep = [](const aircraft::Gear& gear) { return gear.name != "body"; };
  const auto sixteen = entry_band({"JFK 2003, 16 main tires", "B747-400", nullptr, 115, mass, braking, first, full}, 6);
  const auto eight = entry_band({"JFK 2003, 8 main tires", "B747-400", keep, 115, mass, braking, first, full}, 6);
  EXPECT_NEAR(sixteen.median, eight.median, 5);
}

}  // namespace
}  // namespace apc::simulation
