#include "barycentric_interpolation.hpp"

namespace exercise {

Eigen::Vector3d barycentric(const contact::Triangle<double>& triangle,
                            const Eigen::Vector3d& point) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d n = e1.cross(e2);  // its length is twice the triangle's area
  if (n.squaredNorm() == 0) throw std::invalid_argument("triangle: it has no area");

  const Eigen::Vector3d x = point - triangle.a;
  const double gamma = n.dot(e1.cross(x)) / n.squaredNorm();
  const double beta = n.dot(x.cross(e2)) / n.squaredNorm();
  return {1 - beta - gamma, beta, gamma};
}

Air interpolated(const Air& a, const Air& b, const Air& c, const Eigen::Vector3d& weights) {
  return {weights[0] * a.temperature + weights[1] * b.temperature + weights[2] * c.temperature,
          weights[0] * a.velocity + weights[1] * b.velocity + weights[2] * c.velocity};
}

}  // namespace exercise
