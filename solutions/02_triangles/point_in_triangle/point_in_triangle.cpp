#include "point_in_triangle.hpp"

namespace exercise {
namespace {

// Twice the signed area of p, q, x: positive if x is to the left of the line from p to q.
double area(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& x) {
  return (q.x() - p.x()) * (x.y() - p.y()) - (q.y() - p.y()) * (x.x() - p.x());
}

}  // namespace

int dropped_dimension(const Eigen::Vector3d& normal) {
  int largest = 0;
  for (const int i : {1, 2}) {
    if (std::abs(normal[i]) > std::abs(normal[largest])) largest = i;
  }
  return largest;
}

bool point_in_triangle(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double whole = area(a, b, c);
  if (whole == 0) return false;
  const double sign = whole > 0 ? 1 : -1;
  return sign * area(a, b, point) >= 0 && sign * area(b, c, point) >= 0 &&
         sign * area(c, a, point) >= 0;
}

}  // namespace exercise
