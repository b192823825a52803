// mistake: unknown-name
// says: tirangle
// says: triangle

#include "ray_triangle.hpp"

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  const double t = tirangle.a.x();  // here
  return contact::TriangleHit<double>{t, {}};
}

}  // namespace exercise
