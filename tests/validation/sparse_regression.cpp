#include "sparse_regression.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/effects/catalogue.h"
#include "apc/learning/shapes.h"

namespace scoring {
namespace {

using namespace apc;
using namespace apc::learning;
using effects::Applied;

/// Speed, its slope and the place of the nose wheel from the speed record alone: straight lines over ± 0.25 s.
struct Point {
  double time = 0.0, place = 0.0, speed = 0.0, slope = 0.0;
};

std::vector<Point> differentiated(const Run& run) {
  std::vector<Point> list;
  const Channel* c = run.find(Quantity::speed);
  if (!c) return list;
  double place = 0.0;
  for (std::size_t i = 1; i < c->time.size(); ++i) {
    if (c->time[i] <= 0.0) continue;
    place += 0.5 * (c->value[i] + c->value[i - 1]) * (c->time[i] - std::max(0.0, c->time[i - 1]));
    double n = 0.0, t = 0.0, v = 0.0, tt = 0.0, tv = 0.0;
    for (std::size_t k = 0; k < c->time.size(); ++k) {
      const double d = c->time[k] - c->time[i];
      if (std::abs(d) <= 0.25) n += 1.0, t += d, v += c->value[k], tt += d * d, tv += d * c->value[k];
    }
    const double spread = n * tt - t * t;
    if (n < 3.0 || spread <= 0.0 || c->value[i] < 4.0) continue;
    list.push_back({c->time[i], place, (v * tt - t * tv) / spread, (n * tv - t * v) / spread});
  }
  return list;
}

}  // namespace

std::vector<std::pair<Applied, double>> sparse_regression(const Background& b) {
  const Case& data = *b.data;
  std::vector<Applied> terms;
  for (const char* id : {"inertial", "wall_tear", "adhesion", "rubble_friction", "debris", "cover", "slope", "aero",
                         "thrust", "softening", "rate"})
    terms.push_back(effects::applied(effects::find_effect(effects::catalogue(), id),
                                     effects::find_effect(effects::catalogue(), id).parameters.front().usual));
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> lacking;
  for (std::size_t r = 0; r < b.training; ++r) {
    const simulation::History& h = b.traces[r].result.history;
    for (const Point& p : differentiated(b.runs[r])) {
      const auto i = static_cast<std::size_t>(std::lower_bound(h.distance.begin(), h.distance.end(), p.place) -
                                              h.distance.begin());
      if (i + 1 >= h.time.size()) continue;
      // Force each term adds at its usual size, at the model's penetration and the measured speed.
      Eigen::VectorXd row(static_cast<Eigen::Index>(terms.size()));
      const double mass = b.runs[r].overrun.mass;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Applied& term = terms[k];
        double force = 0.0;
        for (std::size_t g = 0; g < data.aircraft.gears.size(); ++g) {
          const aircraft::Gear& gear = data.aircraft.gears[g];
          const aircraft::Tire& tire = data.aircraft.tires.at(gear.tire);
          const double density = data.bed.nominal ? data.bed.nominal->density : 320.0;
          effects::Alterations plain, with;
          with.effects = {term};
          const effects::TireFacts facts{g, gear.is_nose(), gear.wheels(), tire.width, tire.radius(), density};
          const effects::TirePlace place{{p.speed, h.gears[g].bed_depth[i], h.gears[g].penetration[i]},
                                         h.gears[g].distance[i],
                                         h.distance[i],
                                         p.time};
          if (term.effect.bed || term.effect.force)
            force += gear.wheels() * (effects::load(data.tables[g], with, facts, place).drag -
                                      effects::load(data.tables[g], plain, facts, place).drag);
        }
        if (term.effect.thrust) force -= term.effect.thrust(p.time, term.values);
        if (term.effect.id == "slope") force += mass * units::g0 * term.values.front();
        if (term.effect.id == "aero") force += 0.5 * 1.225 * term.values.front() * p.speed * p.speed;
        row[static_cast<Eigen::Index>(k)] = force / mass;
      }
      rows.push_back(row);
      lacking.push_back(-p.slope - h.deceleration[i]);
    }
  }
  if (rows.size() < 20) return {};
  Eigen::MatrixXd X(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(terms.size()));
  Eigen::VectorXd y(X.rows());
  for (Eigen::Index i = 0; i < X.rows(); ++i)
    X.row(i) = rows[static_cast<std::size_t>(i)], y[i] = lacking[static_cast<std::size_t>(i)];
  // Sequentially thresholded: coefficients are in usual sizes; below a fifth of one a term goes.
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < terms.size(); ++k) kept.push_back(k);
  Eigen::VectorXd coefficient;
  for (int round = 0; round < 10 && !kept.empty(); ++round) {
    Eigen::MatrixXd K(X.rows(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t k = 0; k < kept.size(); ++k)
      K.col(static_cast<Eigen::Index>(k)) = X.col(static_cast<Eigen::Index>(kept[k]));
    coefficient =
        (K.transpose() * K + 1e-3 * Eigen::MatrixXd::Identity(K.cols(), K.cols())).ldlt().solve(K.transpose() * y);
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const effects::Parameter& p = terms[kept[k]].effect.parameters.front();
      const double size = coefficient[static_cast<Eigen::Index>(k)];
      if (std::abs(size) > 0.2 && (size > 0.0 || !amplitude_positive(p))) left.push_back(kept[k]);
    }
    if (left.size() == kept.size()) break;
    kept = left;
  }
  std::vector<std::pair<Applied, double>> list;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    Applied one = terms[kept[k]];
    const effects::Parameter& p = one.effect.parameters.front();
    one.values.front() = std::clamp(coefficient[static_cast<Eigen::Index>(k)] * p.usual, p.low, p.high);
    list.emplace_back(one, 0.9);
  }
  // The two that move the force most.
  const auto weight = [&](const Applied& a) {
    for (std::size_t k = 0; k < terms.size(); ++k)
      if (terms[k].effect.id == a.effect.id)
        return std::abs(a.values.front() / a.effect.parameters.front().usual) *
               X.col(static_cast<Eigen::Index>(k)).norm();
    return 0.0;
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const auto& x, const auto& z) { return weight(x.first) > weight(z.first); });
  if (list.size() > 2) list.resize(2);
  return list;
}

}  // namespace scoring
