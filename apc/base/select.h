/// Choices that work for one number and for several side by side (apc/simulation/lanes.h): laws written with them
/// serve both, with the same operations in the same order.
#pragma once

namespace apc {

template <class T>
inline const T& select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
/// Whether a condition holds for any, or for all, of the numbers side by side.
inline bool any(bool condition) { return condition; }
inline bool all(bool condition) { return condition; }

}  // namespace apc
