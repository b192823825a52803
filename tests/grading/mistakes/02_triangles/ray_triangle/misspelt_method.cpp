// mistake: no-such-member
// says: normm
// says: norm

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (ray.direction.normm() > 1.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
