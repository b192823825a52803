/// @file
/// Exercise: the angle between two vectors.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The angle between two vectors, in radians, from 0 (the same direction) to π (the opposite one).
///
/// Its error may be at most 4·10⁻¹⁵ rad, for every angle, however small or near π.
///
/// @param u of any length from 10⁻¹⁰ to 10¹⁰, in any unit. The zero vector has no direction:
/// std::invalid_argument.
/// @param v the same
double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

}  // namespace exercise
