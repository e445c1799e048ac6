#include "apc/design/certificate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace apc::design {
namespace {

/// Least squares on the chosen columns by normal equations, slightly regularised: few columns, well scaled.
Eigen::VectorXd solve_on(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const std::vector<Eigen::Index>& columns) {
  Eigen::MatrixXd part(A.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) part.col(static_cast<Eigen::Index>(i)) = A.col(columns[i]);
  Eigen::MatrixXd normal = part.transpose() * part;
  normal.diagonal().array() += 1e-10 * (1.0 + normal.diagonal().maxCoeff());
  return normal.ldlt().solve(part.transpose() * b);
}

}  // namespace

bool certified(const Certificate& certificate) { return certificate.agreed && certificate.stationarity <= 0.05; }

Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  std::vector<Eigen::Index> chosen;
  const double enough = 1e-9 * (1.0 + (A.transpose() * b).cwiseAbs().maxCoeff());
  for (Eigen::Index round = 0; round < 3 * A.cols() + 3; ++round) {
    const Eigen::VectorXd pull = A.transpose() * (b - A * x);
    Eigen::Index best = -1;
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      if (std::find(chosen.begin(), chosen.end(), j) == chosen.end() && pull[j] > enough &&
          (best < 0 || pull[j] > pull[best]))
        best = j;
    if (best < 0) break;
    chosen.push_back(best);
    for (;;) {
      const auto trial = solve_on(A, b, chosen);
      double step = 1.0;  // how far towards `trial` until a component reaches 0
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        const double now = x[chosen[i]], then = trial[static_cast<Eigen::Index>(i)];
        if (then <= 0 && now - then > 0) step = std::min(step, now / (now - then));
      }
      for (std::size_t i = 0; i < chosen.size(); ++i)
        x[chosen[i]] += step * (trial[static_cast<Eigen::Index>(i)] - x[chosen[i]]);
      if (step >= 1.0) break;
      std::erase_if(chosen, [&](Eigen::Index j) { return x[j] <= 1e-14; });
      if (chosen.empty()) break;
    }
  }
  return x.cwiseMax(0.0);
}

namespace {

/// Constraints (rows of the Jacobian) and bounds that are met with equality, as outward normals.
struct Contact {
  Eigen::VectorXd normal;
  Constraint constraint;
  double use = 0.0;
  Eigen::Index row = 0;  // of the Jacobian; 0 = a bound
};

std::vector<Contact> contacts(const Program& program, const Eigen::VectorXd& z, const Eigen::VectorXd& values,
                              const Eigen::MatrixXd& slopes, const Eigen::MatrixXd& others, double near) {
  std::vector<Contact> out;
  for (std::size_t i = 0; i < program.constraints.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i) + 1;
    if (values[row] < -near) continue;
    // A peak that two places share has no gradient; those places are in the programme for themselves.
    const double kink = (slopes.row(row) - others.row(row)).cwiseAbs().maxCoeff();
    if (kink > 0.02 * slopes.row(row).cwiseAbs().maxCoeff() && program.constraints[i].window >= 0) continue;
    out.push_back({slopes.row(row).transpose(), program.constraints[i], 1.0 + values[row], row});
  }
  for (Eigen::Index j = 0; j < z.size(); ++j)
    for (const double side : {-1.0, 1.0}) {
      const double gap = side < 0 ? z[j] - program.low[j] : program.high[j] - z[j];
      if (gap > near) continue;
      Contact contact{Eigen::VectorXd::Zero(z.size()), {}, 1.0, 0};
      contact.normal[j] = side;
      contact.constraint.kind = Kind::bound;
      contact.constraint.what =
          std::string(side < 0 ? "smallest" : "largest") + " allowed value of variable " + std::to_string(j + 1);
      out.push_back(contact);
    }
  return out;
}

}  // namespace

void examine(const Program& program, const Eigen::VectorXd& z, const OptimiserOptions& options,
             Certificate& certificate) {
  const auto values = program.at(z);
  const auto forward = jacobian(program, z, options.step, Differences::forward);
  const auto central = jacobian(program, z, 2 * options.step, Differences::central);
  const auto touching = contacts(program, z, values, central, forward, 2e-3);
  Eigen::MatrixXd normals(z.size(), static_cast<Eigen::Index>(touching.size()));
  for (std::size_t i = 0; i < touching.size(); ++i) normals.col(static_cast<Eigen::Index>(i)) = touching[i].normal;
  const Eigen::VectorXd descent = -central.row(0).transpose();
  const Eigen::VectorXd multipliers = non_negative_least_squares(normals, descent);
  certificate.stationarity = (descent - normals * multipliers).norm() / std::max(descent.norm(), 1e-30);

  // Gradients that matter: of the objective and of the constraints that pull.
  double error = (forward.row(0) - central.row(0)).cwiseAbs().maxCoeff(), scale = central.row(0).cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < touching.size(); ++i) {
    if (touching[i].row == 0 || multipliers[static_cast<Eigen::Index>(i)] <= 0) continue;
    error = std::max(error, (forward.row(touching[i].row) - central.row(touching[i].row)).cwiseAbs().maxCoeff());
    scale = std::max(scale, central.row(touching[i].row).cwiseAbs().maxCoeff());
  }
  certificate.gradient_error = error / std::max(scale, 1e-30);

  double slack = 0.0;
  for (std::size_t i = 0; i < touching.size(); ++i)
    slack += multipliers[static_cast<Eigen::Index>(i)] * std::abs(touching[i].use - 1.0);
  certificate.gap = slack / std::max(std::abs(values[0]), 1e-30);
  double total = 0.0;  // of constraints; bounds of variables are not what a designer can bargain about
  for (std::size_t i = 0; i < touching.size(); ++i)
    if (touching[i].constraint.kind != Kind::bound) total += multipliers[static_cast<Eigen::Index>(i)];
  certificate.active.clear();
  for (std::size_t i = 0; i < touching.size(); ++i) {
    const double multiplier = multipliers[static_cast<Eigen::Index>(i)];
    if (multiplier > 1e-3 * total)
      certificate.active.push_back({touching[i].constraint, touching[i].use, multiplier, multiplier / total});
  }
  std::stable_sort(certificate.active.begin(), certificate.active.end(),
                   [](const Active& a, const Active& b) { return a.weight > b.weight; });
}

}  // namespace apc::design
