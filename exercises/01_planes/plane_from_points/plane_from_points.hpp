/// @file
/// Exercise: the plane through three points.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The plane through three points: normal·x = offset, with a unit normal.
///
/// Seen from the front, to which the normal points, a, b and c are counter-clockwise.
///
/// - Three points exactly on one line determine no plane: throws std::invalid_argument. A thin or a
///   tiny triangle still has a plane.
/// - Size does not matter, from nanometres to kilometres.
///
/// @param a, b, c points, m, all finite
contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c);

}  // namespace exercise
