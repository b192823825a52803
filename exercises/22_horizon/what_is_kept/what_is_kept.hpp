/// @file
/// Exercise: which quantities a scene conserves, whatever its balls do.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A kind of scene: balls of any number, radii and masses, which fly freely between impacts with
/// each other and with fixed walls. Their masses are spread evenly or at least alike in all
/// directions.
struct Scene {
  Eigen::Vector3d gravity;               ///< m/s^2, the same everywhere, perhaps 0
  std::vector<Eigen::Vector3d> normals;  ///< unit normals of the walls: flat, smooth, infinite
  /// All impacts are elastic (k = 1). Otherwise k is less than 1 in all impacts, and at least 0.
  bool elastic;
  /// Friction acts between two balls that touch, and makes them rotate. On walls none does.
  bool friction;
  /// All centres start on the z axis, all velocities are along it, and nothing rotates. In such a
  /// scene gravity and all normals are along z too. Otherwise balls may start anywhere and move in
  /// any direction.
  bool on_z_axis;
};

/// What stays as it was at the start.
struct Kept {
  /// Kinetic energy, of rotation too, plus potential energy in the field of gravity.
  bool energy;
  std::array<bool, 3> momentum;  ///< the sum of all m v: its components along x, y and z
  /// The angular momentum of all balls about the origin, with that of their rotation: its
  /// components along x, y and z.
  std::array<bool, 3> angular_momentum;
  bool order;  ///< the order of the centres along z
};

/// What is conserved in every scene of this kind, for all time.
///
/// A quantity that some scene of this kind changes is not conserved. A component that is always 0
/// is. Zero is exact: the smallest component of gravity or of a normal counts.
Kept what_is_kept(const Scene& scene);

}  // namespace exercise
