/// @file
/// Frames other than the world's: conversion of positions, directions and shapes to and from
/// them.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/invalid_argument.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [coordinate-frame]
/// A position and an orientation: an origin and three axes.
///
/// The columns of `axes` are the frame's own x, y and z axis, written in world coordinates. They
/// are orthonormal and right-handed (x × y = z), so the inverse of `axes` is its transpose. Other
/// axes are a programming error, not an input error.
template <Ring S>
struct CoordinateFrame {
  Vector3<S> origin = Vector3<S>::Zero();    ///< in world coordinates, m
  Matrix3<S> axes = Matrix3<S>::Identity();  ///< no unit of measure
};
// [/coordinate-frame]

// [frame-functions]
/// World coordinates of a position given in the frame.
/// @param p m, in the frame
/// @return m, in the world; off by at most γ(4) times (|origin| + Σ|axes||p|) for each coordinate
template <Ring S>
Vector3<S> position_in_world(const CoordinateFrame<S>& frame, const Vector3<S>& p) {
  return frame.origin + frame.axes * p;
}

/// Coordinates in the frame of a position given in the world. The origin is subtracted first.
/// @param p m, in the world
/// @return m, in the frame; off by at most γ(4) Σ|axes|(|p| + |origin|) for each coordinate, and
/// much less if p is near the origin of the frame
template <Ring S>
Vector3<S> position_in_frame(const CoordinateFrame<S>& frame, const Vector3<S>& p) {
  return frame.axes.transpose() * Vector3<S>(p - frame.origin);
}

/// World coordinates of a direction, a velocity or a force given in the frame: it rotates with the
/// axes, and the origin does not enter.
template <Ring S>
Vector3<S> direction_in_world(const CoordinateFrame<S>& frame, const Vector3<S>& v) {
  return frame.axes * v;
}

/// Coordinates in the frame of a direction, a velocity or a force given in the world.
template <Ring S>
Vector3<S> direction_in_frame(const CoordinateFrame<S>& frame, const Vector3<S>& v) {
  return frame.axes.transpose() * v;
}
// [/frame-functions]

/// World coordinates of a segment given in the frame.
template <Ring S>
Segment<S> transformed(const Segment<S>& segment, const CoordinateFrame<S>& frame) {
  return {position_in_world(frame, segment.start), position_in_world(frame, segment.end)};
}

/// World coordinates of a sphere given in the frame.
template <Ring S>
Sphere<S> transformed(const Sphere<S>& sphere, const CoordinateFrame<S>& frame) {
  return {position_in_world(frame, sphere.centre), sphere.radius};
}

// [frame-on-normal]
/// A frame whose z axis is the direction of the normal; x and y are any axes in the plane.
///
/// The axes are orthonormal to a few u (u the unit roundoff): no entry of axesᵀ axes is off by more
/// than 32 u. It is equally accurate for all directions. The axes are discontinuous where z of the
/// normal changes its sign: no choice of axes is continuous on the whole sphere (hairy ball
/// theorem).
/// @param origin m
/// @param normal any finite vector but 0
/// @throws std::invalid_argument if the normal is 0 or an entry is not finite
///
/// Source: Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, *Building an Orthonormal
/// Basis, Revisited*, Journal of Computer Graphics Techniques 6 (2017).
template <std::floating_point S>
CoordinateFrame<S> frame_on_normal(const Vector3<S>& origin, const Vector3<S>& normal) {
  require_finite("origin", origin);
  require_finite("normal", normal);
  int power = 0;
  const S largest = normal.cwiseAbs().maxCoeff();
  if (largest == S(0)) {
    throw_invalid_argument("normal", vector_text(normal), "it has no direction");
  }
  std::frexp(largest, &power);
  const Vector3<S> near_one(std::ldexp(normal.x(), -power), std::ldexp(normal.y(), -power),
                            std::ldexp(normal.z(), -power));
  const Vector3<S> n = near_one / std::sqrt(near_one.dot(near_one));

  const S sign = std::copysign(S(1), n.z());
  const S a = S(-1) / (sign + n.z());
  const S b = n.x() * n.y() * a;
  CoordinateFrame<S> frame;
  frame.origin = origin;
  frame.axes.col(0) = Vector3<S>(S(1) + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
  frame.axes.col(1) = Vector3<S>(b, sign + n.y() * n.y() * a, -n.y());
  frame.axes.col(2) = n;
  return frame;
}
// [/frame-on-normal]

}  // namespace contact
