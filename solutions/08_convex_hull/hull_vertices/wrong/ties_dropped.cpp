// misconception: ties-dropped
// caught by: the corners of a box are vertices, and inner points are not
// seen: https://github.com/mrdoob/three.js/pull/13014
//   a strict comparison passes over a point in the plane
#include "hull_vertices.hpp"

#include <algorithm>

namespace exercise {
namespace {

using Point = Eigen::Vector3d;
using Points = std::vector<Point>;

// A face: all points except its three vertices are behind it.
bool is_face(const Points& points, const Point& a, const Point& b, const Point& c) {
  const Point normal = (b - a).cross(c - a);
  if (normal == Point(0, 0, 0)) return false;
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return p == a || p == b || p == c || normal.dot(a - p) > 0;
  });
}

}  // namespace

std::vector<int> hull_vertices(const std::vector<Eigen::Vector3d>& points) {
  std::vector<int> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    if (std::find(points.begin(), points.end(), a) - points.begin() < static_cast<int>(i)) continue;
    bool found = false;
    for (const Point& b : points) {
      for (const Point& c : points) found = found || is_face(points, a, b, c);
    }
    if (found) vertices.push_back(static_cast<int>(i));
  }
  return vertices;
}

}  // namespace exercise
