// misconception: products-rounded
// caught by: the difference of nearly equal products is accurate
// seen: https://github.com/mosra/magnum/pull/435 cross products that cancel
#include "last_digits.hpp"

namespace exercise {

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) { return u.cross(v); }

}  // namespace exercise
