#include "barycentric_interpolation.hpp"

namespace exercise {

Eigen::Vector3d barycentric(const contact::Triangle<double>& triangle,
                            const Eigen::Vector3d& point) {
  const Eigen::Vector3d e1 = triangle.b - triangle.a;
  const Eigen::Vector3d e2 = triangle.c - triangle.a;
  const Eigen::Vector3d n = e1.cross(e2);  // its length is twice the triangle's area
  if (n.squaredNorm() == 0) throw std::invalid_argument("triangle: it has no area");

  // The weight of c is the signed area of the triangle (a, b, point) over the whole area, both
  // projected along n.
  [[maybe_unused]] const double gamma = n.dot(e1.cross(point - triangle.a)) / n.squaredNorm();

  // Complete: the weight of b is the area of the triangle (a, point, c) over the whole area; and
  // the weight of a? Then end with `return {alpha, beta, gamma};`.
  contact::todo();
}

Air interpolated(const Air& a, const Air& b, const Air& c, const Eigen::Vector3d& weights) {
  // Complete: weights[0] is the weight of a. Interpolate the temperature and the velocity, and
  // return both: `return {temperature, velocity};`.
  contact::todo();
}

}  // namespace exercise
