// mistake: assigned-to-const
// says: const

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  ray.direction.normalize();  // here
  return std::nullopt;
}

}  // namespace exercise
