/// @file
/// Slabs as bounding volumes: a point between each pair of planes, and two bodies' slabs compared.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/running_error.hpp>
#include <contact/slab_facets.hpp>
#include <contact/vector.hpp>

namespace contact {

// [plane-normals]
/// The normals of the usual k-DOPs of the plane: two axes, and with k = 8 the two diagonals.
///
/// Their z is 0, so in space each is a prism without an end in z.
/// @param k 4 or 8
/// @throws std::invalid_argument for another k
template <Ring S>
std::vector<Vector3<S>> plane_dop_normals(int k) {
  if (k != 4 && k != 8) throw_invalid_argument("k", std::to_string(k), "must be 4 or 8");
  const auto v = [](int x, int y) { return Vector3<S>(S(x), S(y), S(0)); };
  std::vector<Vector3<S>> normals{v(1, 0), v(0, 1)};
  if (k == 8) {
    normals.push_back(v(1, 1));
    normals.push_back(v(1, -1));
  }
  return normals;
}
// [/plane-normals]

namespace detail {

/// Whether low ≤ normal · point ≤ high. Bounded numbers decide where they are certain, else exact
/// ones. An infinite bound excludes nothing, or all.
template <FloatOrDouble S>
bool between(const Vector3<S>& normal, S low, S high, const Vector3<S>& point) {
  const auto in_double = [](const Vector3<S>& v) -> Vector3<double> {
    return v.template cast<double>();
  };
  const auto n = in_double(normal), x = in_double(point);
  const RunningError rough = dot(triple<RunningError>(n), triple<RunningError>(x));
  if (rough.value - rough.bound > low && rough.value + rough.bound < high) return true;
  const Exact at = dot(triple<Exact>(n), triple<Exact>(x));
  const auto at_least = [&](S bound) {
    return std::isfinite(bound) ? at >= Exact(static_cast<double>(bound)) : bound < S(0);
  };
  const auto at_most = [&](S bound) {
    return std::isfinite(bound) ? at <= Exact(static_cast<double>(bound)) : bound > S(0);
  };
  return at_least(low) && at_most(high);
}

}  // namespace detail

// [contains-kdop]
/// Whether a point is between each pair of planes. A point on a plane is; without pairs every point
/// is.
///
/// Exact for the stored numbers. low = −∞ or high = ∞, which rounding outwards makes of an
/// overflow, excludes no point. If another number is not finite: false.
template <FloatOrDouble S>
bool contains(const Kdop<S>& dop, const Vector3<S>& point) {
  if (!all_finite(point)) return false;
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    if (!all_finite(dop.normals[k])) return false;
    if (!detail::between(dop.normals[k], dop.low[k], dop.high[k], point)) return false;
  }
  return true;
}
// [/contains-kdop]

// [slabs-overlap]
/// Whether the slabs of two k-DOPs overlap along each normal. Touching counts.
///
/// Two k-DOPs with a common point always do: its normal · x is in both slabs. The converse is
/// false: the test only compares along the given normals, and another plane may separate the two.
/// Nothing is rounded, so the result is exact for the stored numbers. An empty k-DOP (low > high)
/// meets none; infinite bounds are compared as numbers; NaN: false.
/// @throws std::invalid_argument if the normals are not the same, in the same order
template <FloatOrDouble S>
bool may_meet(const Kdop<S>& a, const Kdop<S>& b) {
  if (a.normals != b.normals) {
    throw_invalid_argument("b.normals", std::to_string(b.normals.size()) + " normals",
                           "must be those of a, in the same order");
  }
  for (std::size_t k = 0; k < a.normals.size(); ++k) {
    if (!(a.low[k] <= b.high[k] && b.low[k] <= a.high[k] && a.low[k] <= a.high[k] &&
          b.low[k] <= b.high[k])) {
      return false;
    }
  }
  return true;
}
// [/slabs-overlap]

}  // namespace contact
