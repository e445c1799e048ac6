/// The two pair sums of a step and what belongs to a particle in between, for a range of clusters.
///
///   velocity gradient  L_i = V_i Σ_j (v_j − v_i) ⊗ ∇W          (mass-weighted: m_j/ρ_i with equal masses)
///   acceleration     m a_i = Σ_j (V_i² σ_i + V_j² σ_j)·∇W − m² Σ_j Π_ij ∇W
/// The two are conjugate: Σ_i m a_i·v_i = −Σ_i V_i σ_i : L_i − viscous heat, whatever the particle arrangement.
///   viscosity  Π = (−α c̄ μ + β μ²)/ρ̄, μ = h v·r/(r² + 0.01 h²) when approaching, else 0   (Monaghan 1992)
///
/// The volume form, for comparison (PairForm::volume), is conjugate too:
///   L_i = Σ_j V_j (v_j − v_i) ⊗ ∇W,  m a_i = Σ_j V_i V_j (σ_i + σ_j)·∇W − …
///
/// Neighbour data lie in records of 16 floats (one cache line) in the order of `record`; mirror images follow the real
/// particles, and one record of nothing ends them. One cluster of 8 particles shares one neighbour list of even length.
/// A vector of 8 lanes or less meets one neighbour at a time; one of 16 lanes holds the cluster twice and meets two.
#pragma once

#include <cstdint>

namespace apc::sph {

inline constexpr int lanes = 8;          ///< particles per cluster
inline constexpr int whole_vector = 16;  ///< the number of particles is a multiple of it

namespace record {
enum : int { x, y, z, quarter_inverse_h, vx, vy, vz, volume, sxx, syy, szz, sxy, sxz, syz, visc_a, visc_b, size };
}

enum class PairForm { mass, volume };

/// Everything a kernel reads and writes; plain pointers so that the kernels can be compiled once per instruction set.
struct PairWork {
  float* records;                  ///< real particles (padded) then images
  const std::uint32_t* neighbour;  ///< record numbers
  const std::uint32_t* first;      ///< per cluster: where its list begins; clusters + 1 entries
  float* stretch;
  float* stress[6];
  float* work;
  float* acceleration[3];
  double* internal;  ///< internal work of this step, J: at the first cluster of each vector, else untouched
  double* viscous;   ///< likewise: heat of the artificial viscosity in this step, J
  double* damped;    ///< likewise: work of the material damping, J

  const float* yield;  ///< table of the load curve
  int yield_intervals;
  float yield_lowest, tension_cutoff;
  float dt, lame_lambda, shear_modulus, poisson_ratio;
  float volume0, mass;
  PairForm form;
  float damping;  ///< c ρ0 D L: damping stress per strain rate at zero strain
};

/// What may become a neighbour, one array per field; each may be read a whole vector beyond its end.
struct Candidates {
  const float* at[3];
  const float* quarter_inverse_h;
  const float* reach;           ///< how far it may still travel, m
  const std::uint32_t* number;  ///< of its record
};

/// A cluster that looks for its neighbours.
struct Box {
  float low[3], high[3];
  float quarter_inverse_h;  ///< smallest
  float reach;              ///< largest
  float support;            ///< largest 2h of any pair, m
};

struct PairKernels {
  const char* name;
  void (*strain)(const PairWork&, int first_cluster, int last_cluster);
  void (*accelerate)(const PairWork&, int first_cluster, int last_cluster);
  /// `rounds` dependent rounds of independent multiply-adds; returns the floating-point operations done.
  double (*multiply_add)(long rounds);
  /// Reads `count` floats, a multiple of 128, and returns their sum.
  float (*read)(const float* data, long count);
  /// Numbers of the candidates [first, end) within reach of the box, in their order; returns how many. `kept` has room
  /// for all of them and a whole vector.
  int (*filter)(const Candidates&, const Box&, int first, int end, std::uint32_t* kept);
};

/// The kernels for the widest instruction set this processor has: AVX-512, AVX2 with FMA, or SSE4.
const PairKernels& pair_kernels();
/// A given width, for tests: 16, 8 or 4 lanes; null where the processor cannot run it.
const PairKernels* pair_kernels_of_width(int width);

const PairKernels& kernels_v2();
const PairKernels& kernels_v3();
const PairKernels& kernels_v4();

/// The same kernels in arithmetic that counts itself, and the operations of this thread since the last call.
const PairKernels& kernels_counted();
long long take_operations();

}  // namespace apc::sph
