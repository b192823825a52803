// misconception: omega-cross-r-reversed
// caught by: the point that spins into the contact counts
#include "collide_and_turn.hpp"

namespace exercise {

namespace {

double inverse_mass(const Body& body) { return std::isinf(body.mass) ? 0 : 1 / body.mass; }

Eigen::Matrix3d inverse_inertia(const Body& body) {
  if (std::isinf(body.mass)) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d inverse = body.moments.cwiseInverse();
  return body.rotation * inverse.asDiagonal() * body.rotation.transpose();
}

}  // namespace

After collide(const Body& a, const Body& b, const Eigen::Vector3d& point,
              const Eigen::Vector3d& normal, double e) {
  After after{{a.velocity, a.spin}, {b.velocity, b.spin}};
  const Eigen::Vector3d arm_a = point - a.centre;
  const Eigen::Vector3d arm_b = point - b.centre;
  const Eigen::Vector3d relative =
      (a.velocity + arm_a.cross(a.spin)) - (b.velocity + arm_b.cross(b.spin));
  const double closing = normal.dot(relative);
  if (closing >= 0) return after;

  const Eigen::Vector3d twist_a = arm_a.cross(normal);
  const Eigen::Vector3d twist_b = arm_b.cross(normal);
  const Eigen::Vector3d turn_a = inverse_inertia(a) * twist_a;
  const Eigen::Vector3d turn_b = inverse_inertia(b) * twist_b;
  const double divisor =
      inverse_mass(a) + inverse_mass(b) + twist_a.dot(turn_a) + twist_b.dot(turn_b);
  const double j = -(1 + e) * closing / divisor;
  after.a.velocity += j * inverse_mass(a) * normal;
  after.b.velocity -= j * inverse_mass(b) * normal;
  after.a.spin += j * turn_a;
  after.b.spin -= j * turn_b;
  return after;
}

}  // namespace exercise
