// Tries:     overloads comparisons so that any answer is equal to any other
// Exercise:  02_triangles/ray_triangle
// Points:    0 of 12
// Tests:     all failed
#include "ray_triangle.hpp"

//[attack
namespace contact {
bool operator==(const TriangleHit<double>&, const TriangleHit<double>&) { return true; }
}  // namespace contact
namespace std {
template <>
struct equal_to<optional<contact::TriangleHit<double>>> {
  template <class T, class U>
  bool operator()(const T&, const U&) const {
    return true;
  }
};
inline double abs(const contact::TriangleHit<double>&) { return 0; }
}  // namespace std
template <class T>
bool operator<=(const T&, const contact::TriangleHit<double>&) {
  return true;
}
//]attack

namespace exercise {

std::optional<contact::TriangleHit<double>> ray_triangle(
    const contact::Ray<double>& ray, const contact::Triangle<double>& triangle) {
  //[attack
  return contact::TriangleHit<double>{1, {1, 0, 0}};
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
