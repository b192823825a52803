// misconception: euler-orders-exchanged
// caught by: from rest, explicit Euler stays and symplectic Euler moves
// seen: https://github.com/JimmyStephen/GAT315/blob/04fcc1e1eae8a58f5c94211434c58c8f73ec0667/Assets/Scripts/Physics/Integrator.cs
//   ExplicitEuler() has the steps of the other
#include "two_eulers.hpp"

namespace exercise {

Body explicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  const Eigen::Vector3d velocity = body.velocity + step * acceleration;
  return {body.position + step * velocity, velocity};
}

Body semi_implicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  return {body.position + step * body.velocity, body.velocity + step * acceleration};
}

}  // namespace exercise
