// misconception: differences-cure-all
// caught by: parallel vectors give zero, and nearly parallel ones do not
// seen: https://github.com/libgeos/geos/pull/1184
//   subtracts first, and points on a line have a determinant of -2e-16
#include "last_digits.hpp"

namespace exercise {

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) { return u.cross(v - u); }

}  // namespace exercise
