// mistake: narrowing
// says: double
// says: int

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const int t = ray.origin.x();  // here
  if (t > 0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
