// mistake: missing-template-argument
// says: Ray<double>

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const contact::Ray& other = ray;  // here
  if (other.origin.x() > 0.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
