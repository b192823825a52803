#include "point_in_triangle.hpp"

namespace exercise {
namespace {

// Twice the signed area of p, q, x: positive if x is to the left of the line from p to q.
double area(const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& x) {
  //? The cross product of pq and px is twice the signed area of p, q and x.
  //? gap: q.x() - p.x()
  return (q.x() - p.x()) * (x.y() - p.y()) - (q.y() - p.y()) * (x.x() - p.x());
}

}  // namespace

int dropped_dimension(const Eigen::Vector3d& normal) {
  //? Begin with dimension 0 as the largest so far.
  int largest = 0;
  //? Dropping the dimension of the largest component of the normal keeps the projected triangle as
  //? large as possible.
  //? gap: std::abs(normal[i]) > std::abs(normal[largest])
  for (const int i : {1, 2}) {
    if (std::abs(normal[i]) > std::abs(normal[largest])) largest = i;
  }
  //? The index is the answer, not the component.
  return largest;
}

bool point_in_triangle(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  //? The area of the triangle itself tells its orientation.
  //? gap: area(a, b, c)
  const double whole = area(a, b, c);
  //? A triangle without area has no interior.
  //? gap: whole == 0
  if (whole == 0) return false;
  //? With the vertices clockwise all signs are reversed; this factor reverses them back.
  //? gap: whole > 0 ? 1 : -1
  const double sign = whole > 0 ? 1 : -1;
  //? The point is inside if it is to the left of all three edges, taken in one direction. Zero is
  //? on an edge, and counts.
  //? gap: sign * area(a, b, point) >= 0
  return sign * area(a, b, point) >= 0 && sign * area(b, c, point) >= 0 &&
         sign * area(c, a, point) >= 0;
}

}  // namespace exercise
