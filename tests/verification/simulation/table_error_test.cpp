/// What tabulating costs: the same closed-form ground asked directly in the right-hand side, and through spline tables
/// refined in speed, depth and penetration together.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "tests/support/simulation_models.h"

namespace apc::simulation {
namespace {

/// Strength 50 psi, with as much inertia of the foam as a tenfold of the usual, so that the speed axis matters.
loadtables::CrushBalance law_of(const aircraft::Tire& tire) {
  auto law = testing::crush_law(tire);
  law.inertia = 0.5;
  return law;
}

/// Nodes 3 r + 1, 16 r + 1, 24 r + 1 over speed, depth, penetration; the law's drag is a + b v², asked twice per node.
loadtables::LoadTable tabulated(const aircraft::Tire& tire, int refine) {
  using namespace loadtables;
  const auto law = law_of(tire);
  auto data = std::make_shared<LoadTable::Data>();
  data->tire = table_tire(tire);
  data->provenance.material = "closed form";
  data->penetration = penetration_scale(data->tire);
  data->speed = axis(0.0, 40.0, 3 * refine + 1);
  data->depth = axis(1.0, DepthScale::at(0.6), 16 * refine + 1);
  data->ratio = axis(0.0, 1.2, 24 * refine + 1);
  data->speeds = {0.0, 40.0};
  data->depths = {0.0, 0.6};
  data->ratios = {0.0, 1.2};
  const auto along_speed = interpolation(data->speed, LowerEnd::level);
  const auto along_depth = interpolation(data->depth, LowerEnd::linear);
  const auto along_ratio = interpolation(data->ratio, LowerEnd::linear);
  Eigen::MatrixXd at_rest(data->depth.nodes, data->ratio.nodes), growth = at_rest, vertical = at_rest;
  constexpr double fast = 30.0;  // m/s
  for (int j = 0; j < data->depth.nodes; ++j)
    for (int k = 0; k < data->ratio.nodes; ++k) {
      const double depth = DepthScale::depth(data->depth.node(j));
      const double penetration = data->ratio.node(k) * data->penetration.at(depth);
      const auto slow = law.load({0.0, depth, penetration});
      at_rest(j, k) = slow.drag, vertical(j, k) = slow.vertical;
      growth(j, k) = (law.load({fast, depth, penetration}).drag - slow.drag) / (fast * fast);
    }
  const auto coefficients = [&](const Eigen::MatrixXd& plane) {
    return Eigen::MatrixXd(along_depth * plane * along_ratio.transpose());
  };
  const Eigen::MatrixXd rest = coefficients(at_rest), more = coefficients(growth), up = coefficients(vertical);
  Eigen::VectorXd square(data->speed.nodes);
  for (int i = 0; i < data->speed.nodes; ++i) square[i] = data->speed.node(i) * data->speed.node(i);
  const Eigen::VectorXd by_speed = along_speed * square;  // of v²; of 1 they are all 1
  for (int i = 0; i < data->speed.coefficients(); ++i)
    for (int j = 0; j < data->depth.coefficients(); ++j)
      for (int k = 0; k < data->ratio.coefficients(); ++k)
        data->coefficients.insert(data->coefficients.end(),
                                  {rest(j, k) + by_speed[i] * more(j, k), up(j, k), 0.0, 0.0});
  return LoadTable(std::shared_ptr<const LoadTable::Data>(std::move(data)));
}

/// Wheels that follow the free spin and no brakes: drag and vertical load are all that the ground gives.
Overrun rolling(double knots) {
  Overrun overrun;
  overrun.entry_speed = knots * units::kt;
  overrun.wheel_spin = WheelSpin::free;
  return overrun;
}

/// Adds to each tire what its table lacks of the law: the ground is then the law itself.
effects::Applied law_instead_of(const Model& model) {
  effects::Effect effect;
  effect.id = "law";
  effect.parameters = {{"amplitude", "", dimension::none, 0.0, 1.0, 1.0, 0.0}};
  const auto nose = law_of(model.aircraft.tires.at(model.aircraft.gears[0].tire)),
             main = law_of(model.aircraft.tires.at(model.aircraft.gears[1].tire));
  effect.force = [nose, main, tables = model.tables](const effects::TireState& at, effects::Values,
                                                     effects::TireChange& change) {
    const TireContact contact{at.speed, at.bed_depth, at.penetration};
    const auto exact = (at.nose ? nose : main).load(contact), tabled = tables[at.nose ? 0 : 1].load(contact);
    change.drag += exact.drag - tabled.drag;
    change.vertical += exact.vertical - tabled.vertical;
  };
  return {effect, {1.0}};
}

TEST(TableError, ShrinksWithTheNodesOfAllThreeAxes) {
  const auto plane = testing::shipped_aircraft("B737-800");
  const auto model_with = [&](int refine) {
    std::vector<loadtables::LoadTable> tables;
    for (const auto& gear : plane.gears) tables.push_back(tabulated(plane.tires.at(gear.tire), refine));
    return make_model(plane, testing::foam_bed(0.25), tables);
  };
  Options options;
  options.rtol = 1e-8;
  options.sampling = 0.0;
  const std::array<double, 4> speeds{45.0, 53.0, 61.0, 69.0};
  std::array<double, 4> exact{}, squares{};
  const auto coarse = model_with(1);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    auto overrun = rolling(speeds[i]);
    overrun.alterations.effects.push_back(law_instead_of(coarse));
    const auto result = simulate(coarse, overrun, options);
    exact[i] = result.stop_distance;
    for (const auto& each : result.coverage) EXPECT_EQ(each.penetration_outside, 0.0);  // within the law's table
  }
  std::printf("V10 rms error of the stop against the law itself (%.3f m at %.0f kt), nodes:", exact[3], speeds[3]);
  double slope = 0.0;
  for (std::size_t level = 0; level < squares.size(); ++level) {
    const auto model = model_with(1 << level);
    for (std::size_t i = 0; i < speeds.size(); ++i)
      squares[level] +=
          std::pow(simulate(model, rolling(speeds[i]), options).stop_distance - exact[i], 2) / speeds.size();
    const double error = std::sqrt(squares[level]);
    slope += 0.2 * (1.5 - static_cast<double>(level)) * std::log2(error);
    std::printf("  %dx%dx%d %.3f mm", 3 * (1 << level) + 1, 16 * (1 << level) + 1, 24 * (1 << level) + 1, 1e3 * error);
  }
  std::printf("  slope %.2f\n", slope);
  EXPECT_GE(slope, 1.5);
  EXPECT_LT(std::sqrt(squares[3]), 1e-3);
}

}  // namespace
}  // namespace apc::simulation
