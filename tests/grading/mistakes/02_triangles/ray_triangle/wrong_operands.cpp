// mistake: wrong-operands
// says: double

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d moved = ray.origin + 1.0;  // here
  if (moved.norm() > 1.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
