// A vector that counts its arithmetic, in place of vector.inl: every product, sum, quotient, root, comparison or
// estimate of a reciprocal is one operation per lane. A fused multiply-add counts as two, as in a processor's peak.
namespace apc::sph {
namespace {

#define APC_INLINE inline

constexpr int width = APC_LANES;
thread_local long long operations = 0;  // the kernels have no room for a counter of their own

struct Vec {
  float lane[width];
  float operator[](int l) const { return lane[l]; }
  float& operator[](int l) { return lane[l]; }
};

template <class Of>
Vec each(const Of& of) {
  operations += width;
  Vec v;
  for (int l = 0; l < width; ++l) v[l] = of(l);
  return v;
}
inline Vec splat(float a) {
  Vec v;
  for (float& one : v.lane) one = a;
  return v;
}
inline Vec load(const float* p) {
  Vec v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline void store(float* p, Vec v) { __builtin_memcpy(p, &v, sizeof v); }

inline Vec operator-(Vec a) {
  for (float& one : a.lane) one = -one;
  return a;
}
inline Vec operator+(Vec a, Vec b) {
  return each([&](int l) { return a[l] + b[l]; });
}
inline Vec operator-(Vec a, Vec b) {
  return each([&](int l) { return a[l] - b[l]; });
}
inline Vec operator*(Vec a, Vec b) {
  return each([&](int l) { return a[l] * b[l]; });
}
inline Vec operator/(Vec a, Vec b) {
  return each([&](int l) { return a[l] / b[l]; });
}
inline Vec operator+(Vec a, float b) { return a + splat(b); }
inline Vec operator-(Vec a, float b) { return a - splat(b); }
inline Vec operator*(Vec a, float b) { return a * splat(b); }
inline Vec operator+(float a, Vec b) { return splat(a) + b; }
inline Vec operator-(float a, Vec b) { return splat(a) - b; }
inline Vec operator*(float a, Vec b) { return splat(a) * b; }
inline Vec operator/(float a, Vec b) { return splat(a) / b; }
inline Vec& operator+=(Vec& a, Vec b) { return a = a + b; }
inline Vec& operator-=(Vec& a, Vec b) { return a = a - b; }
inline Vec& operator*=(Vec& a, Vec b) { return a = a * b; }
inline Vec vmax(Vec a, Vec b) {
  return each([&](int l) { return a[l] > b[l] ? a[l] : b[l]; });
}
inline Vec vmin(Vec a, Vec b) {
  return each([&](int l) { return a[l] < b[l] ? a[l] : b[l]; });
}
inline Vec rsqrt0(Vec a) {
  return each([&](int l) { return 1.0f / __builtin_sqrtf(a[l]); });
}
inline Vec rcp0(Vec a) {
  return each([&](int l) { return 1.0f / a[l]; });
}
inline Vec vsqrt(Vec a) {
  return each([&](int l) { return __builtin_sqrtf(a[l]); });
}
inline Vec where_negative(Vec a, Vec yes, Vec no) {
  return each([&](int l) { return a[l] < 0.0f ? yes[l] : no[l]; });
}
inline unsigned negative(Vec a) {
  unsigned bits = 0;
  for (int l = 0; l < width; ++l) bits |= static_cast<unsigned>(a[l] < 0.0f) << l;
  return bits;
}
inline double sum(Vec a) {
  operations += width;
  double total = 0.0;
  for (const float one : a.lane) total += one;
  return total;
}

}  // namespace
}  // namespace apc::sph
