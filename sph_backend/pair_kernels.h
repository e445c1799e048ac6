/// The two pair sums of a step and what belongs to a particle in between, for a range of clusters.
///
///   velocity gradient  L_i = V_i Σ_j (v_j − v_i) ⊗ ∇W          (mass-weighted: m_j/ρ_i with equal masses)
///   acceleration     m a_i = Σ_j (V_i² σ_i + V_j² σ_j)·∇W − m² Σ_j Π_ij ∇W
/// The two are conjugate: Σ_i m a_i·v_i = −Σ_i V_i σ_i : L_i − viscous heat, whatever the particle arrangement.
///   viscosity  Π = (−α c̄ μ + β μ²)/ρ̄, μ = h v·r/(r² + 0.01 h²) when approaching, else 0   (Monaghan 1992)
///
/// Neighbour data lie in records of 16 floats (one cache line) in the order of `Record`; mirror images follow the real
/// particles. One cluster of 16 particles shares one neighbour list, each neighbour is broadcast to all lanes.
#pragma once

#include <cstdint>

namespace apc::sph {

inline constexpr int lanes = 16;  ///< particles per cluster

namespace record {
enum : int { x, y, z, inverse_h, vx, vy, vz, visc_a, sxx, syy, szz, sxy, sxz, syz, visc_b, volume, size };
}

/// Everything a kernel reads and writes; plain pointers so that the kernels can be compiled once per instruction set.
struct PairWork {
  float* records;                  ///< real particles (padded) then images
  const std::uint32_t* neighbour;  ///< record numbers
  const std::uint32_t* first;      ///< per cluster: where its list begins; clusters + 1 entries
  float* stretch;
  float* stress[6];
  float* work;
  float* acceleration[3];
  double* internal;  ///< per cluster: internal work of this step, J
  double* viscous;   ///< per cluster: heat of the artificial viscosity in this step, J
  double* damped;    ///< per cluster: work of the material damping, J

  const float* yield;  ///< table of the load curve
  int yield_intervals;
  float yield_lowest, tension_cutoff;
  float dt, lame_lambda, shear_modulus, poisson_ratio;
  float volume0, mass;
  float damping;  ///< c ρ0 D L: damping stress per strain rate at zero strain
};

/// Positions of one cluster against one run of candidates: keeps the candidates within reach of any lane.
struct FilterWork {
  const float* records;
  const float* reach;  ///< per record: how far it may still travel, m
};

struct PairKernels {
  const char* name;
  void (*strain)(const PairWork&, int first_cluster, int last_cluster);
  void (*accelerate)(const PairWork&, int first_cluster, int last_cluster);
  /// `rounds` dependent rounds of independent multiply-adds; returns the floating-point operations done.
  double (*multiply_add)(long rounds);
  int (*filter)(const FilterWork&, int cluster, const std::uint32_t* candidates, int count, std::uint32_t* kept);
};

/// The kernels for the widest instruction set this processor has: AVX-512, AVX2 with FMA, or SSE4.
const PairKernels& pair_kernels();
/// A given width, for tests: 16, 8 or 4 lanes; null where the processor cannot run it.
const PairKernels* pair_kernels_of_width(int width);

const PairKernels& kernels_v2();
const PairKernels& kernels_v3();
const PairKernels& kernels_v4();

}  // namespace apc::sph
