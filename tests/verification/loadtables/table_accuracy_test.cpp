/// How well a table predicts where it has no sample: against a known function, as samples are added, and against the
/// error it states itself.
#include <gtest/gtest.h>

#include <cmath>

#include "apc/base/units.h"
#include "loadtables/bspline.h"
#include "loadtables/check_table.h"
#include "loadtables/load_table_data.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

struct Errors {
  double drag = 0.0, vertical = 0.0, rut = 0.0;
};

/// Rms error at 500 contacts between the samples, relative to the mean.
Errors unseen_errors(const LoadTable& table) {
  PlanOptions options;
  options.runs = 500;
  options.seed = 99;
  options.depth_increment = 0.0;
  Errors squares, means;
  const auto runs = make_plan(synthetic::tire(), "foam", options).runs;
  for (const auto& run : runs) {
    const auto truth = synthetic::truth(run.contact), found = table.load(run.contact);
    squares.drag += std::pow(found.drag - truth.drag, 2), means.drag += truth.drag;
    squares.vertical += std::pow(found.vertical - truth.vertical, 2), means.vertical += truth.vertical;
    squares.rut += std::pow(found.rut_depth - truth.rut_depth, 2), means.rut += truth.rut_depth;
  }
  const double count = static_cast<double>(runs.size());
  return {std::sqrt(squares.drag * count) / means.drag, std::sqrt(squares.vertical * count) / means.vertical,
          std::sqrt(squares.rut * count) / means.rut};
}

TEST(TableAccuracy, PredictsAKnownFunctionBetweenItsSamples) {
  const auto errors = unseen_errors(fit(synthetic::samples(70), synthetic::tire(), {}));
  EXPECT_LT(errors.drag, 0.03);
  EXPECT_LT(errors.vertical, 0.10);
  EXPECT_LT(errors.rut, 0.03);
}

TEST(TableAccuracy, ImprovesWithSamples) {
  const auto few = unseen_errors(fit(synthetic::samples(40), synthetic::tire(), {})),
             many = unseen_errors(fit(synthetic::samples(300), synthetic::tire(), {}));
  EXPECT_LT(many.drag, 0.7 * few.drag);
  EXPECT_LT(many.vertical, 0.7 * few.vertical);
}

TEST(TableAccuracy, StatesAboutTheErrorItMakes) {
  const auto table = fit(synthetic::samples(70), synthetic::tire(), {});
  const auto errors = unseen_errors(table);
  for (const auto& quality : table.quality()) {
    if (quality.response == "drag") {
      EXPECT_GT(quality.loo_rms_relative, errors.drag / 3.0);
    }
    if (quality.response == "vertical") {
      EXPECT_GT(quality.loo_rms_relative, errors.vertical / 3.0);
    }
  }
}

TEST(TableAccuracy, SplineConvergesWithTheFourthPowerOfItsStep) {
  const auto error = [](int nodes) {
    const auto grid = axis(0.0, 4.0, nodes);
    Eigen::VectorXd values(nodes);
    for (int i = 0; i < nodes; ++i) values(i) = std::sin(3.0 * grid.node(i));
    const Eigen::VectorXd c = interpolation(grid, LowerEnd::linear) * values;
    double worst = 0.0;
    for (double x = 1.5; x < 2.5; x += 0.003) {  // away from the ends, where the second derivative is set to 0
      const auto w = weights(grid, x);
      double sum = 0.0;
      for (int k = 0; k < 4; ++k) sum += w.value[k] * c(w.first + k);
      worst = std::max(worst, std::abs(sum - std::sin(3.0 * x)));
    }
    return worst;
  };
  const double order = std::log2(error(41) / error(81));
  EXPECT_NEAR(order, 4.0, 0.3);
}

TEST(TableAccuracy, IsTwiceContinuouslyDifferentiableAcrossKnots) {
  const auto table = synthetic::table();
  const auto& data = table.data();
  const double depth = 0.4, scale = table.maximum_penetration(depth), step = 1e-6;
  const auto bend = [&](double ratio) {
    const auto slope = [&](double r) { return table.load_with_slopes({20.0, depth, r * scale}).vertical.penetration; };
    return (slope(ratio + step) - slope(ratio - step)) / (2.0 * step);
  };
  double largest = 0.0;
  for (int k = 2; k < data.ratio.nodes; ++k) largest = std::max(largest, std::abs(bend(data.ratio.node(k))));
  // At P_max, ratio 1, the tire takes over with the table's slope, but not with its bend.
  for (int k = 1; data.ratio.node(k) < 1.0 - 1e-9; ++k) {
    const double knot = data.ratio.node(k);
    EXPECT_NEAR(bend(knot - 3.0 * step), bend(knot + 3.0 * step), 2e-3 * largest) << "knot " << k;
  }
}

TEST(ShippedTables, HoldWhatATableMustHold) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PROJECT_DIR) / "loadtables/data")) {
    if (entry.path().extension() != ".h5") continue;
    const auto table = load_table(entry.path());
    const auto check = check_table(table);
    for (const auto& failure : check.failures) ADD_FAILURE() << entry.path() << ": " << failure;
    EXPECT_FALSE(table.provenance().source.empty());
    EXPECT_FALSE(table.provenance().command.empty());
    EXPECT_EQ(entry.path().filename().string(), table.tire().name + "_" + table.provenance().material + ".h5");
    for (const auto& quality : table.quality()) EXPECT_GT(quality.r2, 0.9) << entry.path() << " " << quality.response;
    ++count;
  }
  EXPECT_EQ(count, 7u);
}

/// Where a wheel just crushes foam, drag is the crushing work per length of travel: strength × width × rut, and the
/// published wheel runs exceed that by a factor of 1.2 to 1.7 for edge shear, friction and inertia.
TEST(ShippedTables, DragIsNearTheWorkOfCrushing) {
  const double strength = 50.0 * units::psi;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PROJECT_DIR) / "loadtables/data")) {
    if (entry.path().extension() != ".h5") continue;
    const auto table = load_table(entry.path());
    const double depth = 18.0 * units::in;
    for (const double share : {0.3, 0.5}) {  // of the radius: a wheel that rides, not one that ploughs
      const auto load = table.load({50.0 * units::kt, depth, share * 0.5 * table.tire().diameter});
      const double crushing = strength * table.tire().width * load.rut_depth;
      EXPECT_GT(load.drag, 0.9 * crushing) << entry.path() << " " << share;
      EXPECT_LT(load.drag, 2.2 * crushing) << entry.path() << " " << share;
    }
  }
}

}  // namespace
}  // namespace apc::loadtables
