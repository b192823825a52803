// mistake: another-signature
// says: ray_triangle

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, contact::Triangle<double> triangle) {
  return std::nullopt;
}

}  // namespace exercise
