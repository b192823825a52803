/// @file
/// Exercise: a cross product with all of its digits.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// u × v. Each coordinate may be off by 4 u of *itself*, with u = 2⁻⁵³, and is 0 where the true one
/// is: however nearly parallel the two are.
///
/// No product of two coordinates over- or underflows here, and nothing of what its rounding cuts
/// off does.
///
/// @param u each coordinate is 0, or from 10⁻⁵⁰ to 10⁵⁰ in size
/// @param v the same
Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v);

}  // namespace exercise
