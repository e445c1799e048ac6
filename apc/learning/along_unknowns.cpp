#include "apc/learning/along_unknowns.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/effects/catalogue.h"
#include "apc/simulation/plant.h"

namespace apc::learning {
namespace {

constexpr double step = 0.01, bed_strength_deviation = 0.08;

}  // namespace

AlongPrior along_prior(const Case& data, const Layout& layout) {
  Scatter scatter;
  scatter.strength = data.block_strength, scatter.correlation = data.correlation;
  const Prior base = make_prior(layout, data, data.runs, scatter);
  AlongPrior prior;
  const Eigen::Index n = layout.size + Extra::count;
  prior.precision = Eigen::MatrixXd::Zero(n, n);
  prior.precision.topLeftCorner(layout.size, layout.size) = base.precision;
  prior.log_determinant = base.log_determinant;
  double& strength = prior.precision(layout.bed_strength, layout.bed_strength);
  prior.log_determinant -= std::log(strength) + 2.0 * std::log(bed_strength_deviation);
  strength = 1.0 / (bed_strength_deviation * bed_strength_deviation);
  for (Eigen::Index i = 0; i < Extra::count; ++i) {
    prior.precision(layout.size + i, layout.size + i) = 1.0 / (Extra::deviation[i] * Extra::deviation[i]);
    prior.log_determinant -= 2.0 * std::log(Extra::deviation[i]);
  }
  return prior;
}

AlongPrior with_vertical_error(const AlongPrior& prior, const Layout& layout, double vertical_table) {
  AlongPrior wider = prior;
  for (std::size_t t = 0; t < layout.tables; ++t)
    for (Eigen::Index i = table_numbers / 2; i < table_numbers; ++i) {
      const Eigen::Index at = layout.table + table_numbers * static_cast<Eigen::Index>(t) + i;
      wider.precision(at, at) /= vertical_table * vertical_table;
      wider.log_determinant -= 2.0 * std::log(vertical_table);
    }
  return wider;
}

Eigen::MatrixXd sensitivities(const Case& data, const Layout& layout, const std::vector<GearFacts>& gears,
                              std::size_t r, const AlongRun& along) {
  const Run& run = data.runs[r];
  const RunLayout& at = layout.runs[r];
  const Motion& m = along.motion;
  const Balance& base = along.balance;
  const double entry = run.overrun.entry_speed, mass = run.overrun.mass;
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(along.predicted.size(), layout.size + Extra::count);
  const auto put = [&](Eigen::Index column, const Balance& b, double by, double speed) {
    S.col(column) = (read_off(along.readings, run, m, b, speed) - along.predicted) / by;
  };
  const auto loads = [&](Eigen::Index column, const std::function<LoadChange(std::size_t, std::size_t)>& change) {
    put(column, changed(base, data, gears, run, m, change), step, entry);
  };
  const auto place = [&](std::size_t g, std::size_t i) { return m.place[i] - gears[g].behind; };

  loads(layout.bed_strength, [](std::size_t, std::size_t) { return LoadChange{step, step}; });
  for (Eigen::Index b = 0; b < at.blocks; ++b)
    for (const bool nose : {true, false})
      loads((nose ? at.nose_blocks : at.main_blocks) + b, [&](std::size_t g, std::size_t i) {
        if (gears[g].nose != nose) return LoadChange{};
        const double knot = std::clamp(place(g, i) / layout.spacing, 0.0, static_cast<double>(at.blocks - 1));
        const double part = step * std::max(0.0, 1.0 - std::abs(knot - static_cast<double>(b)));
        return LoadChange{part, part};
      });
  for (std::size_t t = 0; t < layout.tables; ++t)
    for (Eigen::Index q = 0; q < table_numbers; ++q) {
      Eigen::VectorXd number = Eigen::VectorXd::Zero(layout.size);
      const Eigen::Index column = layout.table + table_numbers * static_cast<Eigen::Index>(t) + q;
      number[column] = step;
      const auto errors = overrun_of(data, layout, r, run, number, {}).alterations.table_errors;
      loads(column, [&](std::size_t g, std::size_t i) {
        if (layout.table_of_gear[g] != t) return LoadChange{};
        const double deepest = gears[g].table->maximum_penetration(data.bed.depth_at(place(g, i)));
        const auto e = errors[g].at(m.speed[i], m.penetration[g][i] / std::max(1e-6, deepest));
        return LoadChange{e[0], e[1]};
      });
    }
  loads(layout.size + Extra::drag, [](std::size_t, std::size_t) { return LoadChange{step, 0.0}; });
  const double deepest = data.bed.maximum_depth();
  const auto thin = [&](std::size_t g, std::size_t i) {
    return std::pow(std::max(0.0, 1.0 - data.bed.depth_at(place(g, i)) / deepest), 2);
  };
  loads(layout.size + Extra::thin_drag, [&](std::size_t g, std::size_t i) {
    return LoadChange{step * thin(g, i), 0.0};
  });
  loads(layout.size + Extra::thin_vertical, [&](std::size_t g, std::size_t i) {
    return LoadChange{0.0, step * thin(g, i)};
  });

  const auto edited = [&](Eigen::Index column, double by, const std::function<void(Balance&, Eigen::Index)>& edit) {
    Balance b = base;
    for (Eigen::Index i = 0; i < b.along.size(); ++i) edit(b, i);
    put(column, b, by, entry);
  };
  edited(at.mass, step, [&](Balance& b, Eigen::Index i) {
    b.along[i] /= 1.0 + step, b.pitching[i] /= 1.0 + step;
    b.up[i] = (b.up[i] + units::g0) / (1.0 + step) - units::g0;
  });
  edited(at.inertia, step, [&](Balance& b, Eigen::Index i) { b.pitching[i] /= 1.0 + step; });
  edited(at.cg, step, [&](Balance& b, Eigen::Index i) {
    for (const auto& force : base.force_z)
      b.pitching[i] += step * force[static_cast<std::size_t>(i)] / run.overrun.pitch_inertia;
  });
  S.col(layout.cg) = S.col(at.cg);
  const auto pressure = [&](Eigen::Index i) {
    return 0.5 * simulation::air_density * data.aircraft.aero.area / mass *
           std::pow(m.speed[static_cast<std::size_t>(i)] + run.overrun.headwind, 2);
  };
  edited(layout.drag, step,
         [&](Balance& b, Eigen::Index i) { b.along[i] -= step * pressure(i) * data.aircraft.aero.CD; });
  edited(at.wind, 0.1, [&](Balance& b, Eigen::Index i) {
    const double wind = std::max(1.0, m.speed[static_cast<std::size_t>(i)] + run.overrun.headwind);
    const double more = pressure(i) * 2.0 * 0.1 / wind;
    b.along[i] -= more * data.aircraft.aero.CD, b.up[i] += more * data.aircraft.aero.CL;
  });
  for (const bool inside : {false, true})
    edited(layout.size + (inside ? Extra::rolling : Extra::pavement), 1e-3, [&](Balance& b, Eigen::Index i) {
      const auto k = static_cast<std::size_t>(i);
      for (std::size_t g = 0; g < gears.size(); ++g)
        if ((place(g, k) > 0.0 && data.bed.depth_at(place(g, k)) > (inside ? 0.05 : 1e-4)) == inside)
          b.along[i] -= 1e-3 * base.force_z[g][k] / mass;
    });
  {
    effects::Alterations deeper;
    deeper.conditions = run.conditions;
    deeper.effects = {effects::applied(effects::depth_as_built(), -0.004)};
    put(layout.size + Extra::depth, balance_at_ruts(data, gears, run, m, deeper), -0.004, entry);
  }
  put(at.entry_speed, base, 0.1, entry + 0.1);

  for (std::size_t i = 0; i < along.readings.size(); ++i) {
    const Reading& reading = along.readings[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (reading.is_stop()) continue;
    const std::size_t a = i > 0 && along.readings[i - 1].channel == reading.channel ? i - 1 : i;
    const std::size_t c = i + 1 < along.readings.size() && along.readings[i + 1].channel == reading.channel ? i + 1 : i;
    const double apart = along.readings[c].from - along.readings[a].from;
    const double slope =
        apart > 0.0
            ? (along.predicted[static_cast<Eigen::Index>(c)] - along.predicted[static_cast<Eigen::Index>(a)]) / apart
            : 0.0;
    if (reading.quantity != Quantity::pitch_rate) S(row, at.bias[reading.channel]) = 1.0;
    S(row, at.scale[reading.channel]) = along.predicted[row];
    S(row, at.lag[reading.channel]) = S(row, at.clock) = -slope;
  }
  return S;
}

Eigen::MatrixXd rut_sensitivities(const Case& data, const std::vector<GearFacts>& gears, const Run& run,
                                  const AlongRun& along) {
  constexpr double less = 0.004;
  effects::Alterations plain;
  plain.conditions = run.conditions;
  const auto knots = static_cast<Eigen::Index>(along.motion.place.back() / rut_knots) + 2;
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(along.predicted.size(), knots * static_cast<Eigen::Index>(gears.size()));
  for (std::size_t g = 0; g < gears.size(); ++g) {
    Motion shallower = along.motion;
    for (double& rut : shallower.rut[g]) rut = std::max(0.002, rut - less);
    const Balance moved = balance_at_ruts(data, gears, run, shallower, plain);
    for (Eigen::Index q = 0; q < knots; ++q) {
      Balance b = along.balance;
      bool any = false;
      for (Eigen::Index i = 0; i < b.along.size(); ++i) {
        const double place = (along.motion.place[static_cast<std::size_t>(i)] - gears[g].behind) / rut_knots;
        const double part = std::max(0.0, 1.0 - std::abs(place - static_cast<double>(q)));
        if (part <= 0.0) continue;
        any = true;
        b.along[i] += part * (moved.along[i] - along.balance.along[i]);
        b.up[i] += part * (moved.up[i] - along.balance.up[i]);
        b.pitching[i] += part * (moved.pitching[i] - along.balance.pitching[i]);
      }
      if (any)
        B.col(static_cast<Eigen::Index>(g) * knots + q) =
            (read_off(along.readings, run, along.motion, b, run.overrun.entry_speed) - along.predicted) / -less;
    }
  }
  return B;
}

}  // namespace apc::learning
