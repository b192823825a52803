/// @file
/// Poses: a position with an orientation as a quaternion, and the frame that is the same with a
/// matrix.
#pragma once

#include <concepts>

#include <contact/frame.hpp>
#include <contact/quaternion.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A position and an orientation. A `CoordinateFrame` is the same with a rotation matrix: a pose is
/// stored and integrated, a frame transforms points.
template <Ring S>
struct Pose {
  Vector3<S> position = Vector3<S>::Zero();  ///< of the body's origin in the world, m
  Quaternion<S> orientation;                 ///< from body to world
};

/// The frame of a pose.
/// @param pose with an orientation of length 1; one that is off by a few u gives axes that are
template <Ring S>
CoordinateFrame<S> frame_of(const Pose<S>& pose) {
  return {pose.position, matrix_of(pose.orientation)};
}

/// The pose of a frame.
/// @return with w ≥ 0, off as quaternion_of() is
template <std::floating_point S>
Pose<S> pose_of(const CoordinateFrame<S>& frame) {
  return {frame.origin, quaternion_of(frame.axes)};
}

}  // namespace contact
