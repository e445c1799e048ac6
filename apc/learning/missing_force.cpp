#include "apc/learning/missing_force.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "apc/base/units.h"

namespace apc::learning {
namespace {

constexpr std::size_t classes = 10;

/// Takes each run's mean before the bed off and drops what lies before it.
std::vector<MissingForce> in_bed_only(const std::vector<MissingForce>& all, std::size_t runs) {
  std::vector<double> before(runs, 0.0), count(runs, 0.0);
  for (const MissingForce& m : all)
    if (m.place < 0.0) before[m.run] += m.missing, count[m.run] += 1.0;
  std::vector<MissingForce> result;
  for (MissingForce m : all) {
    if (m.place < 0.0) continue;
    const double offset = count[m.run] > 3.0 ? before[m.run] / count[m.run] : 0.0;
    m.missing -= offset, m.left -= offset;
    result.push_back(m);
  }
  return result;
}

std::vector<MissingForce> along_motion(const Study& study) {
  std::vector<MissingForce> all;
  const auto& gears = study.along->gears;
  for (std::size_t r = 0; r < study.along->runs.size(); ++r) {
    const AlongRun& a = study.along->runs[r];
    const Run& run = study.background.runs[r];
    effects::Alterations alterations;
    alterations.conditions = run.conditions;
    alterations.effects = study.diagnosis.augmented;
    const Eigen::VectorXd with =
        read_off(a.readings, gears, run, a.motion,
                 balance_at_loads(*study.background.data, gears, run, a.motion, alterations), run.overrun.entry_speed);
    const auto main = static_cast<std::size_t>(
        std::find_if(gears.begin(), gears.end(), [](const GearFacts& g) { return !g.nose; }) - gears.begin());
    for (std::size_t i = 0; i < a.readings.size(); ++i) {
      const Reading& reading = a.readings[i];
      if (!reading.is(Quantity::acceleration_x)) continue;
      const double when = 0.5 * (reading.from + reading.to);
      const auto k = static_cast<Eigen::Index>(i);
      MissingForce m;
      m.run = r, m.time = when;
      m.place = a.motion.at(a.motion.place, when), m.speed = a.motion.at(a.motion.speed, when);
      m.penetration = a.motion.at(a.nominal.penetration[main], when);
      m.vertical = a.motion.at(a.nominal.vertical[main], when);
      // A deceleration the model lacks: it predicts more speed than was measured.
      m.missing = (a.plain[k] - a.measured[k]) / units::g0;
      m.left = (with[k] - a.measured[k]) / units::g0;
      all.push_back(m);
    }
  }
  return all;
}

std::vector<MissingForce> of_fitted_runs(const Study& study) {
  const Background& b = study.background;
  std::vector<MissingForce> all;
  for (std::size_t r = 0; r < std::min(b.training, b.traces.size()); ++r) {
    const Run& run = b.runs[r];
    const simulation::History& h = b.traces[r].result.history;
    if (h.time.size() < 3) continue;
    for (std::size_t c = 0; c < run.channels.size(); ++c) {
      const Channel& channel = run.channels[c];
      if (channel.quantity != Quantity::acceleration_x) continue;
      const Signal signal(h, channel, b.data->aircraft);
      const double delay = b.eta[b.layout.runs[r].lag[c]] + b.eta[b.layout.runs[r].clock];
      std::map<long, std::array<double, 2>> windows;  // by tenths of a second: sum of misfits, count
      for (std::size_t i = 0; i < channel.time.size(); ++i) {
        const double t = channel.time[i] - delay;
        if (t < h.time.front() || t > h.time.back()) continue;
        auto& w = windows[std::lround(std::floor(t * 10.0))];
        w[0] += signal(t) - channel.value[i], w[1] += 1.0;
      }
      for (const auto& [tenth, w] : windows) {
        MissingForce m;
        m.run = r, m.time = static_cast<double>(tenth) / 10.0 + 0.05;
        const auto at =
            std::min(h.time.size() - 1,
                     static_cast<std::size_t>(std::lower_bound(h.time.begin(), h.time.end(), m.time) - h.time.begin()));
        if (h.speed[at] < 3.0) continue;
        m.place = h.distance[at], m.speed = h.speed[at];
        for (std::size_t g = 0; g < h.gears.size(); ++g)
          if (!b.data->aircraft.gears[g].is_nose())
            m.penetration = h.gears[g].penetration[at], m.vertical = h.gears[g].vertical[at];
        m.missing = w[0] / w[1] / units::g0;
        m.left = std::numeric_limits<double>::quiet_NaN();
        all.push_back(m);
      }
    }
  }
  return all;
}

/// Adjusted share of variance (Olejnik and Algina's ω²) that the classes of a coordinate take.
double share_of(const std::vector<MissingForce>& points, const std::function<double(const MissingForce&)>& coordinate,
                bool as_it_is) {
  std::vector<double> sorted;
  for (const auto& p : points) sorted.push_back(coordinate(p));
  std::sort(sorted.begin(), sorted.end());
  std::map<std::size_t, std::array<double, 2>> sums;
  double total = 0.0, mean = 0.0;
  for (const auto& p : points) mean += p.missing / static_cast<double>(points.size());
  for (const auto& p : points) {
    const double x = coordinate(p);
    const auto rank = static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), x) - sorted.begin());
    auto& s = sums[as_it_is ? static_cast<std::size_t>(x) : rank * classes / sorted.size()];
    s[0] += p.missing - mean, s[1] += 1.0;
    total += (p.missing - mean) * (p.missing - mean);
  }
  double between = 0.0;
  for (const auto& [key, s] : sums) between += s[0] * s[0] / s[1];
  const double n = static_cast<double>(points.size()), k = static_cast<double>(sums.size());
  if (n <= k + 1.0 || total <= 0.0) return 0.0;
  const double within = (total - between) / (n - k);
  return std::max(0.0, (between - (k - 1.0) * within) / (total + within));
}

}  // namespace

std::vector<MissingForce> missing_forces(const Study& study) {
  return in_bed_only(study.along ? along_motion(study) : of_fitted_runs(study), study.background.training);
}

double joint_pitch(const Study& study) {
  for (const Claim& claim : study.diagnosis.claims)
    if (claim.id == "seams" && claim.probability > 0.5)
      for (std::size_t k = 0; k < claim.applied.values.size(); ++k)
        if (claim.applied.effect.parameters[k].name == "pitch") return claim.applied.values[k];
  const double block = study.background.data->bed.block_length;
  return block > 0.0 ? block : 1.22;
}

std::vector<Attribution> attributions(const std::vector<MissingForce>& points, double pitch) {
  if (points.size() < 3 * classes) return {};
  std::vector<Attribution> list;
  const auto add = [&](const char* name, const std::function<double(const MissingForce&)>& coordinate,
                       bool as_it_is = false) {
    list.push_back({name, share_of(points, coordinate, as_it_is)});
  };
  add("place in the bed", [](const MissingForce& m) { return m.place; });
  add("place within a joint's pitch", [pitch](const MissingForce& m) { return std::fmod(m.place, pitch); });
  add("speed", [](const MissingForce& m) { return m.speed; });
  add("penetration", [](const MissingForce& m) { return m.penetration; });
  add("vertical load", [](const MissingForce& m) { return m.vertical; });
  add("time", [](const MissingForce& m) { return m.time; });
  add(
      "run", [](const MissingForce& m) { return static_cast<double>(m.run); }, true);
  std::stable_sort(list.begin(), list.end(),
                   [](const Attribution& a, const Attribution& b) { return a.share > b.share; });
  return list;
}

}  // namespace apc::learning
