// mistake: missing-semicolon
// says: semicolon

#include "ray_triangle.hpp"

namespace exercise {

struct Weights {
  double alpha;
}  // here

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace exercise
