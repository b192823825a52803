#include "at_an_angle.hpp"

namespace exercise {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Eigen::Vector2d momentum(const Vehicle& v) {
  //? The contract gives degrees, and the functions of the library take radians.
  //? gap: v.heading * kDegree
  const double angle = v.heading * kDegree;
  //? Momentum is a vector: mass times speed, along the heading.
  //? gap: std::cos(angle), std::sin(angle)
  return v.mass * v.speed * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

}  // namespace

Motion stuck_together(const Vehicle& a, const Vehicle& b) {
  //? The momentum after the collision is the vector sum of both before.
  //? gap: momentum(a) + momentum(b)
  const Eigen::Vector2d p = momentum(a) + momentum(b);
  //? The wreck has the mass of both. atan2 gives the heading in all four quadrants.
  //? gap: (a.mass + b.mass)
  //? gap: std::atan2(p.y(), p.x())
  return {p.norm() / (a.mass + b.mass), std::atan2(p.y(), p.x()) / kDegree};
}

Sizes leaving_at(double total, double angle_a, double angle_b) {
  //? Both angles are measured from the direction of the total momentum.
  const double alpha = angle_a * kDegree;
  const double beta = angle_b * kDegree;
  //? In the triangle of the momenta the law of sines applies: each side is as long as the sine of
  //? the angle opposite, and that is the angle of the other.
  //? gap: std::sin(beta) / std::sin(alpha + beta)
  return {total * std::sin(beta) / std::sin(alpha + beta),
          total * std::sin(alpha) / std::sin(alpha + beta)};
}

}  // namespace exercise
