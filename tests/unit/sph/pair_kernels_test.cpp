#include "sph_backend/pair_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "cases.h"
#include "sph_backend/kernel.h"

namespace apc::sph {
namespace {

/// Two clusters among random neighbours, some beyond the support.
struct Cloud {
  static constexpr int others = 40, all = whole_vector + others;
  std::vector<float> records, acceleration[3];
  std::vector<std::uint32_t> list, first{0};
  double internal[2]{}, viscous[2]{}, damped[2]{};
  PairWork work{};

  Cloud() : records((all + 1) * record::size, 0.0f) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> part(-1.0f, 1.0f);
    for (int i = 0; i < all; ++i) {
      float* r = &records[i * record::size];
      for (int a = 0; a < 3; ++a) r[record::x + a] = 0.1f * part(random), r[record::vx + a] = 20.0f * part(random);
      r[record::quarter_inverse_h] = 5.0f + part(random);
      for (int c = 0; c < 6; ++c) r[record::sxx + c] = part(random);
      r[record::visc_a] = 0.3f + 0.1f * part(random), r[record::visc_b] = 0.02f + 0.01f * part(random);
    }
    records[all * record::size] = 1e4f;  // the record of nothing
    for (int c = 0; c < 2; ++c) {
      for (int j = c; j < all; ++j) list.push_back(j);  // an odd and an even number
      if (list.size() % 2 == 1) list.push_back(all);
      first.push_back(static_cast<std::uint32_t>(list.size()));
    }
    for (auto& a : acceleration) a.assign(whole_vector, 0.0f);
    work.records = records.data(), work.neighbour = list.data(), work.first = first.data();
    for (int a = 0; a < 3; ++a) work.acceleration[a] = acceleration[a].data();
    work.internal = internal, work.viscous = viscous, work.damped = damped;
    work.dt = 1e-4f, work.mass = 0.01f;
  }

  /// Acceleration of particle i along `axis` and its share of the heat, in double precision from kernel.h.
  double sum(int i, int axis, double& heat) const {
    const float* p = &records[i * record::size];
    double total = 0.0;
    for (int j = i < lanes ? 0 : 1; j < all; ++j) {
      const float* q = &records[j * record::size];
      double d[3], r2 = 0.0, vr = 0.0;
      for (int a = 0; a < 3; ++a) d[a] = p[a] - q[a], r2 += d[a] * d[a], vr += d[a] * (p[4 + a] - q[4 + a]);
      const double g = 2.0 * (p[record::quarter_inverse_h] + q[record::quarter_inverse_h]);  // 1/h of the pair
      const double slope = kernel_slope(std::sqrt(r2), g);
      const double mu = std::min(vr, 0.0) * g / (r2 * g * g + 0.01);
      const double a = 2.0 * (p[record::visc_a] + q[record::visc_a]), b = 4.0 * (p[record::visc_b] + q[record::visc_b]);
      const double pi = mu * (b * mu - a);
      const int row[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
      double pull = 0.0;
      for (int k = 0; k < 3; ++k)
        pull += (p[record::sxx + row[axis][k]] + q[record::sxx + row[axis][k]]) * slope * d[k];
      total += pull - pi * slope * d[axis];
      heat += 0.5 * work.mass * work.dt * pi * slope * vr;
    }
    return total;
  }
};

TEST(PairKernels, EveryWidthGivesTheForcesOfThePairs) {
  for (const int width : {4, 8, 16}) {
    const PairKernels* kernels = pair_kernels_of_width(width);
    if (kernels == nullptr) continue;  // not on this processor
    Cloud cloud;
    kernels->accelerate(cloud.work, 0, 2);
    double heat[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < whole_vector; ++i)
      for (int a = 0; a < 3; ++a) {
        const double expected = cloud.sum(i, a, heat[a]);  // the viscosity's reciprocal is good to 4e-4
        EXPECT_NEAR(cloud.acceleration[a][i], expected, 6e-4 * std::abs(expected) + 500.0) << width << " " << i;
      }
    EXPECT_GT(heat[0], 0.0);
    EXPECT_NEAR((cloud.viscous[0] + cloud.viscous[1]) / heat[0], 1.0, 2e-3) << width;
  }
}

TEST(Neighbours, ListsHoldEveryPairWithinTheSupport) {
  BedSpec s = testing::free_block(11, 7, 6);  // odd numbers: clusters with empty lanes
  s.free_body = false, s.hold_bottom = false;
  Bed bed = make_bed(s);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (std::size_t i = 0; i < bed.particles.size(); ++i)
    if (bed.particles.id[i] >= 0)
      bed.particles.vx[i] = 40.0 * part(random), bed.particles.vy[i] = 40.0 * part(random),
      bed.particles.vz[i] = 40.0 * part(random);
  long pairs = 0;
  for (int step = 0; step < 60; ++step) {
    drift(bed), strain(bed), accelerate(bed), kick(bed);
    if (step % 10 != 9) continue;
    const Neighbours& n = bed.neighbours;
    const std::size_t records = n.records.size() / record::size - 1;
    for (int c = 0; c < n.clusters; ++c) {
      const std::set<std::uint32_t> listed(n.list.begin() + n.first[c], n.list.begin() + n.first[c + 1]);
      EXPECT_EQ((n.first[c + 1] - n.first[c]) % 2, 0u);
      for (int i = c * lanes; i < (c + 1) * lanes; ++i) {
        if (bed.particles.id[i] < 0) continue;
        const float* p = &n.records[i * record::size];
        for (std::size_t j = 0; j < records; ++j) {
          if (j < bed.particles.size() && bed.particles.id[j] < 0) continue;
          const float* q = &n.records[j * record::size];
          const double u = p[record::quarter_inverse_h] + q[record::quarter_inverse_h];
          if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) * u >= 1.0) continue;
          ++pairs;
          EXPECT_TRUE(listed.contains(static_cast<std::uint32_t>(j))) << "step " << step << ": " << i << " and " << j;
        }
      }
    }
  }
  EXPECT_GT(pairs, 50000);
  EXPECT_GT(bed.rebuilds, 2);
}

/// Intact foam and foam crushed to a fifth of its height: a particle must not look at many times more neighbours.
TEST(Neighbours, ListsStayShortInCrushedFoam) {
  const auto entries = [](double height) {
    BedSpec s = testing::free_block(16, 16, 16);
    s.spacing = 1.0 * units::in;
    Bed bed = make_bed(s);
    for (double& z : bed.particles.z) z *= height;
    for (float& stretch : bed.particles.stretch) stretch = static_cast<float>(std::pow(height, -1.0 / 3.0));
    move_window(bed, 0, 16);
    return static_cast<double>(bed.neighbours.list.size()) / bed.alive;
  };
  const double intact = entries(1.0);
  EXPECT_LT(intact, 14.0);  // free faces; 16 inside
  EXPECT_LT(entries(0.2) / intact, 1.8);
}

/// Operations counted are those of the formulas, counted by hand.
TEST(PairKernels, CountedStepIsTheSumOfItsPairs) {
  Bed bed = make_bed(testing::free_block(8, 8, 8));
  const StepCount count = count_step(bed);
  EXPECT_EQ(count.pairs, static_cast<double>(bed.neighbours.list.size()) * lanes / bed.alive);
  EXPECT_GT(count.pairs, count.pairs_within);
  EXPECT_GT(count.pairs_within, 27.0);
  EXPECT_LT(count.pairs_within, 57.001);  // 56 neighbours and itself inside
  // Geometry 3 + 5 + 1 + 5 + 4, twice; gradient 6 + 18; force 8 + 1 + 6 + 5 + 3 + 3 + 9 + 18. The law adds to that.
  EXPECT_GT(count.operations / count.pairs, 2 * 18 + 24 + 53);
  EXPECT_LT(count.operations / count.pairs, 2 * 18 + 24 + 53 + 8);

  BedSpec volume = testing::free_block(8, 8, 8);
  volume.form = PairForm::volume;
  EXPECT_NEAR((count_step(make_bed(volume)).operations - count.operations) / count.pairs, 8.0, 0.1);
}

}  // namespace
}  // namespace apc::sph
