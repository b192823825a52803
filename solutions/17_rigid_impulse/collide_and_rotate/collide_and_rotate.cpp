#include "collide_and_rotate.hpp"

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
  After after{{a.velocity, a.angular_velocity}, {b.velocity, b.angular_velocity}};
  const Eigen::Vector3d lever_arm_a = point - a.centre;
  const Eigen::Vector3d lever_arm_b = point - b.centre;
  const Eigen::Vector3d relative = (a.velocity + a.angular_velocity.cross(lever_arm_a)) -
                                   (b.velocity + b.angular_velocity.cross(lever_arm_b));
  const double closing = normal.dot(relative);
  if (closing >= 0) return after;

  const Eigen::Vector3d angular_impulse_a = lever_arm_a.cross(normal);
  const Eigen::Vector3d angular_impulse_b = lever_arm_b.cross(normal);
  const Eigen::Vector3d angular_a = inverse_inertia(a) * angular_impulse_a;
  const Eigen::Vector3d angular_b = inverse_inertia(b) * angular_impulse_b;
  const double divisor = inverse_mass(a) + inverse_mass(b) + angular_impulse_a.dot(angular_a) +
                         angular_impulse_b.dot(angular_b);
  const double j = -(1 + e) * closing / divisor;
  after.a.velocity += j * inverse_mass(a) * normal;
  after.b.velocity -= j * inverse_mass(b) * normal;
  after.a.angular_velocity += j * angular_a;
  after.b.angular_velocity -= j * angular_b;
  return after;
}

}  // namespace exercise
