#include "collide_and_rotate.hpp"

namespace exercise {

namespace {

double inverse_mass(const Body& body) { return std::isinf(body.mass) ? 0 : 1 / body.mass; }

Eigen::Matrix3d inverse_inertia(const Body& body) {
  //? No impulse rotates a body of infinite mass.
  if (std::isinf(body.mass)) return Eigen::Matrix3d::Zero();
  //? In the principal axes the inertia is diagonal, so its inverse has the reciprocals.
  //? gap: body.moments.cwiseInverse()
  const Eigen::Vector3d inverse = body.moments.cwiseInverse();
  //? R·D·Rᵀ rotates into the body's axes, applies the inverse there, and rotates back.
  //? gap: body.rotation.transpose()
  return body.rotation * inverse.asDiagonal() * body.rotation.transpose();
}

}  // namespace

After collide(const Body& a, const Body& b, const Eigen::Vector3d& point,
              const Eigen::Vector3d& normal, double e) {
  //? Without a collision both bodies keep their velocities.
  After after{{a.velocity, a.angular_velocity}, {b.velocity, b.angular_velocity}};
  //? The lever arms lead from the centres of mass to the contact point.
  //? gap: point - a.centre
  const Eigen::Vector3d lever_arm_a = point - a.centre;
  const Eigen::Vector3d lever_arm_b = point - b.centre;
  //? The velocity of a point of the body is v + ω × r; the contact sees the difference.
  //? gap: a.angular_velocity.cross(lever_arm_a)
  const Eigen::Vector3d relative = (a.velocity + a.angular_velocity.cross(lever_arm_a)) -
                                   (b.velocity + b.angular_velocity.cross(lever_arm_b));
  //? Along the normal a negative value means approach. Otherwise there is no impulse.
  //? gap: normal.dot(relative)
  //? gap: closing >= 0
  const double closing = normal.dot(relative);
  if (closing >= 0) return after;

  //? A unit impulse along the normal has the angular impulse r × n.
  //? gap: lever_arm_a.cross(normal)
  const Eigen::Vector3d angular_impulse_a = lever_arm_a.cross(normal);
  const Eigen::Vector3d angular_impulse_b = lever_arm_b.cross(normal);
  //? The inverse inertia makes of it the change of angular velocity.
  //? gap: inverse_inertia(a) * angular_impulse_a
  const Eigen::Vector3d angular_a = inverse_inertia(a) * angular_impulse_a;
  const Eigen::Vector3d angular_b = inverse_inertia(b) * angular_impulse_b;
  //? This is how much the relative velocity changes for a unit impulse: the inverse of the
  //? effective mass.
  //? gap: angular_impulse_a.dot(angular_a)
  const double divisor = inverse_mass(a) + inverse_mass(b) + angular_impulse_a.dot(angular_a) +
                         angular_impulse_b.dot(angular_b);
  //? The relative velocity along the normal must change by −(1 + e) times its value.
  //? gap: -(1 + e) * closing
  const double j = -(1 + e) * closing / divisor;
  //? The impulses on both bodies are equal and opposite.
  //? gap: j * inverse_mass(a) * normal
  after.a.velocity += j * inverse_mass(a) * normal;
  after.b.velocity -= j * inverse_mass(b) * normal;
  //? The same holds for the angular impulses.
  //? gap: j * angular_a
  after.a.angular_velocity += j * angular_a;
  after.b.angular_velocity -= j * angular_b;
  //? The result has the velocities of both bodies.
  return after;
}

}  // namespace exercise
