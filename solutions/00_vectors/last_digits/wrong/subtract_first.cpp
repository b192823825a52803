// misconception: differences-cure-all
// caught by: what two products have in common cancels and the rest is right
#include "last_digits.hpp"

namespace exercise {

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) { return u.cross(v - u); }

}  // namespace exercise
