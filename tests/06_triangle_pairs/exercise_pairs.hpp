/// @file
/// Whether two triangles with whole coordinates have a point in common, in integers and by
/// separating directions, which the exercises' solutions do not use. The tests of the exercises
/// compare answers with these.
#pragma once

#include <algorithm>
#include <array>
#include <contact/shapes.hpp>
#include <cstdint>
#include <utility>
#include <vector>

namespace exercise_pairs {

using Point = Eigen::Vector3d;
using Triangle = contact::Triangle<double>;

/// A vector of integers. With coordinates up to 2^11, integers hold every projection below.
struct Vector {
  std::array<std::int64_t, 3> at{};
};
inline Vector to_integers(const Point& p) {
  return {{static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y()),
           static_cast<std::int64_t>(p.z())}};
}
inline Vector difference(const Point& p, const Point& q) {
  const Vector u = to_integers(p), v = to_integers(q);
  return {{u.at[0] - v.at[0], u.at[1] - v.at[1], u.at[2] - v.at[2]}};
}
inline Vector cross(const Vector& u, const Vector& v) {
  const auto& [a, b, c] = u.at;
  const auto& [x, y, z] = v.at;
  return {{b * z - c * y, c * x - a * z, a * y - b * x}};
}
inline std::int64_t dot(const Vector& u, const Vector& v) {
  return u.at[0] * v.at[0] + u.at[1] * v.at[1] + u.at[2] * v.at[2];
}
inline bool is_zero(const Vector& v) { return v.at == Vector{}.at; }
inline int sign(std::int64_t x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

inline std::array<Point, 3> vertices(const Triangle& t) { return {t.a, t.b, t.c}; }
inline std::array<std::pair<Point, Point>, 3> edges(const Triangle& t) {
  return {{{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}};
}
/// The triangle in all six orders of its vertices.
inline std::array<Triangle, 6> orders(const Triangle& t) {
  const auto& [a, b, c] = t;
  return {{{a, b, c}, {b, c, a}, {c, a, b}, {c, b, a}, {b, a, c}, {a, c, b}}};
}
/// (b − a) × (c − a).
inline Vector normal(const Triangle& t) {
  return cross(difference(t.b, t.a), difference(t.c, t.a));
}
inline bool has_area(const Triangle& t) { return !is_zero(normal(t)); }

/// Positive in front of the triangle, 0 in its plane.
inline std::int64_t ahead(const Triangle& t, const Point& p) {
  return dot(normal(t), difference(p, t.a));
}
/// Of the three vertices of `of` and the plane of `plane`.
inline std::array<std::int64_t, 3> distances(const Triangle& of, const Triangle& plane) {
  return {ahead(plane, of.a), ahead(plane, of.b), ahead(plane, of.c)};
}
inline bool one_side(const std::array<std::int64_t, 3>& d) {
  const auto [low, high] = std::minmax_element(d.begin(), d.end());
  return *low > 0 || *high < 0;
}

/// Whether the projections to a direction are apart. A direction of zero separates nothing.
inline bool apart_along(const Vector& direction, const Triangle& first, const Triangle& second) {
  const auto range = [&](const Triangle& t) {
    return std::minmax({dot(direction, to_integers(t.a)), dot(direction, to_integers(t.b)),
                        dot(direction, to_integers(t.c))});
  };
  const auto [low, high] = range(first);
  const auto [low2, high2] = range(second);
  return high < low2 || high2 < low;
}

/// Whether one plane contains all six vertices: then each four of them have no volume.
inline bool in_one_plane(const Triangle& first, const Triangle& second) {
  const std::array<Point, 6> all{first.a, first.b, first.c, second.a, second.b, second.c};
  for (std::size_t i = 1; i < 6; ++i)
    for (std::size_t j = i + 1; j < 6; ++j)
      for (std::size_t k = j + 1; k < 6; ++k) {
        const Vector n = cross(difference(all[i], all[0]), difference(all[j], all[0]));
        if (dot(n, difference(all[k], all[0])) != 0) return false;
      }
  return true;
}

/// Of triangles with areas that are not in one plane: they are apart if one of the two normals or
/// the product of two edges separates them.
inline bool meet_across_planes(const Triangle& first, const Triangle& second) {
  std::vector<Vector> directions{normal(first), normal(second)};
  for (const auto& [a, b] : edges(first))
    for (const auto& [c, d] : edges(second))
      directions.push_back(cross(difference(b, a), difference(d, c)));
  return std::none_of(directions.begin(), directions.end(),
                      [&](const Vector& v) { return apart_along(v, first, second); });
}

/// Of triangles in one plane, also without area: they are apart if a direction of the plane
/// separates them that is perpendicular to the line of two of the six vertices, or along it.
inline bool meet_in_one_plane(const Triangle& first, const Triangle& second) {
  const std::array<Point, 6> all{first.a, first.b, first.c, second.a, second.b, second.c};
  Vector n;
  for (const Point& p : all)
    for (const Point& q : all)
      if (is_zero(n)) n = cross(difference(p, all[0]), difference(q, all[0]));
  for (const Point& p : all)
    for (const Point& q : all) {
      const Vector along = difference(q, p);
      if (apart_along(along, first, second) || apart_along(cross(n, along), first, second))
        return false;
    }
  return true;
}

inline bool all_whole(const Triangle& first, const Triangle& second, double limit) {
  const auto is_whole = [limit](const Triangle& t) {
    const std::array<Point, 3> of = vertices(t);
    return std::all_of(of.begin(), of.end(), [limit](const Point& v) {
      return v == v.array().round().matrix() && v.cwiseAbs().maxCoeff() <= limit;
    });
  };
  return is_whole(first) && is_whole(second);
}

}  // namespace exercise_pairs
