#include "apc/simulation/equations.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "apc/base/require.h"
#include "apc/simulation/dual.h"
#include "apc/simulation/energy.h"
#include "apc/simulation/motion.h"
#include "apc/simulation/overrun_run.h"
#include "apc/simulation/trim.h"
#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

TEST(Dual, CarriesDerivativesThroughEveryOperation) {
  const auto f = [](const auto& x) {
    using std::sin, std::cos, std::tanh, std::sqrt, std::pow, std::abs;
    return sin(x) * cos(2.0 * x) + tanh(x) / sqrt(1.0 + x * x) - pow(x, -1.1) + 3.0 / x + abs(-x) * 0.5 - (1.0 - x);
  };
  const double x = 0.7, h = 1e-6;
  EXPECT_NEAR(f(Dual<1>::variable(x, 0)).d[0], (f(x + h) - f(x - h)) / (2 * h), 1e-8);
}

/// A state well inside a bed, everything moving.
std::vector<double> lively_state(const Plant& plant) {
  auto y = trim(plant, 25.0).state;
  const auto n = static_cast<std::size_t>(plant.degrees());
  y[0] += 45.0;
  y[1] -= 0.25;
  y[2] = 0.01;
  y[n + 1] = 0.1;
  y[n + 2] = -0.05;
  for (std::size_t g = 0; g < plant.groups.size(); ++g) y[n + 3 + g] = 0.03 * (g % 2 == 0 ? 1.0 : -1.0);
  return y;
}

TEST(Equations, JacobianAgreesWithDifferencesForEveryShippedAircraft) {
  struct Case {
    const char* name;
    double sinking;
    bool brake_rods;
  };
  for (const auto& [name, sinking, brake_rods] : {Case{"CRJ-200", 0.0, true},
                                                  {"B737-800", 0.0, true},
                                                  {"B747-400", 0.0, true},
                                                  {"B747-400", 0.0, false},
                                                  {"B737-800", 1.0, true},
                                                  {"B747-400", 1.0, true}}) {
    auto model = testing::foam_model(name, testing::foam_bed(0.45));
    for (auto& gear : model.aircraft.gears) gear.brake_rods = brake_rods;
    Overrun overrun;
    overrun.entry_speed = 25.0;
    overrun.braking = 0.2;
    overrun.sinking = {sinking, -0.4 * sinking};
    const auto plant = make_plant(model, overrun);
    const auto y = lively_state(plant);
    const auto around = surroundings_at_entry(plant);
    const auto n = y.size();
    std::vector<double> rate(n), matrix(n * n), up(n), down(n);
    jacobian(plant, around, 0.0, y.data(), rate.data(), matrix.data());
    for (std::size_t j = 0; j < n; ++j) {
      const double h = 1e-6;
      auto a = y, b = y;
      a[j] += h;
      b[j] -= h;
      derivatives(plant, around, 0.0, a.data(), up.data());
      derivatives(plant, around, 0.0, b.data(), down.data());
      for (std::size_t i = 0; i < n; ++i) {
        const double difference = (up[i] - down[i]) / (2 * h);
        EXPECT_NEAR(matrix[i * n + j], difference, 2e-4 * (1.0 + std::abs(difference))) << name << " " << i << "," << j;
      }
    }
  }
}

TEST(Sinking, AddsTheArcBehindTheLowestPoint) {
  // A rigid wheel in foam of constant pressure: vertical / (σ w R) = sin θ + sin α on a path that falls by α.
  const double radius = 0.5, penetration = 0.2, front = 0.8;  // sin θ = √(2RP − P²)/R
  for (const double fall : {-0.02, 0.01, 0.02}) {
    GroundNumbers<double> ground{0.5, front, 0.1, 1.0};
    sink<double>({1.0, 0.0}, 0.0, radius, penetration, 30.0, -30.0 * fall, ground);
    EXPECT_NEAR(ground.vertical - front, std::sin(fall), 0.06 * std::abs(fall));  // blunted where the contact is short
    EXPECT_EQ(ground.drag, 0.5);
  }
}

TEST(Equations, ConserveEnergyAtEveryInstant) {
  // d(stores)/dt + Σ powers = 0 along the motion, checked at one instant by differences.
  for (const auto& [name, brake_rods] :
       {std::pair{"CRJ-200", true}, {"B737-800", true}, {"B747-400", true}, {"B747-400", false}})
    for (const auto mode : {BrakeMode::friction, BrakeMode::torque}) {
      auto model = testing::foam_model(name, testing::foam_bed(0.45));
      for (auto& gear : model.aircraft.gears) gear.brake_rods = brake_rods;
      Overrun overrun;
      overrun.entry_speed = 25.0;
      overrun.braking = 0.2;
      overrun.brake_mode = mode;
      overrun.thrust = -8000.0;
      if (mode == BrakeMode::torque) overrun.sinking = {1.0, -0.4};
      const auto plant = make_plant(model, overrun);
      const auto y = lively_state(plant);
      const auto around = surroundings_at_entry(plant);
      std::vector<double> rate(y.size());
      Moment moment;
      derivatives(plant, around, 0.0, y.data(), rate.data(), &moment);
      const double h = 1e-6;
      auto after = y, before = y;
      for (std::size_t i = 0; i < y.size(); ++i) after[i] += h * rate[i], before[i] -= h * rate[i];
      const double gained = (stores(plant, after.data()).sum() - stores(plant, before.data()).sum()) / (2 * h);
      double lost = 0.0, largest = 0.0;
      for (const double power : powers(plant, around, y.data(), moment)) {
        lost += power;
        largest = std::max(largest, std::abs(power));
      }
      EXPECT_NEAR(gained + lost, 0.0, 1e-6 * largest) << name;
    }
}

TEST(Trim, CarriesTheWeightOnAnySlope) {
  for (const double grade : {0.0, 0.02}) {
    auto bed = testing::pavement();
    bed.grade = grade;
    auto plane = testing::shipped_aircraft("B737-800");
    plane.aero = {};
    const auto model = testing::foam_model("B737-800", bed);
    Model still = model;
    still.aircraft = plane;
    Overrun overrun;
    overrun.entry_speed = 30.0;
    const auto plant = make_plant(still, overrun);
    const auto balance = trim(plant, 30.0);
    std::vector<double> rate(balance.state.size());
    Moment moment;
    Surroundings around;
    around.ruts.resize(plant.rows.size());
    derivatives(plant, around, 0.0, balance.state.data(), rate.data(), &moment);
    double vertical = 0.0;
    for (std::size_t r = 0; r < plant.rows.size(); ++r) vertical += moment.rows[r].force_z;
    const double weight = plant.mass * units::g0 * std::cos(std::atan(grade));
    EXPECT_NEAR(vertical, weight, 1e-10 * weight);
  }
}

TEST(Trim, BalancesMomentsBrakedOrNot) {
  // In trim all parts decelerate alike: the tires' forces and the brakes' torque have no moment about the common centre
  // of gravity, which is made of sprung and unsprung masses as they stand. Nose loads follow from nothing else.
  for (const auto* name : {"CRJ-200", "B727-100", "B737-800", "B747-400"})
    for (const double braking : {0.0, 0.25})
      for (const auto mode : {BrakeMode::friction, BrakeMode::torque}) {
        auto model = testing::foam_model(name, testing::pavement());
        model.aircraft.aero = {};
        Overrun overrun;
        overrun.entry_speed = 30.0;
        overrun.braking = braking;
        overrun.brake_mode = mode;
        const auto plant = make_plant(model, overrun);
        const auto y = trim(plant, 30.0).state;
        std::vector<double> rate(y.size());
        Moment moment;
        derivatives(plant, surroundings_at_entry(plant), 0.0, y.data(), rate.data(), &moment);
        Vector cg{plant.sprung_mass * y[0], plant.sprung_mass * y[1]};
        for (std::size_t g = 0; g < plant.groups.size(); ++g) {
          cg.x += plant.groups[g].mass * moment.groups[g].axle.x;
          cg.z += plant.groups[g].mass * moment.groups[g].axle.z;
        }
        cg = {cg.x / plant.mass, cg.z / plant.mass};
        double sum = 0.0, force = 0.0;
        for (std::size_t r = 0; r < plant.rows.size(); ++r) {
          const auto& row = moment.rows[r];
          const auto& group = plant.groups[static_cast<std::size_t>(plant.rows[r].group)];
          const double height = group.tire_radius - row.penetration;  // of the axle: on pavement they differ by P alone
          sum += (row.distance - cg.x) * row.force_z - (height - cg.z) * row.force_x - row.brake_torque;
          force += row.force_x;
        }
        const double weight = plant.mass * units::g0, base = model.aircraft.gears[1].behind_nose_gear;
        EXPECT_NEAR(sum, 0.0, 1e-8 * weight * base) << name << " " << braking;
        EXPECT_NEAR(force, plant.mass * moment.cg_acceleration.x, 1e-8 * weight) << name;
      }
}

TEST(Trim, GivesTheNoseItsShareAndTheFilesOwnAttitude) {
  for (const auto* name : {"CRJ-200", "B737-800", "B747-400"}) {
    auto plane = testing::shipped_aircraft(name);
    plane.aero = {};
    auto model = testing::exact_model(plane, [&](double, double penetration) {
      return TireLoad{0.0, 3e6 * penetration};
    });
    for (std::size_t g = 0; g < plane.gears.size(); ++g) {  // the tires' own curves, linear through the static point
      const auto& tire = plane.tires.at(plane.gears[g].tire);
      model.tables[g] = testing::foam_table(tire);
    }
    Overrun overrun;
    overrun.entry_speed = 20.0;
    const auto plant = make_plant(model, overrun);
    const auto balance = trim(plant, 1e-3);
    EXPECT_NEAR(balance.state[2], 0.0, 3e-4) << name;  // rad: only rolling resistance pitches it
    std::vector<double> rate(balance.state.size());
    Moment moment;
    Surroundings around;
    around.ruts.resize(plant.rows.size());
    derivatives(plant, around, 0.0, balance.state.data(), rate.data(), &moment);
    double behind = 0.0, wheels = 0.0;
    for (const auto& gear : plane.gears)
      if (!gear.is_nose()) behind += gear.wheels() * gear.behind_nose_gear, wheels += gear.wheels();
    const double base = behind / wheels;
    // Rolling resistance acts on the axles, below the centre of gravity.
    double resisted = 0.0;
    for (std::size_t r = 0; r < plant.rows.size(); ++r) resisted -= moment.rows[r].force_x;
    const double weight = plane.mass * units::g0;
    const double axle = plant.groups[1].tire_radius - moment.rows[1].penetration;
    const double expected =
        (base - plane.cg_behind_nose_gear) / base + resisted * (plane.cg_height - axle) / (weight * base);
    std::printf("V6 nose share %s: %.5f, by hand %.5f\n", name, moment.rows[0].force_z / weight, expected);
    EXPECT_NEAR(moment.rows[0].force_z / weight, expected, 2e-4) << name;
  }
}

TEST(Trim, BrakingLoadsTheNoseByItsMoment) {
  auto plane = testing::shipped_aircraft("B737-800");
  plane.aero = {};
  auto model = testing::foam_model("B737-800", testing::pavement());
  model.aircraft = plane;
  Overrun overrun;
  overrun.entry_speed = 30.0;
  const auto load = [&](double braking, double& deceleration) {
    overrun.braking = braking;
    const auto plant = make_plant(model, overrun);
    const auto balance = trim(plant, 30.0);
    std::vector<double> rate(balance.state.size());
    Moment moment;
    Surroundings around;
    around.ruts.resize(plant.rows.size());
    derivatives(plant, around, 0.0, balance.state.data(), rate.data(), &moment);
    deceleration = -balance.acceleration;
    return moment.rows[0].force_z;
  };
  double free_deceleration = 0.0, braked_deceleration = 0.0;
  const double free = load(0.0, free_deceleration), braked = load(0.25, braked_deceleration);
  const double base = plane.gears[1].behind_nose_gear;
  const double expected = plane.mass * (braked_deceleration - free_deceleration) * plane.cg_height / base;
  EXPECT_NEAR(braked - free, expected, 0.05 * expected);  // cg height and wheelbase move a little with pitch
  EXPECT_GT(braked_deceleration, 0.2 * units::g0);
}

TEST(Trim, WithoutBrakeRodsTheBrakesLoadTheFrontAxlesOfABogie) {
  // Steady braking on pavement, moments about a bogie's pivot: with rods the wheels' forces balance alone; without,
  // they carry the brakes' torque, and the front axle more than the rear one by 2 T / spacing.
  for (const bool rods : {true, false})
    for (const auto mode : {BrakeMode::friction, BrakeMode::torque}) {
      auto model = testing::foam_model("B747-400", testing::pavement());
      for (auto& gear : model.aircraft.gears) gear.brake_rods = rods;
      Overrun overrun;
      overrun.entry_speed = 30.0;
      overrun.braking = 0.25;
      overrun.brake_mode = mode;
      const auto plant = make_plant(model, overrun);
      const auto y = trim(plant, 30.0).state;
      std::vector<double> rate(y.size());
      Moment moment;
      derivatives(plant, surroundings_at_entry(plant), 0.0, y.data(), rate.data(), &moment);
      for (const auto& group : plant.groups) {
        if (group.bogie < 0) continue;
        const double beam = y[3 + plant.groups.size() + static_cast<std::size_t>(group.bogie)];
        double lever = 0.0, torque = 0.0;
        for (int r = group.first_row; r < group.first_row + group.rows; ++r) {
          const auto& row = moment.rows[static_cast<std::size_t>(r)];
          const double offset = plant.rows[static_cast<std::size_t>(r)].offset;
          lever += offset * (std::cos(beam) * row.force_z - std::sin(beam) * row.force_x);
          torque += row.brake_torque;
        }
        ASSERT_GT(torque, 0.0) << group.name;
        EXPECT_NEAR(lever, rods ? 0.0 : torque, 1e-6 * torque) << group.name;
        const auto &front = moment.rows[static_cast<std::size_t>(group.first_row)],
                   &rear = moment.rows[static_cast<std::size_t>(group.first_row + 1)];
        const double spacing = model.aircraft.gears[1].axle_spacing;
        EXPECT_NEAR(front.force_z - rear.force_z, rods ? 0.0 : 2.0 * torque / spacing, 0.02 * 2.0 * torque / spacing);
      }
    }
}

TEST(Trim, SaysWhatToCheckWhenThereIsNoBalance) {
  auto model = testing::foam_model("B737-800", testing::pavement());
  Overrun overrun;
  overrun.entry_speed = 30.0;
  overrun.thrust = 3e6;
  model.aircraft.thrust_height = 30.0;  // lifts the main gear off the ground
  const auto plant = make_plant(model, overrun);
  try {
    trim(plant, 30.0);
    ADD_FAILURE() << "trimmed";
  } catch (const SolveError& error) {
    for (const char* words : {"cannot be trimmed at t = 0 s", "speed 30.00 m/s", "Look at mass"})
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace apc::simulation
