/// What a leading wheel row left behind: crushed depth, penetration and loads along the bed. The one memory of a run:
/// written after accepted steps only, read as const by the equations, so a solver may retry a step freely.
#pragma once

#include <cstddef>
#include <vector>

namespace apc::simulation {

/// The track of one row at one place.
struct Rut {
  double depth = 0.0;                 ///< m, crushed depth
  double penetration = 0.0;           ///< m, the penetration whose virgin rut this is
  double drag = 0.0, vertical = 0.0;  ///< N per tire, that virgin penetration's loads
  double depth_slope = 0.0;           ///< d depth / d distance; like the next two only filled by reading
  double penetration_slope = 0.0, vertical_slope = 0.0;
};

/// Grows along the bed only; between entries a C¹ cubic whose slopes come from the parabola through three entries, so
/// that a smooth track is read back without kinks a solver would notice.
class RutLog {
 public:
  /// Ignored unless `distance` lies at least 1 mm beyond the last entry.
  void write(double distance, const Rut&);
  /// The track turns sharply at the last entry: slopes before and after it are not those of one curve.
  void turn();
  /// Nothing (depth 0) before the first entry; the last entry beyond the last.
  Rut at(double distance) const;
  /// The same without its slopes.
  Rut values_at(double distance) const;

  /// An entry with the slopes there; those of the last one are of the secant before it until the next is written.
  struct Entry {
    double value[4], slope[4];  ///< depth, penetration, drag, vertical
  };
  /// What at() reads between: a cubic from `before` to `after`, or (`after` null) the value of `before` alone. Searches
  /// from entry `near`, where it was found last, and leaves there where it was found now.
  struct Between {
    double from, to;
    const Entry *before, *after;
  };
  Between between(double distance, std::size_t& near) const;

  double last_distance() const;
  bool empty() const { return entries_.empty(); }
  void clear();

 private:
  bool begins(std::size_t entry) const;
  template <bool with_slopes>
  Rut read(double distance, std::size_t& near) const;
  std::vector<double> distances_;  ///< apart from the entries, so that a search passes over few bytes
  std::vector<Entry> entries_;
};

}  // namespace apc::simulation
