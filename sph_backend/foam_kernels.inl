// Stress of the crushable foam for one vector of particles (law: foam.h); part of pair_kernels.inl.

constexpr float loosest = 0.9f;  // (ρ/ρ0)^⅓ of a torn particle

struct Gradient {
  Vec xx, xy, xz, yx, yy, yz, zx, zy, zz;
};

struct Symmetric {
  Vec xx, yy, zz, xy, xz, yz;
};

APC_INLINE Vec dot(const Symmetric& a, const Symmetric& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2.0f * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// One Jacobi rotation in the plane (p, q); `r` is the third row. Q collects the rotations.
APC_INLINE void rotate(Vec& app, Vec& aqq, Vec& apq, Vec& arp, Vec& arq, Vec& q0p, Vec& q0q, Vec& q1p, Vec& q1q,
                       Vec& q2p, Vec& q2q) {
  const Vec d = aqq - app;
  const Vec size = vsqrt(d * d + 4.0f * apq * apq) + 1e-20f;
  const Vec sign = where_negative(d, splat(-1.0f), splat(1.0f));
  const Vec t = 2.0f * sign * apq / (vabs(d) + size);
  const Vec c = rsqrt(1.0f + t * t), s = t * c;
  app -= t * apq, aqq += t * apq, apq = Vec{};
  const Vec rp = arp, p0 = q0p, p1 = q1p, p2 = q2p;
  arp = c * rp - s * arq, arq = s * rp + c * arq;
  q0p = c * p0 - s * q0q, q0q = s * p0 + c * q0q;
  q1p = c * p1 - s * q1q, q1q = s * p1 + c * q1q;
  q2p = c * p2 - s * q2q, q2q = s * p2 + c * q2q;
}

/// Every principal stress into [−crush, tension].
inline __attribute__((noinline)) void cap_principal(Symmetric& s, Vec crush, float tension) {
  const Vec one = splat(1.0f);
  Vec q00 = one, q01{}, q02{}, q10{}, q11 = one, q12{}, q20{}, q21{}, q22 = one;
  for (int sweep = 0; sweep < 4; ++sweep) {
    rotate(s.xx, s.yy, s.xy, s.xz, s.yz, q00, q01, q10, q11, q20, q21);
    rotate(s.xx, s.zz, s.xz, s.xy, s.yz, q00, q02, q10, q12, q20, q22);
    rotate(s.yy, s.zz, s.yz, s.xy, s.xz, q01, q02, q11, q12, q21, q22);
  }
  const Vec top = splat(tension);
  const Vec a = vmin(vmax(s.xx, -crush), top), b = vmin(vmax(s.yy, -crush), top), c = vmin(vmax(s.zz, -crush), top);
  s.xx = q00 * q00 * a + q01 * q01 * b + q02 * q02 * c;
  s.yy = q10 * q10 * a + q11 * q11 * b + q12 * q12 * c;
  s.zz = q20 * q20 * a + q21 * q21 * b + q22 * q22 * c;
  s.xy = q00 * q10 * a + q01 * q11 * b + q02 * q12 * c;
  s.xz = q00 * q20 * a + q01 * q21 * b + q02 * q22 * c;
  s.yz = q10 * q20 * a + q11 * q21 * b + q12 * q22 * c;
}

APC_INLINE Vec yield_stress(const PairWork& w, Vec strain) {
  Vec crush;
  const float last = static_cast<float>(w.yield_intervals) - 1.0f;
  for (int l = 0; l < width; ++l) {
    float place = strain[l] * static_cast<float>(w.yield_intervals);
    place = place > 0.0f ? (place < last ? place : last) : 0.0f;
    const int i = static_cast<int>(place);
    const float f = place - static_cast<float>(i);
    crush[l] = w.yield[i] + f * (w.yield[i + 1] - w.yield[i]);
  }
  return crush;
}

template <PairForm form>
APC_INLINE void update_stress(const PairWork& w, int base, Gradient l, double& internal, double& damped) {
  const float dt = w.dt;
  const Vec stretch = load(w.stretch + base);
  const Vec volume = w.volume0 / (stretch * stretch * stretch);
  const Vec f = form == PairForm::mass ? grad * volume : splat(grad);
  l.xx *= f, l.xy *= f, l.xz *= f, l.yx *= f, l.yy *= f, l.yz *= f, l.zx *= f, l.zy *= f, l.zz *= f;
  const Vec trace = l.xx + l.yy + l.zz;
  const Symmetric d{l.xx, l.yy, l.zz, 0.5f * (l.xy + l.yx), 0.5f * (l.xz + l.zx), 0.5f * (l.yz + l.zy)};
  const Vec a = (0.5f * dt) * (l.xy - l.yx), b = (0.5f * dt) * (l.xz - l.zx), c = (0.5f * dt) * (l.yz - l.zy);

  // L is taken at the end of the step, where a turning body seems to swell by ½ Δt² WᵀW: taken out of strain and
  // volume.
  const Vec rxx = 0.5f * (a * a + b * b), ryy = 0.5f * (a * a + c * c), rzz = 0.5f * (b * b + c * c);
  const Vec swelling = rxx + ryy + rzz;

  // Continuity, exact for a constant rate: stretch · exp(−dt tr L/3), as a Padé form.
  const Vec e = (-1.0f / 6.0f) * (dt * trace - swelling);
  // A torn particle does not swell without end: its share of the crack is void, not foam.
  const Vec new_stretch = vmax(stretch * ((1.0f + e) / (1.0f - e)), splat(loosest));
  const Vec ratio = 1.0f / (new_stretch * new_stretch * new_stretch);  // ρ0/ρ

  Symmetric old{load(w.stress[0] + base), load(w.stress[1] + base), load(w.stress[2] + base),
                load(w.stress[3] + base), load(w.stress[4] + base), load(w.stress[5] + base)};
  // Jaumann rate: σ + dt (W σ − σ W), then the elastic trial.
  const Vec p = w.lame_lambda * (dt * trace - swelling);
  const float g2 = 2.0f * w.shear_modulus;
  Symmetric s;
  s.xx = old.xx + 2.0f * (a * old.xy + b * old.xz) + g2 * (dt * d.xx - rxx) + p;
  s.yy = old.yy + 2.0f * (c * old.yz - a * old.xy) + g2 * (dt * d.yy - ryy) + p;
  s.zz = old.zz - 2.0f * (b * old.xz + c * old.yz) + g2 * (dt * d.zz - rzz) + p;
  s.xy = old.xy + a * (old.yy - old.xx) + b * old.yz + c * old.xz + g2 * (dt * d.xy - 0.5f * b * c);
  s.xz = old.xz + a * old.yz + b * (old.zz - old.xx) - c * old.xy + g2 * (dt * d.xz + 0.5f * a * c);
  s.yz = old.yz - a * old.xz + c * (old.zz - old.yy) - b * old.xy + g2 * (dt * d.yz - 0.5f * a * b);

  // Circles around the diagonal (Gershgorin) bound the principal values: most clusters need no decomposition.
  const Vec ox = vabs(s.xy) + vabs(s.xz), oy = vabs(s.xy) + vabs(s.yz), oz = vabs(s.xz) + vabs(s.yz);
  const Vec high = vmax(vmax(s.xx + ox, s.yy + oy), s.zz + oz), low = vmax(vmax(ox - s.xx, oy - s.yy), oz - s.zz);
  if (any_negative(w.tension_cutoff - high) || any_negative(w.yield_lowest - low))
    cap_principal(s, yield_stress(w, 1.0f - ratio), w.tension_cutoff);

  // Work of the pair forces that carry V² σ, so that it closes with the motion: those after the step on L as it is
  // here, those before it on L as it was there, L (I − Δt L)⁻¹ ≈ L + Δt L².
  const Vec new_volume = w.volume0 * ratio, after = 0.5f * new_volume * (new_volume / volume), before = 0.5f * volume;
  const Symmetric first{d.xx + dt * (l.xx * l.xx + l.xy * l.yx + l.xz * l.zx),
                        d.yy + dt * (l.xy * l.yx + l.yy * l.yy + l.yz * l.zy),
                        d.zz + dt * (l.xz * l.zx + l.yz * l.zy + l.zz * l.zz),
                        d.xy + (0.5f * dt) * (l.xy * (l.xx + l.yy) + l.yx * (l.xx + l.yy) + l.xz * l.zy + l.yz * l.zx),
                        d.xz + (0.5f * dt) * (l.xz * (l.xx + l.zz) + l.zx * (l.xx + l.zz) + l.xy * l.yz + l.zy * l.yx),
                        d.yz + (0.5f * dt) * (l.yz * (l.yy + l.zz) + l.zy * (l.yy + l.zz) + l.yx * l.xz + l.zx * l.xy)};
  const Vec work = dt * (before * dot(old, first) + after * dot(s, d));
  internal += sum(work);
  store(w.work + base, load(w.work + base) + work);
  store(w.stretch + base, new_stretch);
  store(w.stress[0] + base, s.xx), store(w.stress[1] + base, s.yy), store(w.stress[2] + base, s.zz);
  store(w.stress[3] + base, s.xy), store(w.stress[4] + base, s.xz), store(w.stress[5] + base, s.yz);

  if (w.damping > 0.0f) {
    const Vec k = w.damping / (2.0f - ratio);  // a = c ρ D L/(1 + γ), γ = 1 − ρ0/ρ; c ρ held at its intact value
    const float dev = 1.0f / (1.0f + w.poisson_ratio), vol = 1.0f / (3.0f * (1.0f - 2.0f * w.poisson_ratio));
    const Vec third = (1.0f / 3.0f) * trace;
    const Symmetric v{k * (dev * (d.xx - third) + vol * trace),
                      k * (dev * (d.yy - third) + vol * trace),
                      k * (dev * (d.zz - third) + vol * trace),
                      k * dev * d.xy,
                      k * dev * d.xz,
                      k * dev * d.yz};
    damped += sum((dt * w.volume0) * ratio * dot(v, d));
    s.xx += v.xx, s.yy += v.yy, s.zz += v.zz, s.xy += v.xy, s.xz += v.xz, s.yz += v.yz;
  }
  // V²/m or 1/m
  const Vec scale = form == PairForm::mass ? (w.volume0 * w.volume0 / w.mass) * ratio * ratio : splat(1.0f / w.mass);
  s.xx *= scale, s.yy *= scale, s.zz *= scale, s.xy *= scale, s.xz *= scale, s.yz *= scale;
  for (int i = 0; i < width; ++i) {
    float* q = w.records + static_cast<std::size_t>(base + i) * record::size;
    q[record::sxx] = s.xx[i], q[record::syy] = s.yy[i], q[record::szz] = s.zz[i];
    q[record::sxy] = s.xy[i], q[record::sxz] = s.xz[i], q[record::syz] = s.yz[i];
  }
}
