// mistake: missing-namespace
// says: Eigen::Vector3d

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Vector3d edge = triangle.b - triangle.a;  // here
  if (edge.norm() == 0.0) return std::nullopt;
  return std::nullopt;
}

}  // namespace exercise
