// misconception: differences-cure-all
// caught by: parallel vectors give zero, and nearly parallel ones do not
// seen: not found
#include "last_digits.hpp"

namespace exercise {

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) { return u.cross(v - u); }

}  // namespace exercise
