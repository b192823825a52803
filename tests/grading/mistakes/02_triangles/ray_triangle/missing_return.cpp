// mistake: missing-return
// says: return

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = ray.direction.norm();
  if (t == 0.0) {
    return std::nullopt;
  }
}

}  // namespace exercise
