#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apc/base/units.h"
#include "sph_backend/fem/fem_rig.h"
#include "sph_backend/press_rig.h"
#include "sph_backend/tire_rig.h"
#include "sph_backend/verification.h"

namespace apc::sph {
namespace {

using units::in;

/// The CRJ-200's nose tire, 4 in deep in an 8 in bed: the quickest deformable run.
RollingCase small_tire() {
  RollingCase c;
  c.foam = ideal_foam_50psi();
  c.tire = {"R18x4.4",          17.9 * in,           4.45 * in, 10.0 * in,
            225.0 * units::psi, 4350.0 * units::lbf, 0.92 * in, 13050.0 * units::lbf,
            2.02 * in};
  c.bed_depth = 8.0 * in, c.penetration = 4.0 * in, c.speed = 60.0 * units::kt, c.spacing = 1.0 * in;
  return c;
}

TEST(Platen, CrushWorkFollowsTheLoadCurveAndConverges) {
  const Verification coarse = verify(Study::platen_1d, 4.0 * in), fine = verify(Study::platen_1d, 2.0 * in);
  EXPECT_LT(coarse.quantities[0].value, 0.0378);  // below the published SPH value already at 4 in
  EXPECT_LT(fine.quantities[0].value, 0.015);
  EXPECT_LT(fine.quantities[0].value, coarse.quantities[0].value);
  EXPECT_LT(std::abs(fine.energy_residual), 0.005);
}

TEST(Platen, UnloadingIsElasticAndGivesBackLittle) {
  PressCase c;
  c.foam = ideal_foam_50psi();
  c.width = c.length = 12.0 * in, c.depth = 24.0 * in, c.spacing = 4.0 * in, c.strain_end = 0.5;
  const PressResult down = press(c);
  c.unload_to = 0.45;
  const PressResult back = press(c);
  EXPECT_LT(back.work.back(), *std::max_element(back.work.begin(), back.work.end()));  // some comes back
  EXPECT_GT(back.work.back(), 0.95 * down.work.back());                                // but only the elastic part
  EXPECT_LT(std::abs(back.residual), 0.005);
}

TEST(Platen, ForceFollowsTheLoadCurve) {
  PressCase c;
  c.foam = ideal_foam_50psi();
  c.width = c.length = 12.0 * in, c.depth = 24.0 * in, c.spacing = 2.0 * in;
  for (const bool elements : {false, true}) {
    const PressResult r = elements ? fem::press(c) : press(c);
    const double area = c.width * c.length;
    for (const double strain : {0.2, 0.4, 0.6}) {  // means over 5 % of strain: layers collapse one by one
      double sum = 0.0, count = 0.0;
      for (std::size_t k = 0; k < r.strain.size(); ++k)
        if (std::abs(r.strain[k] - strain) < 0.025) sum += r.force[k], count += 1.0;
      // Particles stand half a layer apart from the platen, so that the rest of the block is a little ahead.
      EXPECT_NEAR(sum / count / area / c.foam.yield_stress(strain), 1.0, elements ? 0.02 : 0.08) << strain;
    }
  }
}

TEST(Platen, ElementsFollowTheCurveCloserThanParticles) {
  StudyOptions options;
  options.method = Method::fem;
  const Verification coarse = verify(Study::platen_1d, 4.0 * in, options),
                     fine = verify(Study::platen_1d, 2.0 * in, options);
  EXPECT_LT(fine.quantities[0].value, coarse.quantities[0].value);
  EXPECT_LT(fine.quantities[0].value, 0.5 * verify(Study::platen_1d, 2.0 * in).quantities[0].value);
  EXPECT_LT(std::abs(fine.energy_residual), 1e-3);
  EXPECT_LT(fine.hourglass_share, 1e-4);
  options.elements.integration = fem::Integration::full;
  EXPECT_NEAR(verify(Study::platen_1d, 4.0 * in, options).quantities[0].value, coarse.quantities[0].value, 0.002);
}

TEST(Punch, ResistsMoreThanItsColumnAndLessAsItIsRefined) {
  for (const Method method : {Method::sph, Method::fem}) {
    StudyOptions options;
    options.method = method;
    const Verification coarse = verify(Study::punch_2d, 4.0 * in, options),
                       fine = verify(Study::punch_2d, 2.0 * in, options);
    EXPECT_GT(fine.quantities[0].value, 1.0);
    EXPECT_LT(fine.quantities[0].value, coarse.quantities[0].value);
    EXPECT_LT(std::abs(fine.energy_residual), 0.002);
  }
}

TEST(Roller, ElementsCloseTheirAccountWithAnHourglassShare) {
  StudyOptions options;
  options.method = Method::fem;
  const Verification v = verify(Study::roller_2d, 4.0 * in, options);
  EXPECT_EQ(v.state, "steady");
  EXPECT_LT(std::abs(v.energy_residual), 0.005);
  EXPECT_GT(v.hourglass_share, 0.05);
  EXPECT_LT(v.hourglass_share, 0.2);
  options.elements.integration = fem::Integration::full;
  const Verification full = verify(Study::roller_2d, 4.0 * in, options);
  EXPECT_EQ(full.hourglass_share, 0.0);
  EXPECT_NEAR(full.quantities[1].value / v.quantities[1].value, 1.0, 0.15);
}

TEST(Roller, SpinDecidesDragWhereThereIsFriction) {
  StudyOptions options;
  options.friction = 0.3;
  const double free = verify(Study::roller_2d, 4.0 * in, options).quantities[1].value;
  options.spin = WheelSpin::driven;
  EXPECT_LT(verify(Study::roller_2d, 4.0 * in, options).quantities[1].value, 0.9 * free);
  options.spin = WheelSpin::locked;
  EXPECT_GT(verify(Study::roller_2d, 4.0 * in, options).quantities[1].value, 1.1 * free);
}

TEST(Roller, CoarseRunClosesItsAccount) {
  const Verification v = verify(Study::roller_2d, 4.0 * in);
  EXPECT_EQ(v.state, "steady");
  EXPECT_LT(std::abs(v.energy_residual), 0.015);
  EXPECT_GT(v.quantities[1].value, v.quantities[1].reference);  // coarse particles resist too much
}

TEST(SlowTire, PublishedCaseAtTwoInches) {
  const Verification v = verify(Study::tire_3d, 2.0 * in);
  EXPECT_EQ(v.state, "steady");
  EXPECT_LT(std::abs(v.energy_residual), 0.01);
  // At 2 in, friction 0.3: 20 %, 26 % and 8 % above the published converged values; regression bands, not agreement.
  EXPECT_NEAR(v.quantities[0].difference(), 0.20, 0.05);
  EXPECT_NEAR(v.quantities[1].difference(), 0.26, 0.05);
  EXPECT_NEAR(v.quantities[2].difference(), 0.08, 0.04);
}

/// The results kept in apc/doc/measured are those of this code: one size is run again, the limits are read.
TEST(SlowTire, MeasuredResultsAreOfThisCodeAndNearThePaper) {
  const auto kept = nlohmann::json::parse(std::ifstream(PROJECT_DIR "/apc/doc/measured/tire_3d.json"));
  const Verification now = verify(Study::tire_3d, 2.0 * in);
  int compared = 0;
  for (const auto& run : kept.at("runs")) {
    if (std::abs(run.at("spacing").get<double>() / (2.0 * in) - 1.0) > 1e-6) continue;
    for (const Quantity& q : now.quantities) {
      EXPECT_NEAR(run.at(q.name).get<double>() / q.value, 1.0, 0.01) << q.name;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 3);
  for (const Quantity& q : now.quantities) {
    EXPECT_NEAR(kept.at("extrapolated").at(q.name).get<double>() / q.reference, 1.0, 0.10) << q.name;
    EXPECT_GT(kept.at("r2").at(q.name).get<double>(), 0.99) << q.name;
  }
  for (const auto& run : kept.at("runs")) EXPECT_LT(std::abs(run.at("energy_residual").get<double>()), 0.015);
}

/// Why the pair sums are of the mass form: with the other one foam under the wheel fills less and less of its room.
TEST(SlowTire, VolumesOfTheVolumeFormDriftUnderTheWheel) {
  StudyOptions options;
  options.form = PairForm::volume;
  const Verification volume = verify(Study::tire_3d, 2.0 * in, options);
  EXPECT_LT(std::abs(volume.energy_residual), 0.005);  // and its account does not tell
  EXPECT_LT(volume.partition, 0.95);
  const auto kept = nlohmann::json::parse(std::ifstream(PROJECT_DIR "/apc/doc/measured/tire_3d_volume_form.json"));
  EXPECT_NEAR(kept.at("runs").at(1).at("partition").get<double>(), volume.partition, 0.01);
  EXPECT_NEAR(kept.at("runs").at(1).at("vertical").get<double>() / volume.quantities[0].value, 1.0, 0.01);
}

TEST(SlowTire, WindowDoesNotDecideTheLoads) {
  RollingCase c = small_tire();
  c.load_tolerance = 0.005, c.spin_tolerance = 0.005;
  const RollingResult narrow = roll(c);
  c.ahead = 30.0 * in, c.behind = 30.0 * in;
  const RollingResult wide = roll(c);
  EXPECT_NEAR(narrow.drag / wide.drag, 1.0, 0.01);
  EXPECT_NEAR(narrow.vertical / wide.vertical, 1.0, 0.01);
}

TEST(SlowTire, WayOfEntryDoesNotDecideTheLoads) {
  RollingCase c = small_tire();
  c.load_tolerance = 0.005, c.spin_tolerance = 0.005;
  const RollingResult pressed = roll(c);
  c.entry = 20.0 * in;
  const RollingResult rolled_in = roll(c);
  EXPECT_EQ(rolled_in.state, RunState::steady);
  EXPECT_LT(std::abs(rolled_in.residual), 0.03);
  EXPECT_NEAR(rolled_in.drag / pressed.drag, 1.0, 0.03);
  EXPECT_NEAR(rolled_in.vertical / pressed.vertical, 1.0, 0.03);
}

TEST(SlowTire, ElementsCarryTheDeformableTire) {
  RollingCase c = small_tire();
  const RollingResult r = fem::roll(c);
  EXPECT_EQ(r.state, RunState::steady) << r.message;
  EXPECT_LT(std::abs(r.residual), 0.01);
  EXPECT_GT(r.energy.hourglass / r.energy.foam_internal, 0.03);
  EXPECT_NEAR(r.vertical / roll(c).vertical, 1.0, 0.3);  // one-inch cells under a 4.45 in tire
}

/// On a way that falls by α a rigid wheel gains the share α/sin θ of its vertical load (simulation::Sinking, factor 1).
/// The flexible tire gains more, since its patch is flat: 1.6 and 1.9 at 2 in, 8 and 12 in deep, 18 in bed, 70 kt.
TEST(SinkingTire, IsPushedBackAtLeastLikeTheRigidArc) {
  RollingCase c = small_tire();
  c.fall = 0.03;
  const RollingResult down = roll(c);
  c.fall = -0.03;
  const RollingResult up = roll(c);
  ASSERT_EQ(down.state, RunState::steady);
  ASSERT_EQ(up.state, RunState::steady);
  const double radius = 0.5 * c.tire.diameter, P = c.penetration, mean = 0.5 * (down.vertical + up.vertical);
  const double factor = (down.vertical - up.vertical) / (0.06 * mean) * std::sqrt(2.0 * radius * P - P * P) / radius;
  std::printf("sinking: vertical %.2f times the rigid arc, drag %+.2f of the vertical load per unit slope\n", factor,
              (down.drag - up.drag) / (0.06 * mean));
  EXPECT_GT(factor, 0.9);
  EXPECT_LT(factor, 2.5);
  EXPECT_LT(std::abs(down.residual), 0.03);
}

}  // namespace
}  // namespace apc::sph
