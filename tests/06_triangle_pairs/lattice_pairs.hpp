/// @file
/// Triangles with vertices in a small lattice, with and without area, and whether two of them meet
/// by a method that has nothing in common with those of the chapter.
///
/// Two convex sets meet if and only if 0 is a difference of their points, that is, if 0 is in the
/// convex hull of the nine differences of their vertices. By Carathéodory it is then in a simplex
/// of at most four of these that has volume in its own dimension; all are tried, in integers.
#pragma once

#include <array>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <support/generators.hpp>
#include <utility>
#include <vector>

namespace lattice_pairs {

using Point = std::array<long, 3>;
using Three = std::array<Point, 3>;

inline Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
inline long dot(const Point& p, const Point& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
inline bool is_zero(const Point& p) { return p == Point{0, 0, 0}; }
inline bool has_area(const Three& t) {
  return !is_zero(cross(minus(t[1], t[0]), minus(t[2], t[0])));
}

/// Whether 0 is between p and q, which differ.
inline bool in_segment(const Point& p, const Point& q) {
  return is_zero(cross(p, q)) && dot(p, q) <= 0;
}
/// Whether 0 is in the triangle of p, q and r, if it has area.
inline bool in_triangle(const Point& p, const Point& q, const Point& r) {
  const Point normal = cross(minus(q, p), minus(r, p));
  if (is_zero(normal) || dot(normal, p) != 0) return false;
  return dot(cross(p, q), normal) >= 0 && dot(cross(q, r), normal) >= 0 &&
         dot(cross(r, p), normal) >= 0;
}
/// Whether 0 is in the tetrahedron, if it has volume: on the inner side of each face.
inline bool in_tetrahedron(const Point& p, const Point& q, const Point& r, const Point& s) {
  const long volume = dot(cross(minus(q, p), minus(r, p)), minus(s, p));
  if (volume == 0) return false;
  const auto part = [volume](const Point& a, const Point& b, const Point& c) {
    return volume > 0 ? dot(cross(a, b), c) : -dot(cross(a, b), c);
  };
  return part(q, r, s) >= 0 && part(p, s, r) >= 0 && part(p, q, s) >= 0 && part(p, r, q) >= 0;
}

/// Whether two triangles, segments or points meet. Coordinates up to about 1000.
inline bool meet(const Three& t, const Three& u) {
  std::array<Point, 9> d;
  for (std::size_t i = 0; i < 9; ++i) d[i] = minus(t[i / 3], u[i % 3]);
  for (std::size_t i = 0; i < 9; ++i) {
    if (is_zero(d[i])) return true;
    for (std::size_t j = 0; j < i; ++j) {
      if (in_segment(d[i], d[j])) return true;
      for (std::size_t k = 0; k < j; ++k) {
        if (in_triangle(d[i], d[j], d[k])) return true;
        for (std::size_t l = 0; l < k; ++l) {
          if (in_tetrahedron(d[i], d[j], d[k], d[l])) return true;
        }
      }
    }
  }
  return false;
}

/// All triangles of the lattice of n³ points, each set of vertices once; vertices may be equal.
inline std::vector<Three> all_triangles(long n) {
  std::vector<Point> points;
  for (long i = 0; i < n * n * n; ++i) points.push_back({i % n, i / n % n, i / n / n});
  std::vector<Three> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k <= j; ++k) all.push_back({points[i], points[j], points[k]});
    }
  }
  return all;
}

/// One with vertices in the lattice of n³ points.
inline Three any_triangle(generators::Random& random, int n) {
  Three t;
  for (Point& p : t) {
    for (long& x : p) x = random.integer(0, n - 1);
  }
  return t;
}

/// In one of the six orders of its vertices.
inline Three reordered(generators::Random& random, Three t) {
  if (random.chance(0.5)) std::swap(t[0], t[1]);
  const auto i = static_cast<std::size_t>(random.integer(0, 2));
  return {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
}

/// As numbers of S, times a power of two.
template <class S>
contact::Triangle<S> stored(const Three& t, S unit = S(1)) {
  const auto point = [unit](const Point& p) {
    return contact::Vector3<S>(S(static_cast<double>(p[0])) * unit,
                               S(static_cast<double>(p[1])) * unit,
                               S(static_cast<double>(p[2])) * unit);
  };
  return {point(t[0]), point(t[1]), point(t[2])};
}

}  // namespace lattice_pairs
