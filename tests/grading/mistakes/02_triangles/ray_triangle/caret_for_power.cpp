// mistake: caret-for-power
// says: power

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = ray.origin.x() ^ 2;  // here
  if (t > 0.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
