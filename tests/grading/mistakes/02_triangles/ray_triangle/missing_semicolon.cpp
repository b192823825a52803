// mistake: missing-semicolon
// says: semicolon

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = ray.origin.x()  // here
  return std::nullopt;
}

}  // namespace exercise
