// mistake: missing-parenthesis
// says: )

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double d = std::sqrt(ray.origin.dot(ray.origin);  // here
  if (d > 1.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
