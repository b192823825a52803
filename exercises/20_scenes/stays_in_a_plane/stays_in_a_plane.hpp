/// @file
/// Exercise: along which axes no ball ever moves, proven by mirror symmetry.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A smooth ball. Its size does not matter here.
struct Ball {
  Eigen::Vector3d centre;    ///< m
  Eigen::Vector3d velocity;  ///< m/s
};

/// A scene at its beginning.
struct Scene {
  Eigen::Vector3d gravity;               ///< m/s²
  std::vector<Ball> balls;               ///< one or more
  std::vector<Eigen::Vector3d> normals;  ///< unit normals of the flat, smooth walls
};

/// For x, y and z: whether this proves that no ball ever moves along the axis.
///
/// Reflect the whole scene in a plane perpendicular to the axis. If the plane can be chosen so that
/// each ball, its velocity, each wall and gravity are their own images, then so is the motion,
/// because the laws of motion are symmetric under reflection. A ball that is its own image never
/// leaves the plane.
///
/// It returns true only where that holds exactly. It does not depend on which bodies meet: a ball
/// far from the others, and a wall that no ball reaches, count like all others.
std::array<bool, 3> inactive_axes(const Scene& scene);

}  // namespace exercise
