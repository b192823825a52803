// mistake: misspelt-function
// says: ray_triangel
// says: ray_triangle

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangel(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace exercise
