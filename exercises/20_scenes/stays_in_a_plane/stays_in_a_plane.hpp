/// @file
/// Exercise: along which axes nothing ever moves, as the planner proves it.
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
/// Reflect the whole scene in a plane across the axis. If the plane can be chosen so that each
/// ball, its velocity, each wall and gravity are their own images, then so is the motion: the laws
/// of motion know no left and right. What is its own image never leaves the plane.
///
/// It says yes only where that is so to the last bit. It does not ask who meets whom: a ball that
/// is nowhere near the others, and a wall that no ball reaches, count like all others.
std::array<bool, 3> still_axes(const Scene& scene);

}  // namespace exercise
