/// @file
/// Oriented boxes: plain data, construction, pose, corners and edges, and bounding box.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/aabb.hpp>
#include <contact/coordinate_range.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>
#include <contact/shapes.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// An oriented box: all points centre + Σ xᵢ axesᵢ with |xᵢ| ≤ half lengthᵢ.
///
/// Boxes have half lengths: from the centre to a face, half of an edge.
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

/// World coordinates of a box given in the frame.
/// @return its centre is off as position_in_world() is, each entry of its axes by at most γ(3) of
/// the sum of the absolute values of its terms
template <Ring S>
OrientedBox<S> transformed(const OrientedBox<S>& shape, const CoordinateFrame<S>& frame) {
  return {position_in_world(frame, shape.centre), Matrix3<S>(frame.axes * shape.axes),
          shape.half_lengths};
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

// [aabb-of-oriented-box]
/// An axis-aligned box that contains an oriented box: centre ± Σ |axisⱼ| hⱼ.
///
/// The error of the computed sum s is at most γ(3) s, plus 3 η / 2 where products underflow; s +
/// γ(8) s + 2 η is above the exact sum, its own three roundings included.
/// @param box m, finite; half lengths may be 0, but not negative; the axes are taken as stored
/// @throws std::invalid_argument if the box does not satisfy this, or the result overflows
template <std::floating_point S>
Aabb<S> aabb_of_oriented_box(const OrientedBox<S>& box) {
  require_finite("centre", box.centre);
  require_finite("half_lengths", box.half_lengths);
  for (int k = 0; k < 3; ++k) {
    if (box.half_lengths(k) < S(0)) {
      throw_invalid_argument("half_lengths", vector_text(box.half_lengths), "must not be negative");
    }
  }
  Aabb<S> bounds;
  for (int k = 0; k < 3; ++k) {
    S half_extent(0);
    for (int j = 0; j < 3; ++j) half_extent += std::abs(box.axes(k, j)) * box.half_lengths(j);
    half_extent += tolerance::gamma<S>(8) * half_extent + S(2) * tolerance::underflow_unit<S>;
    if (!std::isfinite(half_extent)) {
      throw_invalid_argument("half_lengths", vector_text(box.half_lengths), "its box overflows");
    }
    bounds.low(k) = sum_down(box.centre(k), -half_extent);
    bounds.high(k) = sum_up(box.centre(k), half_extent);
  }
  return detail::require_in_range("centre", box.centre, bounds);
}
// [/aabb-of-oriented-box]

}  // namespace contact
