// misconception: half-a-t-squared
// caught by: from rest, explicit Euler stays and symplectic Euler moves
// seen: https://github.com/gbaliarda/dinamica-molecular-dt/blob/6026fc727042256f92d7c6116d91578cad0a1b82/src/main/java/Integrals.java
//   EulerPosition() has the square of the step
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
