// mistake: stray-character
// says: @

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = 1.0 @ 2.0;  // here
  if (t > 0.0) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
