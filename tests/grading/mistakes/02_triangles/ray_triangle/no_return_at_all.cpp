// mistake: missing-return
// says: return

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  contact::TriangleHit<double> hit;
  hit.t = ray.direction.norm();
}

}  // namespace exercise
