// Means over segments of runs whose motion is known in closed form, and how far they may be off.
#include "apc/learning/segments.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "apc/learning/feature_noise.h"

namespace apc::learning {
namespace {

constexpr double entry = 30.0, slowing = 3.0, way = entry * entry / (2.0 * slowing);

/// Constant deceleration from the leading edge on.
Trace constant_stop() {
  Trace trace;
  auto& h = trace.result.history;
  h.gears.resize(2);
  for (double t = -1.0; t <= entry / slowing + 1e-9; t += 0.01) {
    const double v = t < 0.0 ? entry : entry - slowing * t;
    h.time.push_back(t), h.speed.push_back(v);
    h.distance.push_back(t < 0.0 ? entry * t : entry * t - 0.5 * slowing * t * t);
    h.acceleration_x.push_back(t < 0.0 ? 0.0 : -slowing);
    for (auto& gear : h.gears)
      gear.distance.push_back(h.distance.back()), gear.rut.push_back(0.1 + 1e-3 * h.distance.back());
  }
  trace.result.mean_deceleration = slowing, trace.stop = trace.result.stop_distance = way;
  return trace;
}

Channel channel(Quantity quantity, double noise) {
  Channel c;
  c.quantity = quantity, c.noise = noise, c.scale = 0.0;
  const Trace trace = constant_stop();
  const auto& h = trace.result.history;
  const auto& values = quantity == Quantity::speed ? h.speed : h.acceleration_x;
  for (std::size_t i = 0; i < h.time.size(); i += quantity == Quantity::speed ? 10 : 1)
    c.time.push_back(h.time[i]), c.value.push_back(values[i]);
  return c;
}

Run recorded(double speed_noise, double acceleration_noise) {
  Run run;
  run.overrun.entry_speed = entry;
  run.channels = {channel(Quantity::speed, speed_noise), channel(Quantity::acceleration_x, acceleration_noise)};
  run.stop = way;
  run.stop_noise = 0.3, run.uncertainty.clock = 0.0;
  return run;
}

aircraft::Aircraft two_gears() {
  aircraft::Aircraft a;
  a.gears.resize(2);
  a.gears[0].name = "nose", a.gears[1].name = "main";
  return a;
}

TEST(Segments, AConstantDecelerationIsReadAsSuchFromDataAndFromTheModel) {
  const auto run = recorded(0.1, 0.3);
  const Segments s = make_segments(run, way);
  const auto measured = measured_features(run, s), simulated = simulated_features(run, s, constant_stop(), two_gears());
  ASSERT_EQ(measured.size(), static_cast<Eigen::Index>(s.features.size()));
  for (std::size_t k = 0; k < s.features.size(); ++k) {
    const Feature& f = s.features[k];
    const double wanted = f.kind == Feature::Kind::stop      ? way
                          : f.kind == Feature::Kind::slowing ? slowing
                          : f.segment == 0                   ? 0.0
                                                             : -slowing;
    // At the edge of the bed the window for the speed holds the corner of the motion: 0.3 s × 3 m/s² / 4 of 30 m/s.
    const double allowed = f.kind == Feature::Kind::slowing && f.segment == 1 ? 0.6 : 0.03 * slowing;
    EXPECT_NEAR(measured[static_cast<Eigen::Index>(k)], wanted, allowed) << k;
    EXPECT_NEAR(simulated[static_cast<Eigen::Index>(k)], wanted, 0.02 * slowing) << k;
  }
}

TEST(Segments, NoiseOfAMeanIsTheNoiseOverTheRootOfTheSamples) {
  const auto run = recorded(0.1, 0.3);
  const Segments s = make_segments(run, way);
  const auto value = simulated_features(run, s, constant_stop(), two_gears());
  SegmentErrors none;
  none.block_strength = none.drag = none.nose_drag = none.rut = 0.0;
  const auto noise = feature_noise(run, s, constant_stop(), value, Eigen::VectorXd::Zero(value.size()), none);
  for (std::size_t k = 0; k < s.features.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const Feature& f = s.features[k];
    if (f.kind == Feature::Kind::stop) {
      EXPECT_NEAR(noise(i, i), 0.09, 1e-9);
    }
    if (f.kind != Feature::Kind::mean || f.segment == 0) continue;
    const double a = s.edge[f.segment], b = s.edge[f.segment + 1];
    const double seconds =
        (std::sqrt(entry * entry - 2.0 * slowing * a) - std::sqrt(entry * entry - 2.0 * slowing * b)) / slowing;
    EXPECT_NEAR(noise(i, i), 0.09 / (100.0 * seconds), 1e-4);
  }
}

TEST(Segments, AnErrorOfTheForceReachesTheStop) {
  // With one common error of every block (correlation far longer than the bed) the stop scatters by the same share.
  const auto run = recorded(0.1, 0.3);
  const Segments s = make_segments(run, way);
  const auto value = simulated_features(run, s, constant_stop(), two_gears());
  Eigen::VectorXd by_strength = Eigen::VectorXd::Zero(value.size());
  for (std::size_t k = 0; k < s.features.size(); ++k) {
    const Feature& f = s.features[k];
    if (f.kind == Feature::Kind::slowing && f.segment > 0) by_strength[static_cast<Eigen::Index>(k)] = slowing;
    if (f.kind == Feature::Kind::mean && f.segment > 0) by_strength[static_cast<Eigen::Index>(k)] = -slowing;
  }
  by_strength[value.size() - 1] = -way;
  SegmentErrors blocks;
  blocks.block_strength = 0.1, blocks.correlation = 1e9, blocks.lateral = 1.0;
  blocks.drag = blocks.nose_drag = 0.0;
  const auto noise = feature_noise(run, s, constant_stop(), value, by_strength, blocks);
  const auto last = value.size() - 1;
  EXPECT_NEAR(std::sqrt(noise(last, last) - 0.09), 0.1 * way, 0.01 * way);
}

/// A bed whose drag grows along the way, a = k s: s = (v₀ / √k) sin √k t until the stop.
Trace growing_stop(double k) {
  Trace trace;
  auto& h = trace.result.history;
  h.gears.resize(2);
  const double rate = std::sqrt(k);
  for (double t = -1.0; t <= 0.5 * M_PI / rate; t += 0.001) {
    const bool bed = t > 0.0;
    h.time.push_back(t), h.distance.push_back(bed ? entry / rate * std::sin(rate * t) : entry * t);
    h.speed.push_back(bed ? entry * std::cos(rate * t) : entry);
    h.acceleration_x.push_back(bed ? -k * h.distance.back() : 0.0);
  }
  trace.stop = trace.result.stop_distance = h.distance.back(), trace.result.mean_deceleration = 4.0;
  return trace;
}

/// What is recorded where the speed is `late[0]`, the accelerometer `late[1]` and the clock `late[2]` seconds late.
Run recorded_late(const Trace& trace, const std::array<double, 3>& late) {
  const auto& h = trace.result.history;
  Run run;
  run.overrun.entry_speed = entry;
  for (const std::size_t c : {std::size_t{0}, std::size_t{1}}) {
    Channel& channel = run.channels.emplace_back();
    channel.quantity = c == 0 ? Quantity::speed : Quantity::acceleration_x;
    for (double t = -0.95; t < h.time.back(); t += 0.001) {
      channel.time.push_back(t + late[2]);
      channel.value.push_back(at_place(h.time, c == 0 ? h.speed : h.acceleration_x, t - late[c]));
    }
  }
  return run;
}

TEST(Segments, ALateChannelAndALateClockMoveTheNumbersAsTheirColumnsSay) {
  const Trace trace = growing_stop(0.09);
  const auto prompt = recorded_late(trace, {0.0, 0.0, 0.0});
  const Segments s = make_segments(prompt, trace.stop);
  const Eigen::VectorXd before = measured_features(prompt, s);
  const Eigen::MatrixXd change = delayed_features(prompt, s, trace, simulated_features(prompt, s, trace, two_gears()));
  for (const Eigen::Index c : {Eigen::Index{0}, Eigen::Index{1}, Eigen::Index{2}}) {
    std::array<double, 3> late{};
    late[static_cast<std::size_t>(c)] = 0.04;
    const Eigen::VectorXd moved = (measured_features(recorded_late(trace, late), s) - before) / 0.04;
    for (std::size_t k = 0; k < s.features.size(); ++k) {
      // Away from the corners of the motion at the edge of the bed and at the stop.
      if (s.features[k].segment < 3 || s.features[k].segment + 3 > s.count()) continue;
      const auto i = static_cast<Eigen::Index>(k);
      EXPECT_NEAR(moved[i], change(i, c), 0.06 * entry * 0.09) << "number " << k << " column " << c;
    }
  }
  ASSERT_EQ(s.features[0].kind, Feature::Kind::slowing);
  EXPECT_EQ(change(0, 1), 0.0) << "slowings are read from the speed alone";
}

}  // namespace
}  // namespace apc::learning
