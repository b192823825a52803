// misconception: step-left-out
// caught by: from rest, explicit Euler stays and symplectic Euler moves
// seen: https://github.com/dilevin/CSC417-a5-rigid-bodies/issues/4
//   a torque without the step, in an assignment
#include "two_eulers.hpp"

namespace exercise {

Body explicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  return {body.position + body.velocity, body.velocity + acceleration};
}

Body semi_implicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  const Eigen::Vector3d velocity = body.velocity + acceleration;
  return {body.position + velocity, velocity};
}

}  // namespace exercise
