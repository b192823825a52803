// mistake: eigen-sizes
// says: size

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const Eigen::Vector2d flat(1.0, 2.0);
  if ((flat + ray.origin).norm() > 1.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
