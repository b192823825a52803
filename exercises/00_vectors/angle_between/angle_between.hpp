/// @file
/// Exercise: the angle between two vectors.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The angle between two vectors, in radians, from 0 (the same direction) to π (the opposite one).
///
/// It may be off by 4·10⁻¹⁵ rad, however small it is and however near to π.
///
/// @param u of any length from 10⁻¹⁰ to 10¹⁰, in any unit. Without length it points nowhere:
/// std::invalid_argument.
/// @param v the same
double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

}  // namespace exercise
