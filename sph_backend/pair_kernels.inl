// Body of kernels_v2.cpp, kernels_v3.cpp and kernels_v4.cpp; APC_LANES is the vector width in floats. Only functions
// with internal linkage here, see vector.inl.
#include "sph_backend/pair_kernels.h"
#ifdef APC_COUNTED
#include "sph_backend/counted_vector.inl"
#else
#include "sph_backend/vector.inl"
#endif

namespace apc::sph {
namespace {

#if APC_LANES < 16
/// One neighbour for all lanes.
struct Near {
  const float* record;
};
template <int parts>
APC_INLINE Near near(const float* records, const std::uint32_t* list) {
  return {records + list[0] * std::size_t{record::size}};
}
template <int field>
APC_INLINE float of(const Near& n) {
  return n.record[field];
}
APC_INLINE int keep(unsigned bits, const std::uint32_t* from, std::uint32_t* to) {
  int n = 0;
  for (int l = 0; l < width; ++l) to[n] = from[l], n += bits >> l & 1u;
  return n;
}
#endif

/// A vector wider than a cluster holds the cluster twice and meets two neighbours at once.
constexpr int at_once = width > lanes ? width / lanes : 1;

// One Newton step on the hardware's estimate: as good as the division, at a third of its cost.
APC_INLINE Vec rsqrt(Vec a) {
  const Vec y = rsqrt0(a);
  return y * (1.5f - 0.5f * a * y * y);
}
APC_INLINE Vec vabs(Vec a) { return vmax(a, -a); }
APC_INLINE bool any_negative(Vec a) { return negative(a) != 0; }
APC_INLINE Vec column(const float* records, int first, int field) {
  Vec v;
  for (int l = 0; l < width; ++l) v[l] = records[(first + l % lanes) * record::size + field];
  return v;
}

constexpr float grad = 32.0f * 2.08890857f;  // 105/(16 π), and 2⁵ because records carry 1/(4h)

#include "sph_backend/foam_kernels.inl"

/// Particles of one vector: what both pair sums ask of them.
struct Here {
  Vec x, y, z, quarter, vx, vy, vz;
};

APC_INLINE Here here(const float* records, int base) {
  using namespace record;
  return {column(records, base, x),  column(records, base, y),
          column(records, base, z),  column(records, base, quarter_inverse_h),
          column(records, base, vx), column(records, base, vy),
          column(records, base, vz)};
}

/// Distance and −∇W/(grad · distance) = t³ u⁵, u = 1/(4 h_i) + 1/(4 h_j) = 1/(2h), t = max(1 − r u, 0).
struct Pair {
  Vec dx, dy, dz, r2, u, weight;
};

APC_INLINE Pair pair_of(const Here& p, const Near& q) {
  Pair a;
  a.dx = p.x - of<record::x>(q), a.dy = p.y - of<record::y>(q), a.dz = p.z - of<record::z>(q);
  a.r2 = a.dx * a.dx + a.dy * a.dy + a.dz * a.dz;
  a.u = p.quarter + of<record::quarter_inverse_h>(q);
  const Vec t = vmax(1.0f - vsqrt(a.r2) * a.u, Vec{}) * a.u;
  a.weight = (t * t) * (t * (a.u * a.u));
  return a;
}

template <PairForm form>
APC_INLINE Gradient gradient(const PairWork& w, int base, std::uint32_t first, std::uint32_t end) {
  const Here p = here(w.records, base);
  Gradient s{};
  for (std::uint32_t k = first; k < end; k += at_once) {
    const Near q = near<2>(w.records, w.neighbour + k);
    Pair a = pair_of(p, q);
    if constexpr (form == PairForm::volume) a.weight = a.weight * of<record::volume>(q);
    const Vec ax = a.weight * (p.vx - of<record::vx>(q)), ay = a.weight * (p.vy - of<record::vy>(q)),
              az = a.weight * (p.vz - of<record::vz>(q));
    s.xx += ax * a.dx, s.xy += ax * a.dy, s.xz += ax * a.dz;
    s.yx += ay * a.dx, s.yy += ay * a.dy, s.yz += ay * a.dz;
    s.zx += az * a.dx, s.zy += az * a.dy, s.zz += az * a.dz;
  }
  return s;
}

struct Force {
  Vec x, y, z, heat;
};

template <PairForm form>
APC_INLINE Force force(const PairWork& w, int base, std::uint32_t first, std::uint32_t end) {
  using namespace record;
  const float* r = w.records;
  const Here p = here(r, base);
  const Vec pxx = column(r, base, sxx), pyy = column(r, base, syy), pzz = column(r, base, szz);
  const Vec pxy = column(r, base, sxy), pxz = column(r, base, sxz), pyz = column(r, base, syz);
  const Vec va = column(r, base, visc_a), vb = column(r, base, visc_b), size = column(r, base, volume);
  Force f{};
  for (std::uint32_t k = first; k < end; k += at_once) {
    const Near q = near<4>(r, w.neighbour + k);
    const Pair a = pair_of(p, q);
    const Vec vr = a.dx * (p.vx - of<vx>(q)) + a.dy * (p.vy - of<vy>(q)) + a.dz * (p.vz - of<vz>(q));
    const Vec approach = vmin(vr, Vec{});
    const Vec mu = approach * a.u * rcp0(a.r2 * (a.u * a.u) + 0.0025f);
    const Vec pi = mu * ((vb + of<visc_b>(q)) * mu - (va + of<visc_a>(q)));
    f.heat -= (a.weight * pi) * approach;
    const Vec wx = a.weight * a.dx, wy = a.weight * a.dy, wz = a.weight * a.dz;
    Vec txx = pxx + of<sxx>(q), tyy = pyy + of<syy>(q), tzz = pzz + of<szz>(q);
    Vec txy = pxy + of<sxy>(q), txz = pxz + of<sxz>(q), tyz = pyz + of<syz>(q);
    if constexpr (form == PairForm::volume) {
      const Vec both = size * of<volume>(q);
      txx *= both, tyy *= both, tzz *= both, txy *= both, txz *= both, tyz *= both;
    }
    txx -= pi, tyy -= pi, tzz -= pi;
    f.x -= txx * wx, f.x -= txy * wy, f.x -= txz * wz;
    f.y -= txy * wx, f.y -= tyy * wy, f.y -= tyz * wz;
    f.z -= txz * wx, f.z -= tyz * wy, f.z -= tzz * wz;
  }
  return f;
}

#if APC_LANES == 16
template <PairForm form>
APC_INLINE Gradient gradients(const PairWork& w, int c, int) {
  const Gradient a = gradient<form>(w, c * lanes, w.first[c], w.first[c + 1]),
                 b = gradient<form>(w, (c + 1) * lanes, w.first[c + 1], w.first[c + 2]);
  return {join(a.xx, b.xx), join(a.xy, b.xy), join(a.xz, b.xz), join(a.yx, b.yx), join(a.yy, b.yy),
          join(a.yz, b.yz), join(a.zx, b.zx), join(a.zy, b.zy), join(a.zz, b.zz)};
}
template <PairForm form>
APC_INLINE Force forces(const PairWork& w, int c, int) {
  const Force a = force<form>(w, c * lanes, w.first[c], w.first[c + 1]),
              b = force<form>(w, (c + 1) * lanes, w.first[c + 1], w.first[c + 2]);
  return {join(a.x, b.x), join(a.y, b.y), join(a.z, b.z), join(a.heat, b.heat)};
}
#else
template <PairForm form>
APC_INLINE Gradient gradients(const PairWork& w, int c, int base) {
  return gradient<form>(w, base, w.first[c], w.first[c + 1]);
}
template <PairForm form>
APC_INLINE Force forces(const PairWork& w, int c, int base) {
  return force<form>(w, base, w.first[c], w.first[c + 1]);
}
#endif

template <PairForm form>
void strain_in(const PairWork& w, int first_cluster, int last_cluster) {
  for (int c = first_cluster; c < last_cluster; c += at_once) {
    double internal = 0.0, damped = 0.0;
    for (int base = c * lanes; base < (c + at_once) * lanes; base += width)
      update_stress<form>(w, base, gradients<form>(w, c, base), internal, damped);
    w.internal[c] = internal, w.damped[c] = damped;
  }
}

template <PairForm form>
void accelerate_in(const PairWork& w, int first_cluster, int last_cluster) {
  for (int c = first_cluster; c < last_cluster; c += at_once) {
    double viscous = 0.0;
    for (int base = c * lanes; base < (c + at_once) * lanes; base += width) {
      const Force f = forces<form>(w, c, base);
      store(w.acceleration[0] + base, grad * f.x);
      store(w.acceleration[1] + base, grad * f.y);
      store(w.acceleration[2] + base, grad * f.z);
      viscous += sum((0.5f * grad * w.mass * w.dt) * f.heat);
    }
    w.viscous[c] = viscous;
  }
}

void strain(const PairWork& w, int first_cluster, int last_cluster) {
  const bool mass = w.form == PairForm::mass;
  (mass ? strain_in<PairForm::mass> : strain_in<PairForm::volume>)(w, first_cluster, last_cluster);
}

void accelerate(const PairWork& w, int first_cluster, int last_cluster) {
  const bool mass = w.form == PairForm::mass;
  (mass ? accelerate_in<PairForm::mass> : accelerate_in<PairForm::volume>)(w, first_cluster, last_cluster);
}

double multiply_add(long rounds) {
  constexpr int chains = 10;  // enough to hide the latency of two units
  Vec chain[chains];
  for (int k = 0; k < chains; ++k) chain[k] = splat(1.0f + 0.1f * static_cast<float>(k));
  const Vec factor = splat(0.999f), term = splat(0.001f);
  for (long r = 0; r < rounds; ++r) {
#pragma GCC unroll 10
    for (int k = 0; k < chains; ++k) chain[k] = chain[k] * factor + term;
  }
  volatile float keep_it = 0.0f;
  for (int k = 0; k < chains; ++k) keep_it = keep_it + chain[k][0];
  return 2.0 * chains * width * static_cast<double>(rounds);
}

float read(const float* data, long count) {
  constexpr int sums = 8;
  Vec part[sums];
  for (Vec& one : part) one = splat(0.0f);
  for (long i = 0; i + sums * width <= count; i += sums * width)
#pragma GCC unroll 8
    for (int k = 0; k < sums; ++k) part[k] += load(data + i + k * width);
  float total = 0.0f;
  for (const Vec& one : part) total += static_cast<float>(sum(one));
  return total;
}

// The box stands for its particles: they fill it to within a spacing, and the support is more than two.
int filter(const Candidates& all_of_them, const Box& box, int first, int end, std::uint32_t* kept) {
  const Candidates& q = all_of_them;
  const Vec support = splat(box.support), none{};
  int n = 0;
  for (int k = first; k < end; k += width) {
    Vec r2{};
    for (int a = 0; a < 3; ++a) {
      const Vec at = load(q.at[a] + k), outside = vmax(vmax(box.low[a] - at, at - box.high[a]), none);
      r2 += outside * outside;
    }
    // Support of the pair and 2 % more because h may grow, but never beyond h0; and what both may travel.
    const Vec pair = vmin(1.02f * rcp0(box.quarter_inverse_h + load(q.quarter_inverse_h + k)), support);
    const Vec limit = pair + box.reach + load(q.reach + k);
    const unsigned inside = end - k < width ? (1u << (end - k)) - 1u : ~0u;
    n += keep(negative(r2 - limit * limit) & inside, q.number + k, kept + n);
  }
  return n;
}

}  // namespace
}  // namespace apc::sph
