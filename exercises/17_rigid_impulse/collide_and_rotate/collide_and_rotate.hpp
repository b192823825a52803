/// @file
/// Exercise: a collision without friction between bodies that can rotate.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A rigid body at one moment. Everything but `moments` is in the axes of the world.
struct Body {
  double mass;                       ///< kg, greater than 0; infinite for an immovable body
  Eigen::Vector3d moments;           ///< principal moments of inertia, kg·m², each greater than 0
  Eigen::Matrix3d rotation;          ///< its columns are the principal axes in world coordinates
  Eigen::Vector3d centre;            ///< of mass, m
  Eigen::Vector3d velocity;          ///< of the centre of mass, m/s
  Eigen::Vector3d angular_velocity;  ///< angular velocity, rad/s
};

/// The motion of one body after the collision.
struct Motion {
  Eigen::Vector3d velocity;          ///< of the centre of mass, m/s
  Eigen::Vector3d angular_velocity;  ///< angular velocity, rad/s
};

/// The motion of both.
struct After {
  Motion a, b;
};

/// The motion of two bodies after a collision without friction at `point`.
///
/// Bodies that do not close there keep their motion. A body of infinite mass always keeps its
/// motion, whatever its moments; at most one of the two is such a body.
///
/// @param a, b before
/// @param point of contact, in the world, m
/// @param normal unit vector, from B to A
/// @param e coefficient of restitution, from 0 to 1
After collide(const Body& a, const Body& b, const Eigen::Vector3d& point,
              const Eigen::Vector3d& normal, double e);

}  // namespace exercise
