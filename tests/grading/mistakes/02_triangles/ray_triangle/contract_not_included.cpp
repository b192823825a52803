// mistake: contract-not-included
// says: ray_triangle.hpp

#include <optional>

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return std::nullopt;
}

}  // namespace exercise
