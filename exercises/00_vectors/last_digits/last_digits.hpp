/// @file
/// Exercise: an accurate cross product.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// u × v. Each coordinate has a *relative* error of at most 4 u, with u = 2⁻⁵³, and is 0 where the
/// exact one is, however nearly parallel the two vectors are.
///
/// Neither products of two coordinates nor their rounding errors over- or underflow here.
///
/// @param u each coordinate is 0, or from 10⁻⁵⁰ to 10⁵⁰ in size
/// @param v the same
Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

}  // namespace exercise
