// mistake: assigned-to-const
// says: corner
// says: const

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const int corner = 0;
  ++corner;  // here
  return std::nullopt;
}

}  // namespace exercise
