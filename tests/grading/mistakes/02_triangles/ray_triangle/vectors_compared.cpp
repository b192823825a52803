// mistake: wrong-operands
// says: <

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (ray.origin < triangle.a) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
