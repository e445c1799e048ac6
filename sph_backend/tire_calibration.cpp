#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "apc/base/parallel.h"
#include "apc/base/require.h"
#include "sph_backend/tire.h"

namespace apc::sph {
namespace {

/// Nodes that the plane may touch: rows `first` to `last` around, and how far the plane pushes each.
struct Obstacle {
  int rows;                    // to either side of the lowest node
  std::vector<double> push;    // smallest admissible u, per node (rows 2·rows + 1)
  std::vector<double> cosine;  // per row
};

Obstacle plane_obstacle(const Tire& tire, double deflection, double phase) {
  const double dphi = 2.0 * std::numbers::pi / tire.grid.around, height = 0.5 * tire.shape.diameter - deflection;
  Obstacle o;
  o.rows = tire.grid.around / 4 - 1;
  for (int i = -o.rows; i <= o.rows; ++i) {
    o.cosine.push_back(std::cos((i + phase) * dphi));
    for (int j = 0; j <= tire.grid.across; ++j) o.push.push_back(tire.ring_radius[j] - height / o.cosine.back());
  }
  return o;
}

}  // namespace

double press_on_plane(Tire& tire, double deflection, double phase) {
  const Obstacle o = plane_obstacle(tire, deflection, phase);
  const int across = tire.grid.across, rows = 2 * o.rows + 1;
  const auto wrap = [&](int row) { return (row - o.rows + 2 * tire.grid.around) % tire.grid.around; };
  const auto at = [&](int row, int j) -> double& { return tire.u[tire.node(wrap(row), j)]; };
  const auto residual = [&](int row, int j, double u) {  // elastic force on the node at deflection u
    double f = -tire.area[j] * (u > 0.0 ? tire.foundation(u) : -tire.foundation(-u));
    f += tire.hoop[j] * ((row > 0 ? at(row - 1, j) : 0.0) + (row + 1 < rows ? at(row + 1, j) : 0.0) - 2.0 * u);
    f += tire.meridian[j] * (at(row, j + 1) - u);
    if (j > 0) f += tire.meridian[j - 1] * (at(row, j - 1) - u);
    return f;
  };
  // Projected successive over-relaxation, one Newton step per visit.
  const double over = 1.6, small = 1e-7 * tire.shape.rated_deflection;
  double change = 1.0;
  for (int sweep = 0; sweep < 4000 && change > small; ++sweep) {
    change = 0.0;
    for (int row = 0; row < rows; ++row)
      for (int j = 0; j < across; ++j) {
        double& u = at(row, j);
        const double slope = tire.area[j] * std::max(0.0, tire.foundation.slope(std::abs(u))) + 2.0 * tire.hoop[j] +
                             tire.meridian[j] + (j > 0 ? tire.meridian[j - 1] : 0.0);
        const double next = std::max(u + over * residual(row, j, u) / slope, o.push[row * (across + 1) + j]);
        change = std::max(change, std::abs(next - u));
        u = next;
      }
  }
  // The plane pushes vertically: the radial reaction λ on a node is its vertical force times the cosine.
  double load = 0.0;
  for (int row = 0; row < rows; ++row)
    for (int j = 0; j < across; ++j)
      if (at(row, j) <= o.push[row * (across + 1) + j] + 1e-12) load -= residual(row, j, at(row, j)) / o.cosine[row];
  return 2.0 * load;
}

void calibrate_foundation(Tire& tire, unsigned threads) {
  // Inverting F(δ) for q(u) knot by knot is an Abel-type problem: exact and ragged. A smooth q is wanted that meets the
  // rated and the bottoming point: least squares over deflections with those two weighted, and a small price on kinks.
  // Below 0.08 of the bottoming deflection the catalogue says nothing and the patch is smaller than the grid.
  const double end = tire.shape.bottoming_deflection, p = tire.shape.inflation;
  const double rated = tire.shape.rated_deflection / end;
  const std::vector<double> knots{0.0, 0.04, 0.12, 0.25, 0.4, 0.6, 0.8, 1.0, 1.3};
  const std::vector<double> places{0.08, 0.15, 0.25, 0.33, rated, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
  const int unknowns = static_cast<int>(knots.size()) - 1, points = static_cast<int>(places.size());
  std::vector<double> x;
  for (const double k : knots) x.push_back(k * end);
  Eigen::VectorXd q = Eigen::VectorXd::Constant(unknowns, 0.2);  // in inflation pressures

  const auto misfit = [&](Tire& trial, const Eigen::VectorXd& values) {
    std::vector<double> y{0.0};
    for (int k = 0; k < unknowns; ++k) y.push_back(values[k] * p);
    trial.foundation = LinearCurve(x, y);
    Eigen::VectorXd r(points + unknowns - 1);
    std::fill(trial.u.begin(), trial.u.end(), 0.0);
    for (int m = 0; m < points; ++m) {
      const double u = places[m] * end, load = 0.5 * (press_on_plane(trial, u, 0.0) + press_on_plane(trial, u, 0.5));
      const bool catalogue_point = places[m] == rated || places[m] == 1.0;
      r[m] = (load / catalogue_load(tire.shape, u) - 1.0) * (catalogue_point ? 100.0 : 1.0);
    }
    for (int k = 1; k < unknowns; ++k) {
      const double left = (values[k - 1] - (k > 1 ? values[k - 2] : 0.0)) / (knots[k] - knots[k - 1]);
      const double right = (values[k] - values[k - 1]) / (knots[k + 1] - knots[k]);
      r[points + k - 1] = 0.02 * (right - left);
    }
    return r;
  };
  for (int iteration = 0; iteration < 8; ++iteration) {
    // Column 0: the misfit itself; column 1 + k: with knot k moved.
    Eigen::MatrixXd columns(points + unknowns - 1, 1 + unknowns);
    parallel_for(static_cast<std::size_t>(1 + unknowns), threads, [&](std::size_t k) {
      Tire trial = tire;
      Eigen::VectorXd moved = q;
      if (k > 0) moved[static_cast<Eigen::Index>(k) - 1] += 0.01;
      columns.col(static_cast<Eigen::Index>(k)) = misfit(trial, moved);
    });
    const Eigen::VectorXd r = columns.col(0);
    const Eigen::MatrixXd jacobian = (columns.rightCols(unknowns).colwise() - r) / 0.01;
    const Eigen::VectorXd step = jacobian.colPivHouseholderQr().solve(-r);
    q += step;
    if (step.cwiseAbs().maxCoeff() < 1e-5) break;
  }
  const Eigen::VectorXd left = misfit(tire, q);
  for (int m = 0; m < points; ++m) {
    const double wanted = places[m] == rated || places[m] == 1.0 ? 0.5 : 0.10;  // weighted: 0.5 % at the two points
    require(std::abs(left[m]) < wanted, "tire ", tire.shape.name,
            ": the membrane model cannot follow its catalogue curve (", 100.0 * left[m], " % at ", places[m] * end,
            " m). Check rated and bottoming load and deflection.");
  }
  std::fill(tire.u.begin(), tire.u.end(), 0.0);
}

}  // namespace apc::sph
