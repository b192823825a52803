// mistake: outside-namespace
// says: namespace exercise

#include "ray_triangle.hpp"

namespace excercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace excercise
