// mistake: eigen-types
// says: cast

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3f single(1.0f, 2.0f, 3.0f);
  if ((single + ray.origin).norm() > 1.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
