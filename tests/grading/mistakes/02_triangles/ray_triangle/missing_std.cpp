// mistake: missing-std
// says: std::nullopt

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (ray.direction.norm() == 0.0) return nullopt;  // here
  return contact::TriangleHit<double>{};
}

}  // namespace exercise
