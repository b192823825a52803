// misconception: half-a-t-squared
// caught by: from rest, explicit Euler stays and symplectic Euler moves
#include "two_eulers.hpp"

namespace exercise {

Body explicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  const Eigen::Vector3d velocity = body.velocity + step * acceleration;
  return {body.position + step * body.velocity + step * step / 2 * acceleration, velocity};
}

Body semi_implicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  const Eigen::Vector3d velocity = body.velocity + step * acceleration;
  return {body.position + step * body.velocity + step * step / 2 * acceleration, velocity};
}

}  // namespace exercise
