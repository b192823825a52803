/// @file
/// Points of the plane with whole coordinates up to 2^25, in integers, by methods that share
/// nothing with the reference. The tests of the exercises compare answers with these.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace whole {

using Point = Eigen::Vector2d;
using Points = std::vector<Point>;

inline std::int64_t to_integer(double x) { return static_cast<std::int64_t>(x); }

struct Vector {
  std::int64_t x = 0, y = 0;
};
inline Vector difference(const Point& p, const Point& q) {
  return {to_integer(p.x()) - to_integer(q.x()), to_integer(p.y()) - to_integer(q.y())};
}
inline std::int64_t cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }
inline std::int64_t dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }

/// Twice the signed area of a, b, c: positive if c is to the left of the line from a to b.
inline std::int64_t area(const Point& a, const Point& b, const Point& c) {
  return cross(difference(b, a), difference(c, a));
}
inline int orientation(const Point& a, const Point& b, const Point& c) {
  const std::int64_t twice = area(a, b, c);
  return twice > 0 ? 1 : (twice < 0 ? -1 : 0);
}

/// Whether p is on the segment from a to b, ends included. A segment may be a point.
inline bool on_segment(const Point& a, const Point& b, const Point& p) {
  return area(a, b, p) == 0 && dot(difference(a, p), difference(b, p)) <= 0;
}

inline Point after(const Points& polygon, std::size_t i) {
  return polygon[(i + 1) % polygon.size()];
}

inline bool on_boundary(const Points& polygon, const Point& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (on_segment(polygon[i], after(polygon, i), p)) return true;
  }
  return false;
}

/// How often the polygon goes round the point, counter-clockwise, by a ray that passes through no
/// vertex. The point must not be on an edge.
inline int winding_number(const Points& polygon, const Point& p) {
  Point far = p;
  for (int slope = 1;; ++slope) {
    far = p + Point(0x1p28, slope);
    const auto on_the_ray = [&](const Point& v) { return area(p, far, v) == 0; };
    if (std::none_of(polygon.begin(), polygon.end(), on_the_ray)) break;
  }
  int number = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = after(polygon, i);
    if (orientation(p, far, a) == orientation(p, far, b)) continue;
    // The line is crossed; the ray, if the point and the far end are on different sides.
    const int side = orientation(a, b, p);
    if (side != orientation(a, b, far)) number += side;
  }
  return number;
}

inline bool all_whole(const Points& points, double limit = 0x1p25) {
  return std::all_of(points.begin(), points.end(), [limit](const Point& p) {
    return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= limit;
  });
}

/// Whether the vertices are those of a convex polygon, counter-clockwise. Three in a row may be on
/// one line, and no two are equal.
inline bool is_convex(const Points& polygon) {
  bool has_area = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      if (polygon[j] == polygon[k]) return false;
      for (std::size_t i = 0; i < j; ++i) {
        const int turn = orientation(polygon[i], polygon[j], polygon[k]);
        if (turn < 0) return false;
        has_area = has_area || turn > 0;
      }
    }
  }
  return has_area;
}

}  // namespace whole
