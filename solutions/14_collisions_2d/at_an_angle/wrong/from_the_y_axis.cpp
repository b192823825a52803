// misconception: angle-from-the-other-axis
// caught by: car and van along the axes
#include "at_an_angle.hpp"

namespace exercise {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Eigen::Vector2d momentum(const Vehicle& v) {
  const double angle = v.heading * kDegree;
  return v.mass * v.speed * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

}  // namespace

Motion stuck_together(const Vehicle& a, const Vehicle& b) {
  const Eigen::Vector2d p = momentum(a) + momentum(b);
  return {p.norm() / (a.mass + b.mass), std::atan2(p.x(), p.y()) / kDegree};
}

Sizes leaving_at(double total, double angle_a, double angle_b) {
  const double alpha = angle_a * kDegree;
  const double beta = angle_b * kDegree;
  return {total * std::sin(beta) / std::sin(alpha + beta),
          total * std::sin(alpha) / std::sin(alpha + beta)};
}

}  // namespace exercise
