/// @file
/// Hulls of points with whole coordinates, in integers, by methods that share nothing with the
/// reference. The tests of the exercises compare answers with these.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace whole {

using Point2 = Eigen::Vector2d;
using Point = Eigen::Vector3d;

inline std::int64_t to_integer(double x) { return static_cast<std::int64_t>(x); }

/// The orientation of three points; coordinates up to 2^25.
inline int orientation(const Point2& a, const Point2& b, const Point2& c) {
  const auto d = [](double x, double y) { return to_integer(x) - to_integer(y); };
  const std::int64_t area = d(b.x(), a.x()) * d(c.y(), a.y()) - d(b.y(), a.y()) * d(c.x(), a.x());
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

struct Vector {
  std::int64_t x = 0, y = 0, z = 0;
};
inline Vector difference(const Point& p, const Point& q) {
  return {to_integer(p.x()) - to_integer(q.x()), to_integer(p.y()) - to_integer(q.y()),
          to_integer(p.z()) - to_integer(q.z())};
}
inline Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
inline std::int64_t dot(const Vector& u, const Vector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
/// The orientation of four points; coordinates up to 1000.
inline int side(const Point& a, const Point& b, const Point& c, const Point& d) {
  const std::int64_t volume = dot(difference(d, a), cross(difference(b, a), difference(c, a)));
  return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
}
inline bool on_line(const Point& a, const Point& b, const Point& c) {
  const Vector n = cross(difference(b, a), difference(c, a));
  return n.x == 0 && n.y == 0 && n.z == 0;
}

/// The vertices in the plane, counter-clockwise from the lexicographically least, by wrapping.
inline std::vector<int> hull_2d(const std::vector<Point2>& points) {
  const auto before = [&](std::size_t i, std::size_t j) {
    if (points[i].x() != points[j].x()) return points[i].x() < points[j].x();
    return points[i].y() < points[j].y();
  };
  if (points.empty()) return {};
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (before(i, first)) first = i;
  }
  std::vector<int> hull;
  std::size_t at = first;
  do {
    hull.push_back(static_cast<int>(at));
    std::size_t next = at;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i] == points[at]) continue;
      if (points[next] == points[at]) {
        next = i;
        continue;
      }
      const int side = orientation(points[at], points[next], points[i]);
      const auto reach = [&](std::size_t k) { return (points[k] - points[at]).squaredNorm(); };
      if (side < 0 || (side == 0 && reach(i) > reach(next))) next = i;
    }
    at = next;
  } while (points[at] != points[first] && hull.size() < points.size());
  return hull;
}

/// The vertices in space, by supporting planes, and by lines and points for flat sets.
inline std::vector<int> hull_vertices(const std::vector<Point>& points) {
  const std::size_t n = points.size();
  std::vector<bool> vertex(n, false);
  const auto first_of = [&](std::size_t i) {
    std::size_t k = 0;
    while (points[k] != points[i]) ++k;
    return k;
  };
  bool are_collinear = true;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      for (std::size_t c = 0; c < n; ++c) {
        if (a == b || b == c || a == c || on_line(points[a], points[b], points[c])) continue;
        are_collinear = false;
        if (b < a || c < a) continue;  // each plane once from either side
        bool supporting = true;
        std::vector<std::size_t> flat;
        for (std::size_t i = 0; i < n && supporting; ++i) {
          const int s = side(points[a], points[b], points[c], points[i]);
          supporting = s <= 0;
          if (s == 0) flat.push_back(i);
        }
        if (!supporting) continue;
        const Vector normal =
            cross(difference(points[b], points[a]), difference(points[c], points[a]));
        const int drop = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
        std::vector<Point2> view;
        for (const std::size_t i : flat)
          view.emplace_back(points[i][(drop + 1) % 3], points[i][(drop + 2) % 3]);
        for (const int k : hull_2d(view))
          vertex[first_of(flat[static_cast<std::size_t>(k)])] = true;
      }
    }
  }
  if (are_collinear && n > 0) {
    const auto before = [&](std::size_t i, std::size_t j) {
      return std::lexicographical_compare(points[i].begin(), points[i].end(), points[j].begin(),
                                          points[j].end());
    };
    std::size_t low = 0, high = 0;
    for (std::size_t i = 1; i < n; ++i) {
      if (before(i, low)) low = i;
      if (before(high, i)) high = i;
    }
    vertex[first_of(low)] = vertex[first_of(high)] = true;
  }
  std::vector<int> all;
  for (std::size_t i = 0; i < n; ++i) {
    if (vertex[i]) all.push_back(static_cast<int>(i));
  }
  return all;
}

}  // namespace whole
