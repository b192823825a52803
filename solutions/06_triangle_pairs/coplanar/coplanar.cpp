#include "coplanar.hpp"

namespace exercise {

using Triangle = contact::Triangle<double>;

bool in_one_plane(const Triangle& first, const Triangle& second) {
  //? From one of the six points to the other five.
  //? gap: x - first.a
  std::vector<Eigen::Vector3d> to;
  for (const Eigen::Vector3d& x : {first.b, first.c, second.a, second.b, second.c})
    to.push_back(x - first.a);
  //? One plane contains them if each three of these vectors span no volume. Which of them are
  //? parallel or zero is not known.
  //? gap: u.cross(v).dot(w)
  for (const Eigen::Vector3d& u : to)
    for (const Eigen::Vector3d& v : to)
      for (const Eigen::Vector3d& w : to)
        if (u.cross(v).dot(w) != 0) return false;
  return true;
}

namespace {

using Point = Eigen::Vector2d;
using Flat = std::array<Point, 3>;

// The triangle with two of its coordinates.
Flat flat(const Triangle& t, int x, int y) {
  return {Point(t.a[x], t.a[y]), Point(t.b[x], t.b[y]), Point(t.c[x], t.c[y])};
}

std::array<std::pair<Point, Point>, 3> edges(const Flat& t) {
  return {{{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}}};
}

// Twice the signed area of the triangle a, b, p.
double area(const Point& a, const Point& b, const Point& p) {
  //? The cross product of ab and ap.
  //? gap: (b.x() - a.x()) * (p.y() - a.y())
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

// Whether the segments ab and cd have a point in common. Each may be a point.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  //? They do not if both ends of the one are on one side of the line of the other.
  //? gap: area(a, b, c) * area(a, b, d)
  if (area(a, b, c) * area(a, b, d) > 0 || area(c, d, a) * area(c, d, b) > 0) return false;
  //? On one line all areas are zero. Then they meet if the boxes around them do, and of segments
  //? that meet the boxes always meet.
  //? gap: a.cwiseMin(b).array() <= c.cwiseMax(d).array()
  return (a.cwiseMin(b).array() <= c.cwiseMax(d).array()).all() &&
         (c.cwiseMin(d).array() <= a.cwiseMax(b).array()).all();
}

// Whether p is inside, not on an edge. Nothing is inside a triangle without area.
bool is_inside(const Flat& t, const Point& p) {
  //? On the same side of all three edges. Which side that is depends on the order of the vertices.
  //? gap: u * v > 0 && v * w > 0
  const double u = area(t[0], t[1], p), v = area(t[1], t[2], p), w = area(t[2], t[0], p);
  return u * v > 0 && v * w > 0;
}

bool meet(const Flat& first, const Flat& second) {
  //? Each edge of the one and each of the other.
  //? gap: segments_meet(a, b, c, d)
  for (const auto& [a, b] : edges(first))
    for (const auto& [c, d] : edges(second))
      if (segments_meet(a, b, c, d)) return true;
  //? If no edges meet, either triangle may be inside the other, with all its vertices.
  //? gap: is_inside(second, first[0])
  return is_inside(first, second[0]) || is_inside(second, first[0]);
}

}  // namespace

bool meet_in_one_plane(const Triangle& first, const Triangle& second) {
  //? Triangles that meet do so with any two of their coordinates. With one choice of these the
  //? plane does not collapse to a line, and then they meet only if they meet in space.
  //? gap: flat(first, x, y)
  for (const auto& [x, y] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{2, 0}})
    if (!meet(flat(first, x, y), flat(second, x, y))) return false;
  return true;
}

}  // namespace exercise
