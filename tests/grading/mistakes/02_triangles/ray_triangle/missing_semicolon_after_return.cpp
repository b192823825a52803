// mistake: missing-semicolon
// says: semicolon

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (ray.origin.x() > triangle.a.x()) {
    return std::nullopt  // here
  }
  return contact::TriangleHit<double>{};
}

}  // namespace exercise
