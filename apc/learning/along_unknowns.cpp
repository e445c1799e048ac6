#include "apc/learning/along_unknowns.h"

#include <algorithm>
#include <cmath>

#include "apc/base/units.h"
#include "apc/effects/other_forms.h"
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

Eigen::VectorXd bed_unknowns(const Layout& layout) {
  Eigen::VectorXd mask = Eigen::VectorXd::Zero(layout.size + Extra::count);
  mask[layout.bed_strength] = mask[layout.size + Extra::depth] = 1.0;
  mask[layout.sinking] = mask[layout.size + Extra::stiffening] = mask[layout.size + Extra::swing_nose] =
      mask[layout.size + Extra::swing_main] = 1.0;
  mask.segment(layout.table, table_numbers * static_cast<Eigen::Index>(layout.tables)).setOnes();
  for (const RunLayout& run : layout.runs)
    mask.segment(run.nose_blocks, run.blocks).setOnes(), mask.segment(run.main_blocks, run.blocks).setOnes();
  return mask;
}

namespace {

Eigen::MatrixXd sensitivities(const Case& data, const Layout& layout, const std::vector<GearFacts>& gears,
                              std::size_t r, const AlongRun& along) {
  const Run& run = data.runs[r];
  const RunLayout& at = layout.runs[r];
  const Motion& m = along.motion;
  const Balance& base = along.response.base;
  const double entry = run.overrun.entry_speed, mass = run.overrun.mass;
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(along.predicted.size(), layout.size + Extra::count);
  const auto put = [&](Eigen::Index column, const Balance& b, double by, double speed) {
    S.col(column) = (read_off(along.readings, gears, run, m, b, speed) - along.predicted) / by;
  };
  const auto loads = [&](Eigen::Index column, const std::function<LoadChange(std::size_t, std::size_t)>& change) {
    put(column, along.response.to(data, gears, run, m, change), step, entry);
  };
  const auto place = [&](std::size_t g, std::size_t i) { return m.place[i] - gears[g].behind; };

  loads(layout.bed_strength, [](std::size_t, std::size_t) { return LoadChange{0.0, 0.0, step}; });
  for (Eigen::Index b = 0; b < at.blocks; ++b)
    for (const bool nose : {true, false})
      loads((nose ? at.nose_blocks : at.main_blocks) + b, [&](std::size_t g, std::size_t i) {
        if (gears[g].nose != nose) return LoadChange{};
        const double knot = std::clamp(place(g, i) / layout.spacing, 0.0, static_cast<double>(at.blocks - 1));
        return LoadChange{0.0, 0.0, step * std::max(0.0, 1.0 - std::abs(knot - static_cast<double>(b)))};
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
        const auto e = errors[g].at(m.speed[i], base.penetration[g][i] / std::max(1e-6, deepest));
        return LoadChange{e[0], e[1]};
      });
    }
  loads(layout.size + Extra::drag, [](std::size_t, std::size_t) { return LoadChange{step}; });
  const double deepest = data.bed.maximum_depth();
  const auto thin = [&](std::size_t g, std::size_t i) {
    return std::pow(std::max(0.0, 1.0 - data.bed.depth_at(place(g, i)) / deepest), 2);
  };
  loads(layout.size + Extra::thin_drag, [&](std::size_t g, std::size_t i) { return LoadChange{step * thin(g, i)}; });
  loads(layout.size + Extra::thin_vertical, [&](std::size_t g, std::size_t i) {
    return LoadChange{0.0, step * thin(g, i)};
  });

  // What changes the loads that the measured accelerations ask for.
  const PerGear measured = carried_loads(data, gears, run, m, false);
  const auto carrying = [&](Eigen::Index column, double by, const Run& other, double bias) {
    const PerGear carried = carried_loads(data, gears, other, m, false, bias);
    Balance b = along.response.to(data, gears, run, m, [&](std::size_t g, std::size_t i) {
      return LoadChange{0.0, 0.0, 0.0, carried[g][i] / measured[g][i] - 1.0};
    });
    b.along *= mass / other.overrun.mass;
    put(column, b, by, entry);
  };
  Run other = run;
  other.overrun.mass *= 1.0 + step, other.overrun.pitch_inertia *= run.mass_known ? 1.0 : 1.0 + step;
  carrying(at.mass, step, other, 0.0);
  other.overrun = run.overrun, other.overrun.pitch_inertia *= 1.0 + step;
  carrying(at.inertia, step, other, 0.0);
  other.overrun = run.overrun, other.overrun.cg_behind_nose_gear += step;
  carrying(at.cg, step, other, 0.0);
  S.col(layout.cg) = S.col(at.cg);
  for (std::size_t c = 0; c < run.channels.size(); ++c)
    if (run.channels[c].quantity == Quantity::acceleration_z && run.find(Quantity::pitch_rate))
      carrying(at.bias[c], 0.1, run, 0.1);

  loads(layout.sinking, [&](std::size_t g, std::size_t i) {
    return LoadChange{0.0, step / m.sinking * along.response.sinking[g][i]};
  });
  // The swing of the load is felt through springs: the axle's own mass and the smoothing keep part of it from the tire.
  for (const bool nose : {true, false})
    loads(layout.size + (nose ? Extra::swing_nose : Extra::swing_main), [&](std::size_t g, std::size_t i) {
      return LoadChange{0.0, 0.0, 0.0, gears[g].nose == nose ? step * m.swing[g][i] / m.carried[g][i] : 0.0};
    });

  const auto edited = [&](Eigen::Index column, double by, const std::function<void(Balance&, Eigen::Index)>& edit) {
    Balance b = base;
    for (Eigen::Index i = 0; i < b.along.size(); ++i) edit(b, i);
    put(column, b, by, entry);
  };
  const auto pressure = [&](Eigen::Index i, double wind) {
    return 0.5 * simulation::air_density * data.aircraft.aero.area * data.aircraft.aero.CD / mass *
           std::pow(m.speed[static_cast<std::size_t>(i)] + run.overrun.headwind + wind, 2);
  };
  edited(layout.drag, step, [&](Balance& b, Eigen::Index i) { b.along[i] -= step * pressure(i, 0.0); });
  edited(at.wind, 0.1, [&](Balance& b, Eigen::Index i) { b.along[i] -= pressure(i, 0.1) - pressure(i, 0.0); });
  for (const bool inside : {false, true})
    edited(layout.size + (inside ? Extra::rolling : Extra::pavement), 1e-3, [&](Balance& b, Eigen::Index i) {
      const auto k = static_cast<std::size_t>(i);
      for (std::size_t g = 0; g < gears.size(); ++g)
        if ((place(g, k) > 0.0 && data.bed.depth_at(place(g, k)) > (inside ? 0.05 : 1e-4)) == inside)
          b.along[i] -= 1e-3 * m.carried[g][k] / mass;
    });
  const auto altered = [&](Eigen::Index column, const effects::Effect& effect, double amplitude) {
    effects::Alterations with = along.here;
    with.effects.push_back(effects::applied(effect, amplitude));
    put(column, balance_at_loads(data, gears, run, m, with), amplitude, entry);
  };
  altered(layout.size + Extra::depth, effects::depth_as_built(), -0.004);
  altered(layout.size + Extra::stiffening, effects::lock_up_gradual(), 0.1);
  altered(layout.size + Extra::rate, effects::rate(), 0.02);
  put(at.entry_speed, base, 0.1, entry + 0.1);

  for (std::size_t i = 0; i < along.readings.size(); ++i) {
    const Reading& reading = along.readings[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (reading.kind != Reading::Kind::signal) continue;
    const auto same = [&](std::size_t j) {
      return along.readings[j].kind == Reading::Kind::signal && along.readings[j].channel == reading.channel;
    };
    const std::size_t a = i > 0 && same(i - 1) ? i - 1 : i,
                      c = i + 1 < along.readings.size() && same(i + 1) ? i + 1 : i;
    const double apart = along.readings[c].from - along.readings[a].from;
    const double slope =
        apart > 0.0
            ? (along.predicted[static_cast<Eigen::Index>(c)] - along.predicted[static_cast<Eigen::Index>(a)]) / apart
            : 0.0;
    S(row, at.bias[reading.channel]) = 1.0;
    S(row, at.scale[reading.channel]) = along.predicted[row];
    S(row, at.lag[reading.channel]) = S(row, at.clock) = -slope;
  }
  return S;
}

/// By the share of load that each gear carries, at knots in time.
std::vector<Eigen::MatrixXd> carried_sensitivities(const Case& data, const std::vector<GearFacts>& gears,
                                                   const Run& run, const AlongRun& along) {
  const Motion& m = along.motion;
  const auto knots = std::max<Eigen::Index>(2, static_cast<Eigen::Index>(m.time.back() / noise_knots) + 1);
  std::vector<Eigen::MatrixXd> list(gears.size(), Eigen::MatrixXd::Zero(along.predicted.size(), knots));
  for (std::size_t gear = 0; gear < gears.size(); ++gear)
    for (Eigen::Index q = 0; q < knots; ++q) {
      const Balance b = along.response.to(data, gears, run, m, [&](std::size_t g, std::size_t i) {
        const double apart = std::abs(m.time[i] / noise_knots - static_cast<double>(q));
        return LoadChange{0.0, 0.0, 0.0, g == gear ? step * std::max(0.0, 1.0 - apart) : 0.0};
      });
      list[gear].col(q) =
          (read_off(along.readings, gears, run, m, b, run.overrun.entry_speed) - along.predicted) / step;
    }
  return list;
}

}  // namespace

void linearise_at(const Case& data, const Layout& layout, const std::vector<GearFacts>& gears, std::size_t r,
                  const Eigen::VectorXd& bed, AlongRun& a) {
  const Run& run = data.runs[r];
  a.motion.sinking = std::max(0.2, expected_sinking + bed[layout.sinking]);
  a.here = overrun_of(data, layout, r, run, bed, {}).alterations;
  const auto add = [&](Eigen::Index column, const effects::Effect& effect) {
    if (bed[column] != 0.0) a.here.effects.push_back(effects::applied(effect, bed[column]));
  };
  add(layout.size + Extra::depth, effects::depth_as_built());
  add(layout.size + Extra::stiffening, effects::lock_up_gradual());
  a.response = response_at_loads(data, gears, run, a.motion, a.here);
  a.predicted = read_off(a.readings, gears, run, a.motion, a.response.base, run.overrun.entry_speed);
  a.unknowns = sensitivities(data, layout, gears, r, a);
  a.touched.clear();
  for (Eigen::Index k = 0; k < a.unknowns.cols(); ++k)
    if (!a.unknowns.col(k).isZero(0.0)) a.touched.push_back(k);
  a.carried = carried_sensitivities(data, gears, run, a);
  a.difference = a.measured - a.predicted + a.unknowns * bed;
}

}  // namespace apc::learning
