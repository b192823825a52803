// mistake: product-of-vectors
// says: dot

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double d = ray.origin * ray.direction;  // here
  if (d > 1.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
