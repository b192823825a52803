/// @file
/// The fifteen axes that decide whether two boxes are separated.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>

#include <contact/convex_shapes.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The number of candidate axes of two boxes: three face normals of each, and nine pairs of edges.
inline constexpr int box_axis_count = 15;

// [box-axis]
/// Candidate axis k for the separation of two boxes: 0 to 2 are the face normals of A, 3 to 5 those
/// of B, 6 to 14 are perpendicular to one edge of each (6 + 3 i + j: edge i of A, edge j of B).
///
/// Face normals are cross products of edges, not the stored axes: so they are right for the stored
/// parallelepiped, even if rounding has made it oblique. Parallel edges give 0, which is no
/// direction.
/// @return of any length
/// @see Gottschalk, Lin and Manocha, *OBBTree*, SIGGRAPH 1996
template <Ring S>
Vector3<S> box_axis(const OrientedBox<S>& a, const OrientedBox<S>& b, int k) {
  if (k < 6) {
    const Matrix3<S>& axes = k < 3 ? a.axes : b.axes;
    return Vector3<S>(axes.col((k + 1) % 3)).cross(Vector3<S>(axes.col((k + 2) % 3)));
  }
  return Vector3<S>(a.axes.col((k - 6) / 3)).cross(Vector3<S>(b.axes.col((k - 6) % 3)));
}
// [/box-axis]

namespace detail {

template <Ring S>
S magnitude(const S& x) {
  return x < S(0) ? S(-x) : x;
}

}  // namespace detail

/// The support of a box along n, from its centre, times |n|: Σ hᵢ |n · aᵢ|.
template <Ring S>
S projected_radius(const OrientedBox<S>& box, const Vector3<S>& n) {
  S half_extent(0);
  for (int i = 0; i < 3; ++i) {
    half_extent = half_extent +
                  S(box.half_lengths(i)) * detail::magnitude<S>(n.dot(Vector3<S>(box.axes.col(i))));
  }
  return half_extent;
}

// [separation-along]
/// The signed separation between the projections of two boxes on n, times |n|: positive if a plane
/// perpendicular to n separates them, 0 if both touch such a plane from its two sides, negative if
/// the projections overlap.
template <Ring S>
S separation_along(const OrientedBox<S>& a, const OrientedBox<S>& b, const Vector3<S>& n) {
  const Vector3<S> between = a.centre - b.centre;
  return detail::magnitude<S>(n.dot(between)) - projected_radius(a, n) - projected_radius(b, n);
}
// [/separation-along]

namespace detail {

/// Whether the coordinates are within the range of the bounds below: nothing overflows, and
/// underflow does not matter beside a bound of at least 2^-600.
inline bool in_filter_range(double size) { return size >= 0x1p-600 && size <= 0x1p600; }

/// The sign of the separation along axis k: 1, 0 or −1, and 2 for an axis that is exactly 0.
///
/// Floating-point filter first. The error of each entry of the axis is at most γ(2) Mᵢ, where Mᵢ is
/// the sum of the absolute values of its products. A term of the separation has at most 14
/// roundings: two in the axis, one in the difference of the centres or the product with a half
/// length, three in the dot product, and eight in the sums. So the error of the separation is at
/// most γ(14) (M · |between|
/// + Σ hᵢ M · |aᵢ| + Σ hⱼ M · |bⱼ|); γ(32) includes the rounding of the bound.
inline int sign_of_separation(const OrientedBox<double>& a, const OrientedBox<double>& b, int k) {
  const Vector3<double> u = k < 6 ? (k < 3 ? a : b).axes.col((k + 1) % 3) : a.axes.col((k - 6) / 3);
  const Vector3<double> v = k < 6 ? (k < 3 ? a : b).axes.col((k + 2) % 3) : b.axes.col((k - 6) % 3);
  const Vector3<double> products(std::abs(u.y() * v.z()) + std::abs(u.z() * v.y()),
                                 std::abs(u.z() * v.x()) + std::abs(u.x() * v.z()),
                                 std::abs(u.x() * v.y()) + std::abs(u.y() * v.x()));
  const Vector3<double> half_extent_a = a.axes.cwiseAbs() * a.half_lengths.cwiseAbs();
  const Vector3<double> half_extent_b = b.axes.cwiseAbs() * b.half_lengths.cwiseAbs();
  const Vector3<double> all = (a.centre - b.centre).cwiseAbs() + half_extent_a + half_extent_b;
  const double size = products.dot(all);
  const double separation = separation_along<double>(a, b, box_axis(a, b, k));
  const double bound = tolerance::gamma<double>(32) * size + 0x1p-1060 * (1 + all.sum());
  if (in_filter_range(size) && std::abs(separation) > bound) {
    return separation > 0 ? 1 : -1;
  }
  const auto exact = [](const OrientedBox<double>& box) {
    OrientedBox<Exact> e{exact_vector<double>(box.centre), Matrix3<Exact>(),
                         exact_vector<double>(box.half_lengths)};
    for (int i = 0; i < 3; ++i) e.axes.col(i) = exact_vector<double>(box.axes.col(i));
    return e;
  };
  const OrientedBox<Exact> ea = exact(a);
  const OrientedBox<Exact> eb = exact(b);
  const Vector3<Exact> n = box_axis(ea, eb, k);
  if (n == Vector3<Exact>::Zero()) return 2;
  return separation_along(ea, eb, n).sign();
}

}  // namespace detail

}  // namespace contact
