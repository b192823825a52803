// mistake: stray-character
// says: “

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const std::string name = “ray”;  // here
  if (name.empty()) return contact::TriangleHit<double>{};
  return std::nullopt;
}

}  // namespace exercise
