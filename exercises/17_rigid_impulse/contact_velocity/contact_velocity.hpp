/// @file
/// Exercise: the velocity of a point of a rotating body, and whether two bodies close.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The motion of a rigid body at one moment, in the axes of the world.
struct Motion {
  Eigen::Vector3d centre;            ///< of mass, m
  Eigen::Vector3d velocity;          ///< of the centre of mass, m/s
  Eigen::Vector3d angular_velocity;  ///< angular velocity, rad/s
};

/// The three cases of the normal velocity of two bodies in contact.
enum class Closing { approaching, touching, separating };

/// The velocity of the point of the body that is at `point` now, in m/s.
///
/// @param body its motion
/// @param point in the world, m
Eigen::Vector3d velocity_of_point(const Motion& body, const Eigen::Vector3d& point);

/// Whether two bodies in contact at `point` approach each other, touch without normal velocity, or
/// separate.
///
/// @param a, b the two bodies
/// @param point in the world, m
/// @param normal unit vector, from B to A
Closing closing(const Motion& a, const Motion& b, const Eigen::Vector3d& point,
                const Eigen::Vector3d& normal);

}  // namespace exercise
