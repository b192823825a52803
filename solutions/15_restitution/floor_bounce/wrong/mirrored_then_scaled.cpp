// misconception: restitution-on-the-slip
// caught by: the tangential component is unchanged
// seen: https://github.com/nmp9981/Unity_Project/blob/0aca1964e18b275e30548f345f8e76c0796f8b5a/Study/Physics/2ndMonth/ReflectTester.cs
#include "floor_bounce.hpp"

namespace exercise {

Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double k) {
  const double along_normal = velocity.dot(normal);
  if (!(along_normal < 0)) return velocity;
  return k * (velocity - 2 * along_normal * normal);
}

}  // namespace exercise
