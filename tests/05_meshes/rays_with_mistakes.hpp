/// @file
/// What known mistakes answer for a point and a mesh, in integers.
#pragma once

#include <numeric>

#include <05_meshes/solids.hpp>

namespace mistakes {

using solids::Mesh;
using solids::Point;
using solids::Triangle;
using solids::Vector;
using Triangles = std::vector<Triangle>;

/// +x, −x, +y, −y, +z, −z.
inline Vector along_axis(int i) {
  Vector d;
  d.at[static_cast<std::size_t>(i / 2)] = i % 2 == 0 ? 1 : -1;
  return d;
}

enum class Borders { counted, left_out };

/// How many triangles the ray meets. A triangle along the ray counts nothing.
inline int count(const Triangles& all, const Point& p, const Vector& d, Borders borders) {
  int met = 0;
  for (const Triangle& t : all) {
    const auto meeting = meet(t, p, d);
    met += meeting && (borders == Borders::counted || !meeting->at_border) ? 1 : 0;
  }
  return met;
}

/// The same with borders, where triangles that are met at the same t count as one.
inline int count_merged(const Triangles& all, const Point& p, const Vector& d) {
  std::vector<solids::Meeting> found;
  for (const Triangle& t : all) {
    const auto meeting = meet(t, p, d);
    const auto is_equal = [&](const solids::Meeting& m) {
      return m.t * meeting->over == meeting->t * m.over;
    };
    if (meeting && std::none_of(found.begin(), found.end(), is_equal)) found.push_back(*meeting);
  }
  return static_cast<int>(found.size());
}

/// Whether the ray leaves the solid through the first triangle that it meets; the first of equals.
inline bool leaves_first(const Triangles& all, const Point& p, const Vector& d) {
  std::optional<solids::Meeting> first;
  for (const Triangle& t : all) {
    const auto meeting = meet(t, p, d);
    if (meeting && (!first || meeting->t * first->over < first->t * meeting->over)) first = meeting;
  }
  return first && first->side > 0;
}

/// Whether there is a triangle in both directions along each of the axes.
inline bool between_walls(const Triangles& all, const Point& p, const std::vector<int>& axes) {
  return std::all_of(axes.begin(), axes.end(), [&](int axis) {
    return count(all, p, along_axis(2 * axis), Borders::counted) > 0 &&
           count(all, p, along_axis(2 * axis + 1), Borders::counted) > 0;
  });
}

/// Twice the area of a, b, c, projected along an axis.
inline std::int64_t area(const Point& a, const Point& b, const Point& c, std::size_t axis) {
  return solids::cross(solids::difference(b, a), solids::difference(c, a)).at[axis];
}

/// How many triangles the ray along +axis crosses if, seen along the ray, an end level with the
/// point is not above it. An edge through the point is to its left; or, `by_direction`, to its left
/// or right, whichever way it goes in the triangle.
inline int crossings(const Triangles& all, const Point& p, int axis, bool by_direction) {
  const int up = (axis + 2) % 3;
  const auto along = static_cast<std::size_t>(axis);
  int met = 0;
  for (const Triangle& t : all) {
    bool inside = false;
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
      const bool ends_above = to[up] > p[up];
      if ((from[up] > p[up]) == ends_above) continue;
      const std::int64_t left = area(from, to, p, along) * (by_direction || ends_above ? 1 : -1);
      if ((left > 0) == (by_direction ? ends_above : true)) inside = !inside;
    }
    const bool is_behind = solids::ahead(t, p) < 0;
    met += inside && is_behind == (solids::normal(t).at[along] > 0) ? 1 : 0;
  }
  return met;
}

/// Whether the point is inside the triangle or on its border if both are projected along an axis.
inline bool in_column(const Triangle& t, const Point& p, std::size_t axis) {
  const std::int64_t whole = area(t.a, t.b, t.c, axis);
  const auto inner = [&](const Point& from, const Point& to) {
    return area(from, to, p, axis) * solids::sign(whole) >= 0;
  };
  return inner(t.a, t.b) && inner(t.b, t.c) && inner(t.c, t.a);
}

/// Whether the point is on the triangle if a distance from the plane of at most `epsilon` is none.
inline bool on_triangle(const Triangle& t, const Point& p, double epsilon) {
  const Point n = (t.b - t.a).cross(t.c - t.a);
  const auto inner = [&](const Point& from, const Point& to) {
    return n.dot((to - from).cross(p - from)) >= 0;
  };
  return std::abs(n.dot(p - t.a)) <= epsilon * n.norm() && inner(t.a, t.b) && inner(t.b, t.c) &&
         inner(t.c, t.a);
}

/// Whether the point is behind the triangle whose centroid is nearest; the first of equals.
inline bool behind_nearest(const Triangles& all, const Point& p) {
  const auto squared = [&](const Triangle& t) { return (t.a + t.b + t.c - 3 * p).squaredNorm(); };
  const auto nearest = std::min_element(
      all.begin(), all.end(),
      [&](const Triangle& s, const Triangle& t) { return squared(s) < squared(t); });
  return solids::ahead(*nearest, p) < 0;
}

/// The triangles that are connected with the first one.
inline Mesh first_shell(const Mesh& mesh) {
  std::vector<bool> reached(mesh.vertices.size());
  for (const int v : mesh.triangles.front()) reached[static_cast<std::size_t>(v)] = true;
  const auto touches = [&](const std::array<int, 3>& t) {
    return std::any_of(t.begin(), t.end(),
                       [&](int v) { return reached[static_cast<std::size_t>(v)]; });
  };
  for (std::size_t round = 0; round < mesh.vertices.size(); ++round) {
    for (const auto& t : mesh.triangles) {
      if (!touches(t)) continue;
      for (const int v : t) reached[static_cast<std::size_t>(v)] = true;
    }
  }
  Mesh shell{mesh.vertices, {}};
  std::copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(shell.triangles),
               touches);
  return shell;
}

}  // namespace mistakes
