/// @file
/// From three dimensions to two: the cross product in the plane, and dropping a coordinate.
#pragma once

#include <contact/vector.hpp>

namespace contact {

/// The cross product of two vectors of the plane: the signed area of the parallelogram u, v,
/// positive if v is to the left of u.
template <Ring S>
S cross2(const Vector2<S>& u, const Vector2<S>& v) {
  return u.x() * v.y() - u.y() * v.x();
}

// [largest-dimension]
/// The index (0, 1 or 2) of the coordinate in which |v| is largest; the first of equals.
template <Ring S>
int largest_dimension(const Vector3<S>& v) {
  const auto magnitude = [&v](int i) { return v[i] < S(0) ? S(-v[i]) : S(v[i]); };
  int largest = 0;
  if (magnitude(1) > magnitude(largest)) largest = 1;
  if (magnitude(2) > magnitude(largest)) largest = 2;
  return largest;
}

/// v without coordinate k. The other two are in cyclic order (yz, zx or xy), so that the
/// two-dimensional cross product keeps its sign: cross2(drop(u, k), drop(v, k)) is coordinate k of
/// u × v.
template <Ring S>
Vector2<S> drop_dimension(const Vector3<S>& v, int k) {
  return {v[(k + 1) % 3], v[(k + 2) % 3]};
}
// [/largest-dimension]

}  // namespace contact
