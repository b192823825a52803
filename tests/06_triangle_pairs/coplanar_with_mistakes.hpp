/// @file
/// Whether two triangles in one plane meet, each time with one mistake that people make: what a
/// test recognises.
#pragma once

#include <06_triangle_pairs/exercise_pairs.hpp>
#include <cmath>
#include <cstdlib>

namespace exercise_pairs::coplanar_with_mistakes {

using Flat = std::array<Eigen::Matrix<std::int64_t, 2, 1>, 3>;
using FlatPoint = Flat::value_type;

/// Which coordinate is dropped.
enum class Drop { best, z, worst };

/// What differs from what is right.
struct Ways {
  Drop drop = Drop::best;      ///< the coordinate that is dropped
  bool edges = true;           ///< edges are asked whether they meet
  bool one_inside = true;      ///< the first vertex of the first is asked for inside the second
  bool other_inside = true;    ///< and that of the second for inside the first
  bool all_inside = false;     ///< all vertices are asked so
  std::size_t edge_count = 3;  ///< how many edges a triangle has
  bool touching = true;        ///< touching counts
  bool parallel = true;        ///< parallel edges can meet
  bool clockwise = true;       ///< the vertices may be clockwise in the projection
  bool ends_of_lines = true;   ///< a triangle without area ends somewhere
  double epsilon = 0;          ///< areas below this share of their sides' product are zero
};

/// A normal of the plane; zero if all six vertices are on one line.
inline Vector common_normal(const Triangle& first, const Triangle& second) {
  const std::array<Point, 6> all{first.a, first.b, first.c, second.a, second.b, second.c};
  for (const Point& p : all)
    for (const Point& q : all) {
      const Vector n = cross(difference(p, all[0]), difference(q, all[0]));
      if (!is_zero(n)) return n;
    }
  return {};
}

inline Flat without(std::size_t axis, const Triangle& t) {
  const auto drop = [axis](const Point& p) {
    const Vector v = to_integers(p);
    return FlatPoint(v.at[(axis + 1) % 3], v.at[(axis + 2) % 3]);
  };
  return {drop(t.a), drop(t.b), drop(t.c)};
}

inline int side(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p, const Ways& ways) {
  const FlatPoint u = b - a, v = p - a;
  const std::int64_t area = u.x() * v.y() - u.y() * v.x();
  const double size = u.cast<double>().norm() * v.cast<double>().norm();
  return std::abs(static_cast<double>(area)) <= ways.epsilon * size ? 0 : sign(area);
}

inline bool segments_meet(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c,
                          const FlatPoint& d, const Ways& ways) {
  const FlatPoint u = b - a, v = d - c;
  if (!ways.parallel && u.x() * v.y() == u.y() * v.x()) return false;
  const int abc = side(a, b, c, ways), abd = side(a, b, d, ways);
  const int cda = side(c, d, a, ways), cdb = side(c, d, b, ways);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  const auto between = [](const FlatPoint& p, const FlatPoint& q, const FlatPoint& x) {
    return (x - p).dot(x - q) <= 0;
  };
  return ways.touching && ((abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
                           (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b)));
}

inline bool contains(const Flat& t, const FlatPoint& p, const Ways& ways) {
  const std::array<int, 3> sides{side(t[0], t[1], p, ways), side(t[1], t[2], p, ways),
                                 side(t[2], t[0], p, ways)};
  const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
  if (!ways.ends_of_lines && *low == 0 && *high == 0) return true;
  return *low > 0 || (*high < 0 && ways.clockwise);
}

inline bool meet_in_plane(const Flat& first, const Flat& second, const Ways& ways) {
  for (std::size_t i = 0; i < ways.edge_count && ways.edges; ++i)
    for (std::size_t j = 0; j < ways.edge_count; ++j)
      if (segments_meet(first[i], first[(i + 1) % 3], second[j], second[(j + 1) % 3], ways))
        return true;
  const std::size_t vertices = ways.all_inside ? 3 : 1;
  for (std::size_t i = 0; i < vertices; ++i)
    if ((ways.one_inside && contains(second, first[i], ways)) ||
        (ways.other_inside && contains(first, second[i], ways)))
      return true;
  return false;
}

inline bool meet(const Triangle& first, const Triangle& second, const Ways& ways = {}) {
  // If all vertices are on one line, any coordinate may be dropped in which they differ not alone.
  Vector n = common_normal(first, second);
  const std::array<Point, 6> all{first.a, first.b, first.c, second.a, second.b, second.c};
  for (const Point& p : all)
    for (const Vector& across : {Vector{{1, 0, 0}}, Vector{{0, 1, 0}}})
      if (is_zero(n)) n = cross(difference(p, all[0]), across);
  std::size_t axis = ways.drop == Drop::z ? 2 : 0;
  for (std::size_t i = 0; i < 3 && ways.drop != Drop::z; ++i) {
    const bool larger = std::abs(n.at[i]) > std::abs(n.at[axis]);
    const bool smaller = std::abs(n.at[i]) < std::abs(n.at[axis]);
    if (ways.drop == Drop::best ? larger : smaller) axis = i;
  }
  return meet_in_plane(without(axis, first), without(axis, second), ways);
}

inline bool boxes_meet(const Triangle& first, const Triangle& second) {
  for (int i = 0; i < 3; ++i) {
    const auto range = [&](const Triangle& t) { return std::minmax({t.a[i], t.b[i], t.c[i]}); };
    if (range(first).second < range(second).first || range(second).second < range(first).first)
      return false;
  }
  return true;
}

/// By the directions perpendicular to the edges of the first triangle alone.
inline bool not_separated_by_the_first(const Triangle& first, const Triangle& second) {
  const Vector n = common_normal(first, second);
  const auto all = edges(first);
  return std::none_of(all.begin(), all.end(), [&](const auto& edge) {
    return apart_along(cross(n, difference(edge.second, edge.first)), first, second);
  });
}

/// Whether the first vertices of `second` are in the plane of `first`, if it has one.
inline bool in_plane_of(const Triangle& first, const Triangle& second, std::size_t vertices) {
  const std::array<std::int64_t, 3> d = distances(second, first);
  return std::all_of(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(vertices),
                     [](std::int64_t x) { return x == 0; });
}

}  // namespace exercise_pairs::coplanar_with_mistakes
