/// Look-ups in the tables of several runs side by side: places and weights in vectors across the runs, the sums over
/// coefficients in vectors along each run's own table. The same operations in the same order as LoadTable::load and
/// load_with_slopes, hence the same bits. For sources compiled once per instruction set (`V` = simulation::Lanes of
/// that set's width); nothing here calls inline functions of doubles.
#pragma once

#include <cstddef>
#include <vector>

#include "loadtables/load_table.h"

namespace apc::loadtables {

inline constexpr double depth_reference = 0.03;  ///< m, DepthScale::reference

/// A table's numbers as the look-up wants them; one column of TableLanes.
struct TableNumbers {
  const double* coefficients;
  const LoadTable* table;
  double speed_low, depth_low, ratio_low;  ///< lower ends of the axes
  double per_speed, per_depth, per_ratio;  ///< 1/step
  double speeds, depths, ratios;           ///< intervals
  double last_ratio;                       ///< intervals of the ratio that are asked, up to P_max
  double by_speed, by_depth;               ///< distances of neighbours among the coefficients
  double compaction, deflection, diameter, rounding;
  const double* pavement;  ///< coefficients along the ratio at no bed depth
  const double* level;     ///< level_coefficients() at no bed depth
  double per_pavement_scale;
};

/// The table's coefficients summed over the depth: speed × ratio × responses for one depth. Empty beyond the fitted
/// range.
std::vector<double> level_coefficients(const LoadTable&, double bed_depth);

/// Beyond the fitted range: the table itself. Results at `out` + 0, stride, 2 stride …: drag, vertical, rut depth, spin
/// ratio; then their slopes by speed, depth and penetration.
void load_at(const LoadTable&, double speed, double depth, double penetration, double* out, int stride);
void load_with_slopes_at(const LoadTable&, double speed, double depth, double penetration, double* out, int stride);

template <class V>
struct LoadLanes {
  V drag, vertical, rut_depth, spin_ratio;
};
template <class V>
struct SlopeLanes {
  LoadLanes<V> load;
  V drag[3], vertical[3], rut_depth[3], spin_ratio[3];  ///< by speed, bed depth, penetration
};

template <class V, int W>
class TableLanes {
 public:
  /// `level`: level_coefficients() at `level_depth`, or null.
  void set(int lane, const TableNumbers& n, const double* level, double level_depth) {
    level_[0][lane] = n.level;
    level_[1][lane] = level;
    no_depth_.set(lane, n.level ? 0.0 : -1.0);
    level_depth_.set(lane, level ? level_depth : -1.0);
    by_level_[lane] = static_cast<std::size_t>(4.0 * (n.ratios + 3.0));
    level_stride_.set(lane, 4.0 * (n.ratios + 3.0));
    first_[lane] = n.coefficients;
    table_[lane] = n.table;
    by_speed_[lane] = static_cast<std::size_t>(n.by_speed);
    by_depth_[lane] = static_cast<std::size_t>(n.by_depth);
    speed_low_.set(lane, n.speed_low), depth_low_.set(lane, n.depth_low), ratio_low_.set(lane, n.ratio_low);
    per_speed_.set(lane, n.per_speed), per_depth_.set(lane, n.per_depth), per_ratio_.set(lane, n.per_ratio);
    speeds_.set(lane, n.speeds), depths_.set(lane, n.depths), ratios_.set(lane, n.ratios);
    last_ratio_.set(lane, n.last_ratio);
    stride_i_.set(lane, n.by_speed), stride_j_.set(lane, n.by_depth);
    compaction_.set(lane, n.compaction), deflection_.set(lane, n.deflection);
    diameter_.set(lane, n.diameter), rounding_.set(lane, n.rounding);
    pavement_[lane] = n.pavement;
    per_pavement_scale_.set(lane, n.per_pavement_scale);
  }

  /// Loads of the lanes in `wanted`; those that do not touch the ground have none and a spin ratio of 1.
  template <class M>
  LoadLanes<V> load(const M& wanted, const V& contact_speed, const V& bed_depth, const V& penetration) const {
    const auto touches = wanted & (penetration > 0.0);
    const Place at = place(contact_speed, bed_depth, penetration);
    const auto inside = touches & at.inside;
    V weight[12];
    const Cell cell = weigh(at, inside, bed_depth, weight);
    const double* w = reinterpret_cast<const double*>(weight);
    Four sums_of[W];  // of lanes that are not inside: of something
    if (!any(inside & !cell.level)) {
      for (int lane = 0; lane < W; ++lane) sum_level(cell.first[lane], by_level_[lane], w + lane, sums_of[lane]);
    } else {
      for (int lane = 0; lane < W; ++lane)
        if (cell.level[lane])
          sum_level(cell.first[lane], by_level_[lane], w + lane, sums_of[lane]);
        else
          sum(cell.first[lane], by_speed_[lane], by_depth_[lane], w + lane, sums_of[lane]);
    }
    V r[4];
    across(sums_of, r);
    for (auto& each : r) each = select(inside, each, V(0.0));
    LoadLanes<V> loads{r[0], r[1], r[2], select(inside, 1.0 - r[3], V(1.0))};
    const auto beyond = touches & !at.inside;
    if (any(beyond)) [[unlikely]] {
      alignas(64) double out[4 * W] = {};
      for (int lane = 0; lane < W; ++lane)
        if (beyond[lane])
          load_at(*table_[lane], contact_speed[lane], bed_depth[lane], penetration[lane], out + lane, W);
      const V* o = reinterpret_cast<const V*>(out);
      loads = {select(beyond, o[0], loads.drag), select(beyond, o[1], loads.vertical),
               select(beyond, o[2], loads.rut_depth), select(beyond, o[3], loads.spin_ratio)};
    }
    return loads;
  }

  template <class M>
  SlopeLanes<V> load_with_slopes(const M& wanted, const V& contact_speed, const V& bed_depth,
                                 const V& penetration) const {
    const auto touches = wanted & (penetration > 0.0);
    const Place at = place(contact_speed, bed_depth, penetration);
    const auto inside = touches & at.inside;
    V weight[24];
    const Cell cell = weigh(at, inside, bed_depth, weight);
    weigh_slopes(at, inside, cell, weight);
    const double* w = reinterpret_cast<const double*>(weight);
    Four sums_of[4][W];  // value and slopes by speed, depth and ratio
    for (int lane = 0; lane < W; ++lane)
      if (cell.level[lane])
        sums_level(cell.first[lane], by_level_[lane], w + lane, lane, sums_of);
      else
        sums(cell.first[lane], by_speed_[lane], by_depth_[lane], w + lane, lane, sums_of);
    V r[16];
    for (int k = 0; k < 4; ++k) across(sums_of[k], r + 4 * k);
    for (auto& each : r) each = select(inside, each, V(0.0));
    const V per_penetration = 1.0 / at.scale;
    const auto raised = bed_depth < 0.0;
    const V zero(0.0);
    const V u_by_depth = select(raised, zero, 0.5 / (depth_reference * at.u));
    const V ratio_by_depth = select(raised, zero, -at.ratio * scale_slope(at.depth) * per_penetration);
    const V direction = select(contact_speed < 0.0, V(-1.0), V(1.0));
    SlopeLanes<V> all{{r[0], r[1], r[2], select(inside, 1.0 - r[3], V(1.0))}, {}, {}, {}, {}};
    const auto slopes = [&](int m, double sign, V* out) {
      out[0] = sign * direction * r[4 + m];
      out[1] = sign * (r[8 + m] * u_by_depth + r[12 + m] * ratio_by_depth);
      out[2] = sign * r[12 + m] * per_penetration;
    };
    slopes(0, 1.0, all.drag), slopes(1, 1.0, all.vertical), slopes(2, 1.0, all.rut_depth);
    slopes(3, -1.0, all.spin_ratio);
    const auto beyond = touches & !at.inside;
    if (any(beyond)) [[unlikely]] {
      alignas(64) double out[16 * W] = {};
      for (int lane = 0; lane < W; ++lane)
        if (beyond[lane])
          load_with_slopes_at(*table_[lane], contact_speed[lane], bed_depth[lane], penetration[lane], out + lane, W);
      const V* o = reinterpret_cast<const V*>(out);
      const auto take = [&](V& x, int k) { x = select(beyond, o[k], x); };
      take(all.load.drag, 0), take(all.load.vertical, 1), take(all.load.rut_depth, 2), take(all.load.spin_ratio, 3);
      for (int k = 0; k < 3; ++k)
        take(all.drag[k], 4 + k), take(all.vertical[k], 7 + k), take(all.rut_depth[k], 10 + k),
            take(all.spin_ratio[k], 13 + k);
    }
    return all;
  }

  /// LoadTable::load_on_pavement for the lanes in `wanted`, all of which touch; takes those beyond the fitted range out
  /// of `wanted`. Slopes are by penetration.
  struct OnPavement {
    LoadLanes<V> load, slope;
  };
  template <class M>
  OnPavement load_on_pavement(M& wanted, const V& penetration) const {
    const V ratio = penetration * per_pavement_scale_, steps = (ratio - ratio_low_) * per_ratio_;
    wanted = wanted & (steps >= 0.0) & (steps <= last_ratio_);
    const V s = select(wanted, steps, V(0.0)), down = floor(s), last = ratios_ - 1.0;
    const V first = select(down < last, down, last), t = s - first, q = 1.0 - t;
    const V value[4] = {q * q * q * (1.0 / 6.0), 2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
                        2.0 / 3.0 - q * q * (1.0 - 0.5 * q), t * t * t * (1.0 / 6.0)};
    const V slope[4] = {-0.5 * q * q * per_ratio_, 0.5 * t * (3.0 * t - 4.0) * per_ratio_,
                        0.5 * q * (4.0 - 3.0 * q) * per_ratio_, 0.5 * t * t * per_ratio_};
    V c[16];  // a run's coefficients, side by side
    for (int lane = 0; lane < W; ++lane)
      if (wanted[lane]) {
        const double* from = pavement_[lane] + static_cast<std::size_t>(first[lane] * 4.0);
        for (int k = 0; k < 16; ++k) c[k].set(lane, from[k]);
      }
    const auto sum = [&](const V* w, int m) {
      return (w[0] * c[m] + w[1] * c[4 + m]) + (w[2] * c[8 + m] + w[3] * c[12 + m]);
    };
    const auto along = [&](int m) { return sum(slope, m) * per_pavement_scale_; };
    return {{sum(value, 0), sum(value, 1), sum(value, 2), 1.0 - sum(value, 3)},
            {along(0), along(1), along(2), -sum(slope, 3) * per_pavement_scale_}};
  }

 private:
  struct Place {
    V speed, depth, u, ratio, scale;
    V v_steps, u_steps, r_steps;  ///< in intervals from the lower ends
    decltype(V() < V()) inside;
  };

  Place place(const V& contact_speed, const V& bed_depth, const V& penetration) const {
    Place at;
    at.depth = select(bed_depth > 0.0, bed_depth, V(0.0));
    const V a = compaction_ * at.depth + deflection_ - diameter_;
    at.scale = 0.5 * (a + 2.0 * diameter_ - sqrt(a * a + rounding_ * rounding_));
    at.speed = abs(contact_speed);
    at.u = sqrt(1.0 + at.depth * (1.0 / depth_reference));
    at.ratio = penetration / at.scale;
    at.v_steps = (at.speed - speed_low_) * per_speed_;
    at.u_steps = (at.u - depth_low_) * per_depth_;
    at.r_steps = (at.ratio - ratio_low_) * per_ratio_;
    at.inside = (at.v_steps >= 0.0) & (at.u_steps >= 0.0) & (at.r_steps >= 0.0) & (at.v_steps <= speeds_) &
                (at.u_steps <= depths_) & (at.r_steps <= last_ratio_);
    return at;
  }
  V scale_slope(const V& depth) const {
    const V a = compaction_ * depth + deflection_ - diameter_;
    return 0.5 * compaction_ * (1.0 - a / sqrt(a * a + rounding_ * rounding_));
  }

  /// Where a lane's sums begin: in the table of one of the two levels where the depth is that level's, else in the
  /// whole.
  struct Cell {
    decltype(V() < V()) level;
    const double* first[W];
  };

  /// First coefficient and place in its interval.
  template <class M>
  static V interval(const M& inside, const V& steps, const V& intervals, V& t) {
    const V s = select(inside, steps, V(0.0)), down = floor(s), last = intervals - 1.0;
    const V first = select(down < last, down, last);
    t = s - first;
    return first;
  }
  /// Weights of speed, depth (where it is not level for all) and ratio, four each.
  template <class M>
  Cell weigh(const Place& at, const M& inside, const V& bed_depth, V* w) const {
    const auto axis = [&](const V& steps, const V& intervals, V* weight) {
      V t;
      const V first = interval(inside, steps, intervals, t), q = 1.0 - t;
      weight[0] = q * q * q * (1.0 / 6.0);
      weight[1] = 2.0 / 3.0 - t * t * (1.0 - 0.5 * t);
      weight[2] = 2.0 / 3.0 - q * q * (1.0 - 0.5 * q);
      weight[3] = t * t * t * (1.0 / 6.0);
      return first;
    };
    const auto none = at.depth == no_depth_, second = bed_depth == level_depth_;
    Cell cell;
    cell.level = none | second;
    const V i = axis(at.v_steps, speeds_, w), k = axis(at.r_steps, ratios_, w + 8);
    V offset = i * level_stride_ + k * 4.0;
    if (any(inside & !cell.level)) {
      const V j = axis(at.u_steps, depths_, w + 4);
      offset = select(cell.level, offset, i * stride_i_ + j * stride_j_ + k * 4.0);
    }
    for (int lane = 0; lane < W; ++lane) {
      const double* base = none[lane] ? level_[0][lane] : second[lane] ? level_[1][lane] : first_[lane];
      cell.first[lane] = base + static_cast<std::size_t>(offset[lane]);
    }
    return cell;
  }
  template <class M>
  void weigh_slopes(const Place& at, const M& inside, const Cell& cell, V* w) const {
    const auto axis = [&](const V& steps, const V& intervals, const V& per_step, V* slope) {
      V t;
      interval(inside, steps, intervals, t);
      const V q = 1.0 - t;
      slope[0] = -0.5 * q * q * per_step;
      slope[1] = 0.5 * t * (3.0 * t - 4.0) * per_step;
      slope[2] = 0.5 * q * (4.0 - 3.0 * q) * per_step;
      slope[3] = 0.5 * t * t * per_step;
    };
    axis(at.v_steps, speeds_, per_speed_, w + 12), axis(at.r_steps, ratios_, per_ratio_, w + 20);
    if (any(inside & !cell.level)) axis(at.u_steps, depths_, per_depth_, w + 16);
  }

  using Part = typename V::Unaligned;
  typedef double Four __attribute__((vector_size(32), aligned(8), may_alias));
  static constexpr int parts = 16 / W;
  static const Part& part(const double* row, int p) { return *reinterpret_cast<const Part*>(row + p * W); }
  static const Four& four(const double* row) { return *reinterpret_cast<const Four*>(row); }

  static void along_ratio(const double* row, const double* r, Four& out) {
    out = r[0] * four(row) + r[W] * four(row + 4) + r[2 * W] * four(row + 8) + r[3 * W] * four(row + 12);
  }
  /// From four responses per lane to a vector across the lanes per response.
  static void across(const Four* rows, V* out) {
    if constexpr (W == 8) {
      Part pair[4];
      for (int k = 0; k < 4; ++k) pair[k] = __builtin_shufflevector(rows[k], rows[k + 4], 0, 1, 2, 3, 4, 5, 6, 7);
      const Part t0 = __builtin_shufflevector(pair[0], pair[1], 0, 8, 2, 10, 4, 12, 6, 14),
                 t1 = __builtin_shufflevector(pair[0], pair[1], 1, 9, 3, 11, 5, 13, 7, 15),
                 t2 = __builtin_shufflevector(pair[2], pair[3], 0, 8, 2, 10, 4, 12, 6, 14),
                 t3 = __builtin_shufflevector(pair[2], pair[3], 1, 9, 3, 11, 5, 13, 7, 15);
      out[0].v = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13);
      out[1].v = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13);
      out[2].v = __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15);
      out[3].v = __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15);
    } else {
      for (int k = 0; k < 4; ++k)
        for (int lane = 0; lane < W; ++lane) out[k].set(lane, rows[lane][k]);
    }
  }

  /// The sums of spline_sum.inl; weights W apart.
  static Part along_depth(const double* c, std::size_t by_j, const double* u, int p) {
    return u[0] * part(c, p) + u[W] * part(c + by_j, p) + u[2 * W] * part(c + 2 * by_j, p) +
           u[3 * W] * part(c + 3 * by_j, p);
  }
  static void sum(const double* first, std::size_t by_i, std::size_t by_j, const double* w, Four& out) {
    sum_rows([&](int i, int p) { return along_depth(first + static_cast<std::size_t>(i) * by_i, by_j, w + 4 * W, p); },
             w, out);
  }
  static void sum_level(const double* first, std::size_t by_i, const double* w, Four& out) {
    sum_rows([&](int i, int p) { return part(first + static_cast<std::size_t>(i) * by_i, p); }, w, out);
  }
  template <class Line>
  static void sum_rows(const Line& line, const double* w, Four& out) {
    alignas(64) double row[16];
    for (int p = 0; p < parts; ++p) {
      Part total{};
      for (int i = 0; i < 4; ++i) total += w[i * W] * line(i, p);
      *reinterpret_cast<Part*>(row + p * W) = total;
    }
    along_ratio(row, w + 8 * W, out);
  }
  static void sums(const double* first, std::size_t by_i, std::size_t by_j, const double* w, int lane,
                   Four (&out)[4][W]) {
    const auto along = [&](int i, const double* u, int p) {
      return along_depth(first + static_cast<std::size_t>(i) * by_i, by_j, u, p);
    };
    alignas(64) double by_u[16];
    for (int p = 0; p < parts; ++p) {
      Part along_u{};
      for (int i = 0; i < 4; ++i) along_u += w[i * W] * along(i, w + 16 * W, p);
      *reinterpret_cast<Part*>(by_u + p * W) = along_u;
    }
    sums_rows([&](int i, int p) { return along(i, w + 4 * W, p); }, w, lane, out);
    along_ratio(by_u, w + 8 * W, out[2][lane]);
  }
  /// Without slopes by the depth, which does not change there.
  static void sums_level(const double* first, std::size_t by_i, const double* w, int lane, Four (&out)[4][W]) {
    sums_rows([&](int i, int p) { return part(first + static_cast<std::size_t>(i) * by_i, p); }, w, lane, out);
    out[2][lane] = Four{};
  }
  template <class Line>
  static void sums_rows(const Line& line, const double* w, int lane, Four (&out)[4][W]) {
    alignas(64) double row[16], by_v[16];
    for (int p = 0; p < parts; ++p) {
      Part total{}, along_v{};
      for (int i = 0; i < 4; ++i) {
        const Part at = line(i, p);
        total += w[i * W] * at;
        along_v += w[(12 + i) * W] * at;
      }
      *reinterpret_cast<Part*>(row + p * W) = total;
      *reinterpret_cast<Part*>(by_v + p * W) = along_v;
    }
    along_ratio(row, w + 8 * W, out[0][lane]);
    along_ratio(by_v, w + 8 * W, out[1][lane]);
    along_ratio(row, w + 20 * W, out[3][lane]);
  }

  const double* first_[W] = {};
  const LoadTable* table_[W] = {};
  const double *pavement_[W] = {}, *level_[2][W] = {};
  std::size_t by_level_[W] = {};
  V no_depth_ = -1.0, level_depth_ = -1.0, level_stride_ = 0.0;
  std::size_t by_speed_[W] = {}, by_depth_[W] = {};
  V speed_low_ = 0.0, depth_low_ = 0.0, ratio_low_ = 0.0, per_speed_ = 1.0, per_depth_ = 1.0, per_ratio_ = 1.0;
  V speeds_ = 1.0, depths_ = 1.0, ratios_ = 1.0, last_ratio_ = 1.0, stride_i_ = 0.0, stride_j_ = 0.0;
  V compaction_ = 0.0, deflection_ = 1.0, diameter_ = 1.0, rounding_ = 0.0, per_pavement_scale_ = 1.0;
};

}  // namespace apc::loadtables
