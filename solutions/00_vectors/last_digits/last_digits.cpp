// A fused multiply-add gives what a product has lost; put it back after the difference.
#include "last_digits.hpp"

namespace exercise {

namespace {

double difference(double a, double b, double c, double d) {
  const double product = c * d;
  const double lost = std::fma(-c, d, product);
  return std::fma(a, b, -product) + lost;
}

}  // namespace

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return {difference(u.y(), v.z(), u.z(), v.y()), difference(u.z(), v.x(), u.x(), v.z()),
          difference(u.x(), v.y(), u.y(), v.x())};
}

}  // namespace exercise
