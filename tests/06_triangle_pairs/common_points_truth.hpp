/// @file
/// What two triangles have in common, in fractions and by the definitions: candidates are tested
/// one by one whether they are in both triangles, and those that are in the convex hull of the
/// others are left out. Slow, and without orientations of the book.
#pragma once

#include <contact/shapes.hpp>
#include <contact/triangle_features.hpp>

#include <support/oracle.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace common_points_truth {

using contact::Feature;
using contact::FeatureKind;
using oracle::Rational;
using oracle::Vector;

/// The vertices of a triangle in fractions.
using Vertices = std::array<Vector, 3>;
template <std::floating_point S>
Vertices vertices(const contact::Triangle<S>& t) {
  return {oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c)};
}
inline const Vector& at(const Vertices& t, int i) { return t[static_cast<std::size_t>(i % 3)]; }
inline bool is_zero(const Vector& v) { return v.x() == 0 && v.y() == 0 && v.z() == 0; }
inline Vector cross(const Vector& u, const Vector& v) { return u.cross(v); }

/// The shortest edge that has x between its ends, the first of equal ones.
inline std::optional<Feature> edge_at(const Vector& x, const Vertices& t) {
  std::optional<Feature> found;
  Rational shortest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector step = at(t, i + 1) - at(t, i), to = x - at(t, i);
    const Rational along = step.dot(to), whole = step.dot(step);
    if (!is_zero(cross(step, to)) || along <= 0 || along >= whole) continue;
    if (found && whole >= shortest) continue;
    found = Feature{FeatureKind::edge, i};
    shortest = whole;
  }
  return found;
}

/// The smallest feature of a triangle that contains x, if any does.
inline std::optional<Feature> feature_at(const Vector& x, const Vertices& t) {
  for (int i = 0; i < 3; ++i) {
    if (x == at(t, i)) return Feature{FeatureKind::vertex, i};
  }
  if (const auto edge = edge_at(x, t)) return edge;
  const Vector normal = cross(t[1] - t[0], t[2] - t[0]);
  if (is_zero(normal) || normal.dot(x - t[0]) != 0) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    if (normal.dot(cross(at(t, i + 1) - at(t, i), x - at(t, i))) <= 0) return std::nullopt;
  }
  return Feature{FeatureKind::face, 0};
}

/// A vertex of the common set.
struct Point {
  Vector position;
  Feature of_first, of_second;
};

/// Points of both triangles, among which are all vertices of the common set.
inline std::vector<Vector> candidates(const Vertices& a, const Vertices& b) {
  std::vector<Vector> found;
  const auto add = [&](const Vector& x) {
    if (!feature_at(x, a) || !feature_at(x, b)) return;
    if (std::find(found.begin(), found.end(), x) == found.end()) found.push_back(x);
  };
  for (const Vector& x : a) add(x);
  for (const Vector& x : b) add(x);
  const auto add_crossings = [&](const Vertices& edges, const Vertices& face) {
    const Vector normal = cross(face[1] - face[0], face[2] - face[0]);
    for (int i = 0; i < 3; ++i) {
      const Vector step = at(edges, i + 1) - at(edges, i);
      const Rational rate = normal.dot(step);
      if (rate == 0) continue;
      add(at(edges, i) + step * Rational(normal.dot(face[0] - at(edges, i)) / rate));
    }
  };
  add_crossings(a, b);
  add_crossings(b, a);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector e = at(a, i + 1) - at(a, i), f = at(b, j + 1) - at(b, j);
      const Vector normal = cross(e, f);
      const Rational whole = normal.dot(normal);
      if (whole == 0) continue;
      const Rational along = normal.dot(cross(at(b, j) - at(a, i), f));
      add(at(a, i) + e * Rational(along / whole));
    }
  }
  return found;
}

/// Whether point i is in the convex hull of the others, all of one plane.
inline bool is_in_hull(const std::vector<Vector>& points, std::size_t i) {
  const std::size_t n = points.size();
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t q = 0; q < n; ++q) {
      for (std::size_t r = 0; r < n; ++r) {
        if (p == i || q == i || r == i) continue;
        if (feature_at(points[i], {points[p], points[q], points[r]})) return true;
      }
    }
  }
  return false;
}

/// The vertices of what two triangles have in common, in any order.
inline std::vector<Point> common_vertices(const Vertices& a, const Vertices& b) {
  const std::vector<Vector> points = candidates(a, b);
  std::vector<Point> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_in_hull(points, i)) continue;
    found.push_back({points[i], *feature_at(points[i], a), *feature_at(points[i], b)});
  }
  return found;
}

}  // namespace common_points_truth
