/// @file
/// The convex bodies of this book as plain data, and functions that check them.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A half-space: all points with n · x ≤ k. The normal points out of the body.
template <Ring S>
struct HalfSpace {
  Plane<S> boundary;  ///< offset in m
};

/// An oriented box: all points centre + Σ xᵢ axesᵢ with |xᵢ| ≤ half lengthᵢ.
///
/// The axes are the columns of a rotation. A stored rotation is rounded, so the stored body is a
/// parallelepiped that differs from the box by a few u of its size. Exact decisions are about the
/// stored body.
template <Ring S>
struct OrientedBox {
  Vector3<S> centre = Vector3<S>::Zero();        ///< m
  Matrix3<S> axes = Matrix3<S>::Identity();      ///< columns in world coordinates
  Vector3<S> half_lengths = Vector3<S>::Zero();  ///< along each axis, m, greater than 0
};

/// A capsule: all points at most radius from a segment. Equal ends make it a sphere.
template <Ring S>
struct Capsule {
  Segment<S> core;  ///< m
  S radius = S(0);  ///< m, not negative
};

/// The largest coordinate, and the inverse of the smallest size, that the functions here accept:
/// 2^250 for double and long double, 2^25 for float. In this range no product of this chapter
/// overflows.
template <std::floating_point S>
inline constexpr S furthest_coordinate = std::numeric_limits<S>::digits > 24 ? S(0x1p250)
                                                                             : S(0x1p25);

namespace detail {

template <std::floating_point S>
void require_extent(const char* argument, const S& x, bool positive) {
  require_finite(argument, x);
  if (x < S(0) || (positive && !(x > S(0)))) {
    throw_invalid_argument(argument, number_text(x),
                           positive ? "must be greater than 0" : "must not be negative");
  }
  if (x > furthest_coordinate<S> || (x > S(0) && x < S(1) / furthest_coordinate<S>)) {
    throw_invalid_argument(argument, number_text(x), "is out of range");
  }
}
template <std::floating_point S>
void require_position(const char* argument, const Vector3<S>& x) {
  require_finite(argument, x);
  if (x.cwiseAbs().maxCoeff() > furthest_coordinate<S>) {
    throw_invalid_argument(argument, vector_text(x), "is out of range");
  }
}

}  // namespace detail

/// A sphere from input.
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
Sphere<S> sphere_from_radius(const Vector3<S>& centre, const S& radius) {
  detail::require_position("centre", centre);
  detail::require_extent("radius", radius, false);
  return {centre, radius};
}

/// A capsule from input.
/// @param start, end of the segment, m; they may be equal
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
Capsule<S> capsule_from_segment(const Vector3<S>& start, const Vector3<S>& end, const S& radius) {
  detail::require_position("start", start);
  detail::require_position("end", end);
  detail::require_extent("radius", radius, false);
  return {{start, end}, radius};
}

/// A box from input.
/// @param axes a rotation: columns of length 1, orthogonal to within 64 u, right-handed
/// @param half_lengths m, each greater than 0
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
OrientedBox<S> oriented_box_from_axes(const Vector3<S>& centre, const Matrix3<S>& axes,
                                      const Vector3<S>& half_lengths) {
  detail::require_position("centre", centre);
  for (int i = 0; i < 3; ++i) detail::require_extent("half_lengths", half_lengths(i), true);
  const Matrix3<S> off = axes.transpose() * axes - Matrix3<S>::Identity();
  const S room = S(32) * std::numeric_limits<S>::epsilon();
  const S volume = Vector3<S>(axes.col(0)).cross(Vector3<S>(axes.col(1))).dot(axes.col(2));
  if (!all_finite(axes) || !(off.cwiseAbs().maxCoeff() <= room) || !(volume > S(0))) {
    throw_invalid_argument("axes",
                           vector_text(Vector3<S>(axes.col(0))) + ", " +
                               vector_text(Vector3<S>(axes.col(1))) + ", " +
                               vector_text(Vector3<S>(axes.col(2))),
                           "the columns must be a right-handed orthonormal frame");
  }
  return {centre, axes, half_lengths};
}

/// A half-space from its boundary plane.
/// @throws std::invalid_argument if the normal's length is not 1 to within 8 u, or the offset is
/// not finite or out of range
template <std::floating_point S>
HalfSpace<S> half_space_behind(const Plane<S>& boundary) {
  require_finite("normal", boundary.normal);
  detail::require_extent("offset", S(std::abs(boundary.offset)), false);
  const S off = boundary.normal.dot(boundary.normal) - S(1);
  if (!(std::abs(off) <= S(8) * std::numeric_limits<S>::epsilon())) {
    throw_invalid_argument("normal", vector_text(boundary.normal), "must have length 1");
  }
  return {boundary};
}

// [corner]
/// Corner k of a box, from 0 to 7: bit i of k says whether it is on the positive side of axis i.
/// @return m; error at most γ(7) of the sum of the absolute values of its terms
template <Ring S>
Vector3<S> box_corner(const OrientedBox<S>& box, int k) {
  Vector3<S> corner = box.centre;
  for (int i = 0; i < 3; ++i) {
    const Vector3<S> half_extent = Vector3<S>(box.axes.col(i)) * S(box.half_lengths(i));
    if (((k >> i) & 1) != 0) {
      corner = corner + half_extent;
    } else {
      corner = corner - half_extent;
    }
  }
  return corner;
}

/// Edge k of a box, from 0 to 11: four along each axis, those of axis k / 4.
template <Ring S>
Segment<S> box_edge(const OrientedBox<S>& box, int k) {
  const int along = k / 4;
  const int first = (along + 1) % 3;
  const int second = (along + 2) % 3;
  const int corner = ((k & 1) << first) | (((k >> 1) & 1) << second);
  return {box_corner(box, corner), box_corner(box, corner | (1 << along))};
}
// [/corner]

/// A sphere as a capsule with a segment of length 0.
template <Ring S>
Capsule<S> as_capsule(const Sphere<S>& sphere) {
  return {{sphere.centre, sphere.centre}, sphere.radius};
}

}  // namespace contact
