#include "smallest_circle.hpp"

namespace exercise {
namespace {

using Point = Eigen::Vector2d;
using Points = std::vector<Point>;

double cross(const Point& u, const Point& v) { return u.x() * v.y() - u.y() * v.x(); }

// Whether p is inside the circle with the diameter ab, or on it: there the angle apb is at least a
// right one.
bool in_circle_across(const Point& a, const Point& b, const Point& p) {
  return (a - p).dot(b - p) <= 0;
}

// Whether all points satisfy a condition.
template <class Condition>
bool all(const Points& points, const Condition& condition) {
  return std::all_of(points.begin(), points.end(), condition);
}

// Whether no angle of the triangle abc is larger than a right one.
bool is_not_obtuse(const Point& a, const Point& b, const Point& c) {
  //? An angle is at most a right one if the two edges from its vertex have no negative dot product.
  //? gap: (a - b).dot(c - b) >= 0
  return (b - a).dot(c - a) >= 0 && (a - b).dot(c - b) >= 0 && (a - c).dot(b - c) >= 0;
}

// The point that is equally far from a, b and c.
Point centre_through(const Point& a, const Point& b, const Point& c) {
  //? With a as the origin, the centre m has 2 u · m = u · u and 2 v · m = v · v. Cramer's rule
  //? solves these two equations.
  //? gap: 2 * cross(u, v)
  //? gap: uu * v.y() - vv * u.y()
  const Point u = b - a, v = c - a;
  const double uu = u.dot(u), vv = v.dot(v), det = 2 * cross(u, v);
  return a + Point(uu * v.y() - vv * u.y(), vv * u.x() - uu * v.x()) / det;
}

// The smallest circle around this centre that contains all points.
Circle around(const Point& centre, const Points& points) {
  //? The centre is rounded, so the points of the support are no longer equally far from it. The
  //? farthest point counts.
  //? gap: std::max(radius, (p - centre).norm())
  double radius = 0;
  for (const Point& p : points) radius = std::max(radius, (p - centre).norm());
  //? A computed distance may be smaller than the true one, by a factor of at most 1 - 4 u, with u
  //? about 1.1e-16. A factor of 1 + 9 u makes up for that and for the rounding of this product.
  //? gap: radius * (1 + 1e-15)
  return {centre, radius * (1 + 1e-15)};
}

}  // namespace

bool in_circle_through(const Point& a, const Point& b, const Point& c, const Point& p) {
  //? From p to the three points.
  //? gap: c - p
  const Point u = a - p, v = b - p, w = c - p;
  //? The determinant of these vectors, each with its square as the third coordinate. It is 0 on the
  //? circle, and positive inside if a, b and c are counter-clockwise.
  //? gap: v.dot(v) * cross(w, u)
  const double det = u.dot(u) * cross(v, w) + v.dot(v) * cross(w, u) + w.dot(w) * cross(u, v);
  //? In clockwise order both signs are reversed.
  //? gap: det * cross(b - a, c - a) >= 0
  return det * cross(b - a, c - a) >= 0;
}

Circle smallest_circle(const Points& points) {
  //? If a circle with two points as ends of a diameter contains all points, no smaller one does: a
  //? smaller one does not even contain these two. A point and itself are a pair, too.
  //? gap: in_circle_across(a, b, p)
  //? gap: (a + b) / 2
  for (const Point& a : points)
    for (const Point& b : points)
      if (all(points, [&](const Point& p) { return in_circle_across(a, b, p); }))
        return around((a + b) / 2, points);
  //? Otherwise the circle passes through three points. Of a triangle that is not obtuse, the
  //? circumscribed circle is the smallest one around its vertices, so no smaller one contains all.
  //? gap: cross(b - a, c - a) == 0 || !is_not_obtuse(a, b, c)
  //? gap: in_circle_through(a, b, c, p)
  for (const Point& a : points)
    for (const Point& b : points)
      for (const Point& c : points) {
        if (cross(b - a, c - a) == 0 || !is_not_obtuse(a, b, c)) continue;
        if (all(points, [&](const Point& p) { return in_circle_through(a, b, c, p); }))
          return around(centre_through(a, b, c), points);
      }
  return {};
}

}  // namespace exercise
