// mistake: assignment-for-comparison
// says: ==

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  double t = ray.direction.norm();
  if (t = 0.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
