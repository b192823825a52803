/// @file
/// Exercise: the plane through three points.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The plane through three points: normal·x = offset, with a unit normal.
///
/// Seen from the front, where the normal points, a, b and c run counter-clockwise.
///
/// - Three points on one line have no plane of their own: throws std::invalid_argument. On one line
///   means exactly that: a thin or a tiny triangle still has a plane.
/// - Size does not matter: a triangle a nanometre wide has a plane as good as one a kilometre wide.
///
/// @param a, b, c points, m, all finite
contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c);

}  // namespace exercise
