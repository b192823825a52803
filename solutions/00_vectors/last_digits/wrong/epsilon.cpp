// misconception: absolute-epsilon
// caught by: parallel vectors give zero, and nearly parallel ones do not
#include "last_digits.hpp"

namespace exercise {

namespace {

double difference(double a, double b, double c, double d) {
  const double product = c * d;
  const double lost = std::fma(-c, d, product);
  const double result = std::fma(a, b, -product) + lost;
  return std::abs(result) < 1e-12 ? 0 : result;
}

}  // namespace

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return {difference(u.y(), v.z(), u.z(), v.y()), difference(u.z(), v.x(), u.x(), v.z()),
          difference(u.x(), v.y(), u.y(), v.x())};
}

}  // namespace exercise
