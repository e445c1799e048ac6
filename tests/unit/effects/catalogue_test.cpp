#include "apc/effects/other_forms.h"

#include <gtest/gtest.h>

#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::effects {
namespace {

TireState in_the_bed() {
  TireState state;
  state.bed_distance = 20.0, state.nose_distance = 30.0, state.time = 1.5;
  state.speed = 25.0, state.bed_depth = 0.4, state.penetration = 0.2, state.vertical = 8e4;
  state.tire_width = 0.3, state.tire_radius = 0.5, state.density = 320.0;
  state.years = 4.0, state.temperature = 283.15, state.wheels = 4;
  return state;
}

aircraft::Aircraft two_gears() {
  aircraft::Aircraft a;
  a.mass = 2e4, a.cg_behind_nose_gear = 9.0, a.aero.area = 50.0, a.aero.CD = 0.13;
  aircraft::Gear nose, main;
  nose.name = "nose", main.name = "main", main.behind_nose_gear = 10.0, main.struts = 2;
  nose.strut.friction = main.strut.friction = 1e3;
  a.gears = {nose, main};
  return a;
}

bed::Bed flat_bed() {
  bed::Bed b;
  b.distance = {0.0, 10.0, 100.0}, b.depth = {0.0, 0.4, 0.4};
  return b;
}

/// The catalogue's laws, then those of other form.
std::vector<Effect> all_laws() {
  auto laws = catalogue();
  laws.insert(laws.end(), other_forms().begin(), other_forms().end());
  laws.push_back(lock_up_gradual());
  return laws;
}

TEST(Effects, EveryEffectIsNeutralAtItsNeutralAmplitude) {
  for (const Effect& effect : all_laws()) {
    SCOPED_TRACE(effect.id + " " + effect.form);
    const Applied one = applied(effect, effect.parameters.front().neutral);
    TireChange change;
    if (effect.bed) effect.bed(in_the_bed(), one.values, change);
    if (effect.force) effect.force(in_the_bed(), one.values, change);
    EXPECT_EQ(change.strength, 1.0);
    EXPECT_EQ(change.depth, 1.0);
    EXPECT_EQ(change.tire_pressure, 1.0);
    EXPECT_EQ(change.drag, 0.0);
    EXPECT_EQ(change.vertical, 0.0);
    const double push = effect.thrust ? effect.thrust(1.0, one.values) : 0.0;
    EXPECT_EQ(push, 0.0);
    if (effect.site) {
      auto a = two_gears();
      auto b = flat_bed();
      Site site{a, b, a.mass, a.cg_behind_nose_gear};
      effect.site(site, one.values);
      EXPECT_EQ(a.aero.CD, 0.13);
      EXPECT_EQ(a.gears[1].strut.friction, 1e3);
      EXPECT_EQ(b.depth, flat_bed().depth);
      EXPECT_EQ(b.grade, 0.0);
      EXPECT_EQ(site.headwind, 0.0);
    }
  }
}

TEST(Effects, EveryEffectDoesSomethingAtItsUsualAmplitude) {
  for (const Effect& effect : all_laws()) {
    SCOPED_TRACE(effect.id + " " + effect.form);
    ASSERT_TRUE(effect.bed || effect.force || effect.site || effect.thrust);
    EXPECT_FALSE(effect.law.empty());
    EXPECT_FALSE(effect.source.empty());
    const Parameter& amplitude = effect.parameters.front();
    EXPECT_NE(amplitude.usual, amplitude.neutral);
    EXPECT_LE(amplitude.low, amplitude.usual);
    EXPECT_GE(amplitude.high, amplitude.usual);
    Applied one = applied(effect, amplitude.usual);
    TireState state = in_the_bed();
    if (effect.id == "seams") state.bed_distance = one.values[1] * 10.0;          // on a joint
    if (!effect.form.empty()) state.bed_distance = 7.0, state.penetration = 0.3;  // in the rows, off a wave's zero
    if (effect.id == "tire_loss") state.nose_distance = one.values[1] + 5.0;
    TireChange change;
    if (effect.bed) effect.bed(state, one.values, change);
    if (effect.force) effect.force(state, one.values, change);
    auto a = two_gears();
    auto b = flat_bed();
    Site site{a, b, a.mass, a.cg_behind_nose_gear};
    if (effect.site) effect.site(site, one.values);
    const bool changed = change.strength != 1.0 || change.depth != 1.0 || change.tire_pressure != 1.0 ||
                         change.drag != 0.0 || b.grade != 0.0 || b.depth != flat_bed().depth || a.aero.CD != 0.13 ||
                         a.gears[0].strut.friction != 1e3 || (effect.thrust && effect.thrust(1.0, one.values) != 0.0);
    EXPECT_TRUE(changed);
  }
}

TEST(Effects, FollowTheirLaws) {
  const TireState s = in_the_bed();
  const auto drag_of = [&](const Effect& e, double amplitude) {
    TireChange change;
    e.force(s, applied(e, amplitude).values, change);
    return change.drag;
  };
  EXPECT_DOUBLE_EQ(drag_of(inertial(), 0.3), 0.3 * 320.0 * 0.3 * 0.2 * 25.0 * 25.0);
  EXPECT_DOUBLE_EQ(drag_of(wall_tear(), 5e3), 2.0 * 5e3 * 0.2);
  EXPECT_DOUBLE_EQ(drag_of(rubble_friction(), 0.1), 0.1 * 8e4);
  TireChange change;
  ageing().bed(s, applied(ageing(), 0.03).values, change);
  EXPECT_DOUBLE_EQ(change.strength, 1.0 - 0.03 * 4.0);
  change = {};
  temperature().bed(s, applied(temperature(), 0.004).values, change);
  EXPECT_DOUBLE_EQ(change.strength, 1.0 + 0.004 * 10.0);
}

TEST(Effects, OtherFormsFollowTheirLaws) {
  TireState s = in_the_bed();
  TireChange change;
  const Effect limited = inertial_limited();
  limited.force(s, std::vector{0.3, 0.12}, change);
  EXPECT_DOUBLE_EQ(change.drag, 0.3 * 320.0 * 0.3 * 0.12 * 25.0 * 25.0) << "only the upper 0.12 m";
  const Effect rows = softening_rows();
  for (const auto& [place, wanted] : {std::pair{8.0, 1.0}, {12.0, 0.6}, {20.0, 0.6}, {26.0, 1.0}}) {
    change = {};
    s.bed_distance = place;
    rows.bed(s, std::vector{0.4, 10.0, 15.0}, change);
    EXPECT_DOUBLE_EQ(change.strength, wanted) << place;
  }
  const Effect held = thrust_held();
  EXPECT_DOUBLE_EQ(held.thrust(-1.0, std::vector{1e4, 1.0, 2.0}), 1e4);
  EXPECT_DOUBLE_EQ(held.thrust(2.0, std::vector{1e4, 1.0, 2.0}), 5e3);
  EXPECT_DOUBLE_EQ(held.thrust(4.0, std::vector{1e4, 1.0, 2.0}), 0.0);
  auto a = two_gears();
  auto b = flat_bed();
  Site site{a, b, a.mass, a.cg_behind_nose_gear};
  aero_wind().site(site, std::vector{3.0, -10.0});
  EXPECT_DOUBLE_EQ(a.aero.CD, 0.13 + 3.0 / 50.0);
  EXPECT_DOUBLE_EQ(site.headwind, -5.0);
}

TEST(Effects, StickingStrutsShareTheStaticLoad) {
  auto a = two_gears();
  auto b = flat_bed();
  Site site{a, b, a.mass, a.cg_behind_nose_gear};
  const Effect e = oleo_friction();
  e.site(site, applied(e, 0.05).values);
  const double weight = a.mass * units::g0;
  EXPECT_NEAR(a.gears[0].strut.friction, 1e3 + 0.05 * 0.1 * weight, 1e-6);
  EXPECT_NEAR(a.gears[1].strut.friction, 1e3 + 0.05 * 0.9 * weight / 2.0, 1e-6);
}

TEST(Effects, AnUnknownIdIsRefusedWithTheNearestOne) {
  try {
    find_effect(catalogue(), "seems");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("seams"), std::string::npos);
  }
}

}  // namespace
}  // namespace apc::effects
