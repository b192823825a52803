// mistake: missing-brace
// says: }

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  if (ray.direction.norm() == 0.0) {
    const double nothing = 0.0;
  return std::nullopt;
}

}  // namespace exercise
