/// @file
/// Directions that separate convex polygons, in integers, right or with one mistake that people
/// make: what the test of the exercise compares with and recognises.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <contact/exact.hpp>

namespace polygons_with_mistakes {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;
using Whole = Eigen::Matrix<std::int64_t, 2, 1>;
using Axis = std::optional<Point>;

inline Whole whole(const Point& p) { return p.cast<std::int64_t>(); }
inline std::int64_t dot(const Point& n, const Point& p) { return whole(n).dot(whole(p)); }
/// Twice the signed area of the triangle a, b, p.
inline std::int64_t area(const Point& a, const Point& b, const Point& p) {
  const Whole u = whole(b - a), v = whole(p - a);
  return u.x() * v.y() - u.y() * v.x();
}
inline Point next(const Polygon& polygon, std::size_t i) {
  return polygon[(i + 1) % polygon.size()];
}

// ---------------------------------------------------------------- what the contract allows

inline bool is_whole(const Point& p, double limit) {
  return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= limit;
}

/// Whether these are the vertices of a convex polygon, a segment or a point, as the contract wants.
inline bool is_convex(const Polygon& polygon, double limit) {
  const std::size_t n = polygon.size();
  if (n == 0) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_whole(polygon[i], limit)) return false;
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      if (polygon[j] == polygon[i]) return false;
      if (j != (i + 1) % n && area(polygon[i], next(polygon, i), polygon[j]) <= 0) return false;
    }
  }
  return true;
}

// ---------------------------------------------------------------- whether polygons meet

/// Whether the segments ab and cd, which may be points, have a point in common.
inline bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto sign = [](std::int64_t x) { return (x > 0) - (x < 0); };
  if (sign(area(a, b, c)) * sign(area(a, b, d)) > 0) return false;
  if (sign(area(c, d, a)) * sign(area(c, d, b)) > 0) return false;
  return (a.cwiseMin(b).array() <= c.cwiseMax(d).array()).all() &&
         (c.cwiseMin(d).array() <= a.cwiseMax(b).array()).all();
}

inline bool contains(const Polygon& polygon, const Point& p) {
  if (polygon.size() < 3) return false;  // its edges are asked
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (area(polygon[i], next(polygon, i), p) < 0) return false;
  return true;
}

/// Whether two polygons have a point in common: edges do, or one is inside the other. No direction
/// is tried.
inline bool meet(const Polygon& first, const Polygon& second) {
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j)
      if (segments_meet(first[i], next(first, i), second[j], next(second, j))) return true;
  return contains(first, second.front()) || contains(second, first.front());
}

/// The smallest n · q − n · p for p of the first and q of the second, for any finite n, without
/// rounding: its sign.
inline int sign_of_gap(const Point& n, const Polygon& first, const Polygon& second) {
  using contact::Exact;
  int sign = 1;
  if (is_whole(n, 0x1p30)) {
    for (const Point& p : first)
      for (const Point& q : second) {
        const std::int64_t gap = dot(n, q) - dot(n, p);
        sign = std::min(sign, (gap > 0) - (gap < 0));
      }
    return sign;
  }
  for (const Point& p : first)
    for (const Point& q : second)
      sign = std::min(sign, (Exact(n.x()) * (Exact(q.x()) - Exact(p.x())) +
                             Exact(n.y()) * (Exact(q.y()) - Exact(p.y())))
                                .sign());
  return sign;
}

// ---------------------------------------------------------------- one direction

/// How projections are compared.
enum class Apart {
  rightly,
  if_touching,
  in_either_order,
  in_the_other_order,
  by_the_first_vertices,
  high_from_zero,
  by_some_vertices,
  by_centres,
  by_a_millionth,
  in_float,
  by_unit,
  if_nearly_touching
};

inline double projected(const Point& n, const Point& p, Apart apart) {
  if (apart == Apart::in_float)
    return static_cast<float>(n.x()) * static_cast<float>(p.x()) +
           static_cast<float>(n.y()) * static_cast<float>(p.y());
  if (apart == Apart::by_unit) return n.normalized().dot(p);
  if (apart == Apart::if_nearly_touching) return n.dot(p);
  return static_cast<double>(dot(n, p));
}

inline bool separates(const Point& n, const Polygon& first, const Polygon& second,
                      Apart apart = Apart::rightly) {
  if (apart == Apart::in_either_order)
    return separates(n, first, second) || separates(n, second, first);
  if (apart == Apart::in_the_other_order) return separates(n, second, first);
  if (apart == Apart::by_the_first_vertices) return separates(n, {first.front()}, {second.front()});
  if (apart == Apart::by_centres) {
    Point a = Point::Zero(), b = Point::Zero();
    for (const Point& p : first) a += p;
    for (const Point& q : second) b += q;
    return n.dot(a) * double(second.size()) < n.dot(b) * double(first.size());
  }
  const auto along = [&](const Point& p) { return projected(n, p, apart); };
  const auto less = [&](const Point& p, const Point& q) { return along(p) < along(q); };
  const double end = along(*std::max_element(first.begin(), first.end(), less));
  const double begin = along(*std::min_element(second.begin(), second.end(), less));
  switch (apart) {
    case Apart::if_touching:
      return end <= begin;
    case Apart::high_from_zero:
      return std::max(end, 0.0) < begin;
    case Apart::by_some_vertices:
      return along(*std::min_element(first.begin(), first.end(), less)) <
             along(*std::max_element(second.begin(), second.end(), less));
    case Apart::by_a_millionth:
      return (begin - end) / n.norm() > 1e-6;
    case Apart::if_nearly_touching:
      return end < begin + 1e-8;
    default:
      return end < begin;
  }
}

// ---------------------------------------------------------------- the search

/// Which directions are tried, and what becomes of them.
struct Search {
  bool of_first = true, of_second = true;  ///< the edges of which polygon
  bool last_edge = true;                   ///< from the last vertex to the first
  bool edges = false;                      ///< as directions, instead of their normals
  bool inwards = false;                    ///< normals of both polygons
  bool second_outwards = false;            ///< normals of the second alone are not reversed
  bool first_decides = false;              ///< no other direction is tried after the first
  bool along = true;                       ///< the line through a vertex of each
};

inline std::vector<Point> directions(const Polygon& polygon, const Search& search) {
  std::vector<Point> all;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (i + 1 == polygon.size() && !search.last_edge) continue;
    const Point edge = next(polygon, i) - polygon[i];
    const Point normal(edge.y(), -edge.x());
    all.push_back(search.edges ? edge : search.inwards ? -normal : normal);
  }
  return all;
}

inline Axis separating_axis(const Polygon& first, const Polygon& second,
                            const Search& search = {}) {
  std::vector<Point> all;
  if (search.of_first) all = directions(first, search);
  if (search.of_second)
    for (const Point& n : directions(second, search))
      all.push_back(search.second_outwards ? n : -n);
  if (search.along) all.push_back(second.front() - first.front());
  if (search.first_decides) all.resize(1);
  for (const Point& n : all)
    if (polygons_with_mistakes::separates(n, first, second)) return n;
  return std::nullopt;
}

/// Only the directions of the coordinates are tried.
inline Axis by_boxes(const Polygon& first, const Polygon& second) {
  for (const Point& n : {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)})
    if (polygons_with_mistakes::separates(n, first, second)) return n;
  return std::nullopt;
}

/// Only the line through the centres is tried.
inline Axis by_centres(const Polygon& first, const Polygon& second) {
  Point a = Point::Zero(), b = Point::Zero();
  for (const Point& p : first) a += p * double(second.size());
  for (const Point& q : second) b += q * double(first.size());
  if (sign_of_gap(b - a, first, second) > 0) return Point(b - a);
  return std::nullopt;
}

}  // namespace polygons_with_mistakes
