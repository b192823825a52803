// mistake: undefined-function
// says: helper

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> helper(const contact::Ray<double>& ray);

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  return helper(ray);
}

}  // namespace exercise
