// mistake: wrong-argument-count
// says: dot
// says: 1

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (ray.origin.dot() > 1.0) return contact::TriangleHit<double>{};  // here
  return std::nullopt;
}

}  // namespace exercise
