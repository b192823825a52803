// mistake: redefinition
// says: ray

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  contact::Ray<double> ray;  // here
  if (ray.origin.x() > 1.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
