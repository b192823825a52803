/// @file
/// Exercise: a rotated body whose inertia is left in its own axes.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A body of 1 kg, rotated about the z axis, and a contact.
struct Contact {
  Eigen::Vector3d moments;    ///< principal moments of inertia about the body's x, y and z, kg m^2
  double degrees;             ///< by which the body is rotated about z, counter-clockwise
  Eigen::Vector3d lever_arm;  ///< from the centre of mass to the contact, in world axes, m
  Eigen::Vector3d normal;     ///< unit vector along one of the world's axes
};

/// A contact of which given::inverse_effective_mass is wrong by more than half of the right value.
///
/// Like all contacts here: no moment is below 0.01 or above 10, each moment is at most the sum of
/// the other two, and no component of the lever arm is larger than 1 m.
Contact wrong_by_half();

/// A contact of which given::inverse_effective_mass is wrong by more than 10 %, although the body
/// is rotated by at most 10 degrees.
Contact small_rotation();

/// A contact of which given::inverse_effective_mass is wrong by more than 10 %, although the
/// largest moment is at most twice the smallest.
Contact similar_moments();

}  // namespace exercise
