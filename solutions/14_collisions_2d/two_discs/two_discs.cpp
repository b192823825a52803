#include "two_discs.hpp"

namespace exercise {

bool approach(const Disc& a, const Disc& b) {
  //? The derivative of the squared distance of the centres is twice this dot product; negative
  //? means that the distance decreases.
  //? gap: a.velocity - b.velocity
  return (a.centre - b.centre).dot(a.velocity - b.velocity) < 0;
}

Velocities after_touch(const Disc& a, const Disc& b, double restitution) {
  //? Discs that touch but do not approach each other exert no impulse.
  if (!approach(a, b)) return {a.velocity, b.velocity};
  //? Smooth discs push along the line of centres only; as a unit vector it measures velocities.
  //? gap: (a.centre - b.centre).normalized()
  const Eigen::Vector2d n = (a.centre - b.centre).normalized();
  //? Along this line the problem is one-dimensional, with this relative velocity.
  //? gap: n.dot(a.velocity - b.velocity)
  const double w = n.dot(a.velocity - b.velocity);
  //? The relative velocity changes by −(1 + k)w; times the reduced mass, that is the impulse.
  //? gap: a.mass * b.mass / (a.mass + b.mass)
  const double j = -(1 + restitution) * w * a.mass * b.mass / (a.mass + b.mass);
  //? The impulses are equal and opposite. The tangential velocities stay as they are.
  //? gap: j / a.mass * n
  //? gap: j / b.mass * n
  return {a.velocity + j / a.mass * n, b.velocity - j / b.mass * n};
}

}  // namespace exercise
