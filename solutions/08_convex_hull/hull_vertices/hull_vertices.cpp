#include "hull_vertices.hpp"

namespace exercise {
namespace {

using Point = Eigen::Vector3d;
using Points = std::vector<Point>;

double side(const Point& a, const Point& b, const Point& c, const Point& p) {
  return (p - a).dot((b - a).cross(c - a));
}

bool in_segment(const Point& a, const Point& b, const Point& p) {
  return a != b && (b - a).cross(p - a) == Point(0, 0, 0) && (p - a).dot(p - b) <= 0;
}

bool in_triangle(const Point& a, const Point& b, const Point& c, const Point& p) {
  const Point n = (b - a).cross(c - a);
  return n != Point(0, 0, 0) && n.dot(p - a) == 0 && n.dot((b - a).cross(p - a)) >= 0 &&
         n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
}

bool in_tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d,
                    const Point& p) {
  const double volume = side(a, b, c, d);
  return volume != 0 && volume * side(a, b, c, p) >= 0 && volume * side(a, d, b, p) >= 0 &&
         volume * side(b, d, c, p) >= 0 && volume * side(c, d, a, p) >= 0;
}

// By Carathéodory's theorem: what is in the hull of some points is in a simplex of them.
bool in_hull(const Points& points, const Point& p) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (in_segment(points[i], points[j], p)) return true;
      for (std::size_t k = 0; k < j; ++k) {
        if (in_triangle(points[i], points[j], points[k], p)) return true;
        for (std::size_t l = 0; l < k; ++l) {
          if (in_tetrahedron(points[i], points[j], points[k], points[l], p)) return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

std::vector<int> hull_vertices(const std::vector<Eigen::Vector3d>& points) {
  std::vector<int> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool seen = false;
    for (std::size_t j = 0; j < i; ++j) seen = seen || points[j] == points[i];
    if (seen) continue;
    Points others;
    for (const Point& p : points) {
      if (p != points[i]) others.push_back(p);
    }
    if (!in_hull(others, points[i])) vertices.push_back(static_cast<int>(i));
  }
  return vertices;
}

}  // namespace exercise
