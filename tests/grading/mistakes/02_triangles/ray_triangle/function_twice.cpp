// mistake: redefinition
// says: ray_triangle

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace exercise
