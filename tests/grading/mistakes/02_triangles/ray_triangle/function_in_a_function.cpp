// mistake: missing-brace
// says: inside another

#include "ray_triangle.hpp"

namespace exercise {

double length_of(const Eigen::Vector3d& v) {
  if (v.norm() > 0.0) {
    return v.norm();
  return 0.0;
}

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = 0.0;
  return std::nullopt;
}

}  // namespace exercise
