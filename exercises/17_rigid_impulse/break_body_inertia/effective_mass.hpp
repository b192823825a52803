/// @file
/// Code to break: the inverse effective mass of a contact.
#pragma once

#include <contact/prelude.hpp>

namespace given {

/// The inverse of the effective mass of a body of 1 kg at a contact, in 1/kg.
///
/// @param moments the principal moments of inertia, about the body's own axes, kg m^2
/// @param lever_arm from the centre of mass to the contact, in world axes, m
/// @param normal unit vector, in world axes
inline double inverse_effective_mass(const Eigen::Vector3d& moments,
                                     const Eigen::Vector3d& lever_arm,
                                     const Eigen::Vector3d& normal) {
  const Eigen::Vector3d torque = lever_arm.cross(normal);
  const Eigen::Vector3d angular_velocity = torque.cwiseQuotient(moments);
  return 1.0 + torque.dot(angular_velocity);
}

}  // namespace given
