// mistake: missing-brace
// says: }

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}
