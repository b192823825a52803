// mistake: missing-call
// says: x()

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = ray.origin.x;  // here
  if (t > 1.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
