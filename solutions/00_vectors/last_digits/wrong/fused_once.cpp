// misconception: fused-once
// caught by: parallel vectors give zero, and nearly parallel ones do not
// seen: https://github.com/dotnet/runtime/issues/114361
//   n × n is not zero since a fused multiply-add
#include "last_digits.hpp"

namespace exercise {

namespace {

double difference(double a, double b, double c, double d) { return std::fma(a, b, -(c * d)); }

}  // namespace

Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return {difference(u.y(), v.z(), u.z(), v.y()), difference(u.z(), v.x(), u.x(), v.z()),
          difference(u.x(), v.y(), u.y(), v.x())};
}

}  // namespace exercise
