/// @file
/// What two triangles have in common: nothing, a point, a segment or a convex polygon, its vertices
/// with a bound on their errors, and the features of both triangles that they are on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/error_free.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/feature_pairs.hpp>
#include <contact/feature_positions.hpp>
#include <contact/shapes.hpp>
#include <contact/triangle_features.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace contact {

// [common-point]
/// A vertex of what two triangles have in common.
template <FloatOrDouble S>
struct CommonPoint {
  Vector3<S> position = Vector3<S>::Zero();  ///< m
  Feature of_first;   ///< the smallest feature of the first triangle that has the exact point
  Feature of_second;  ///< the same of the second
};

/// What two triangles have in common.
template <FloatOrDouble S>
struct TriangleIntersection {
  CommonPoints kind = CommonPoints::none;  ///< nothing, a point, a segment, a polygon
  std::array<CommonPoint<S>, 6> points{};  ///< the point, two ends, or 3 to 6 vertices in order
  int count = 0;                           ///< how many of them are used
  S bound = S(0);  ///< m; each coordinate of each exact point differs by at most this
};
// [/common-point]

namespace triangle_intersection_detail {

using feature_pairs_detail::ExactPosition;
using feature_pairs_detail::FeaturePair;
using feature_pairs_detail::FeaturePairs;
using feature_pairs_detail::is_before;
using feature_pairs_detail::PointSet;

/// A triangle with its vertices in the order of their coordinates (equal ones in that of their
/// indices), and as a set of points.
template <class P>
struct SortedTriangle {
  std::array<int, 3> index{0, 1, 2};  ///< of these vertices in the triangle as given
  std::array<P, 3> at;                ///< m
  PointSet<P> set;                    ///< has the same order

  explicit SortedTriangle(const std::array<P, 3>& vertices)
      : at(sorted(vertices, index)), set(feature_pairs_detail::point_set<P>(at)) {}

 private:
  static std::array<P, 3> sorted(std::array<P, 3> vertices, std::array<int, 3>& index) {
    for (const std::size_t i : {0U, 1U, 0U}) {
      if (!is_before(vertices[i + 1], vertices[i])) continue;
      std::swap(vertices[i], vertices[i + 1]);
      std::swap(index[i], index[i + 1]);
    }
    return vertices;
  }
};

/// Converts to double; + 0.0 makes each zero positive.
template <FloatOrDouble S>
SortedTriangle<Vector3<double>> sorted_triangle(const Triangle<S>& triangle) {
  const auto plain = [](const Vector3<S>& v) {
    return Vector3<double>(v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
  };
  return SortedTriangle<Vector3<double>>({plain(triangle.a), plain(triangle.b), plain(triangle.c)});
}

/// The order in which two triangles are treated: that of their sorted vertices.
template <class P>
bool is_before_triangle(const SortedTriangle<P>& a, const SortedTriangle<P>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.at[i] != b.at[i]) return is_before(a.at[i], b.at[i]);
  }
  return false;
}

/// The feature of a segment or a point that is given as a triangle, from that of the set of points:
/// the smallest edge or the vertex that contains x; the first of equal ones.
template <class P>
Feature feature_without_area(const SortedTriangle<P>& t, const Feature& of_set,
                             const ExactPosition& x) {
  const auto vertex = [](int i) { return Feature{FeatureKind::vertex, i}; };
  const auto edge = [&t](std::size_t i, std::size_t j) {
    return Feature{FeatureKind::edge, edge_between(t.index[i], t.index[j])};
  };
  const bool low = t.at[0] == t.at[1], high = t.at[1] == t.at[2];
  if (of_set.kind == FeatureKind::vertex) {
    if (of_set.index == 0) return vertex(t.index[0]);
    return vertex(high ? t.index[1] : t.index[2]);
  }
  if (low || high) {
    const Feature whole = edge(0, 2), same = low ? edge(1, 2) : edge(0, 1);
    return whole.index < same.index ? whole : same;
  }
  const auto set = feature_pairs_detail::in_exact(PointSet<P>{t.at, 3});
  int k = 0;
  while (set[0][k] == set[2][k]) ++k;  // along which the vertices are sorted
  const int order = x.compare(k, set[1][k]);
  return order == 0 ? vertex(t.index[1]) : (order < 0 ? edge(0, 1) : edge(1, 2));
}

/// The feature of a triangle as given, from that of its set of points.
template <class P>
Feature feature_as_given(const SortedTriangle<P>& t, const Feature& of_set, const FeaturePair& pair,
                         const PointSet<P>& a, const PointSet<P>& b) {
  if (t.set.size < 3) {
    using feature_pairs_detail::in_exact;
    return feature_without_area(t, of_set, exact_position(pair, in_exact(a), in_exact(b)));
  }
  const auto index = [&t](int i) { return t.index[static_cast<std::size_t>(i % 3)]; };
  switch (of_set.kind) {
    case FeatureKind::vertex:
      return {FeatureKind::vertex, index(of_set.index)};
    case FeatureKind::edge:
      return {FeatureKind::edge, edge_between(index(of_set.index), index(of_set.index + 1))};
    case FeatureKind::face:
      break;
  }
  return {};
}

/// Two triangles in the order in which they are treated, and what they have in common.
template <class P>
struct SortedPair {
  SortedTriangle<P> low, high;
  bool swapped;        ///< whether the first triangle is `high`
  FeaturePairs pairs;  ///< of low and high

  SortedPair(const SortedTriangle<P>& first, const SortedTriangle<P>& second)
      : low(first), high(second), swapped(is_before_triangle(second, first)) {
    if (swapped) std::swap(low, high);
    pairs = feature_pairs_detail::feature_pairs<P>(low.set, high.set);
  }
  /// The features of vertex i of the common set, as the triangles were given.
  FeaturePair as_given(int i) const {
    const FeaturePair& pair = pairs[i];
    FeaturePair given{feature_as_given(low, pair.of_first, pair, low.set, high.set),
                      feature_as_given(high, pair.of_second, pair, low.set, high.set)};
    if (swapped) std::swap(given.of_first, given.of_second);
    return given;
  }
};

/// Whether all coordinates are finite.
template <FloatOrDouble S>
bool finite_triangle(const Triangle<S>& t) {
  return all_finite(t.a) && all_finite(t.b) && all_finite(t.c);
}
/// Whether no plane x, y or z = constant is between them.
template <FloatOrDouble S>
bool boxes_meet(const Triangle<S>& s, const Triangle<S>& t) {
  for (int k = 0; k < 3; ++k) {
    const auto [s_low, s_high] = std::minmax({s.a[k], s.b[k], s.c[k]});
    const auto [t_low, t_high] = std::minmax({t.a[k], t.b[k], t.c[k]});
    if (s_high < t_low || t_high < s_low) return false;
  }
  return true;
}

/// The pair, if it is finite and its boxes meet.
template <FloatOrDouble S>
std::optional<SortedPair<Vector3<double>>> sorted_pair(const Triangle<S>& first,
                                                       const Triangle<S>& second) {
  if (!finite_triangle(first) || !finite_triangle(second)) return std::nullopt;
  if (!boxes_meet(first, second)) return std::nullopt;
  return SortedPair<Vector3<double>>(sorted_triangle(first), sorted_triangle(second));
}

/// A vertex of the common set, rounded once. Copies of vertices have no error.
template <FloatOrDouble S>
void set_to_last_place(Vector3<S>& position, S& bound, const FeaturePair& pair,
                       const SortedPair<Vector3<double>>& sorted) {
  using feature_pairs_detail::in_exact;
  const ExactPosition x = exact_position(pair, in_exact(sorted.low.set), in_exact(sorted.high.set));
  for (int k = 0; k < 3; ++k) {
    position[k] = quotient<S>(x.above[k], x.below) + S(0);
    if (pair.of_first.kind != FeatureKind::vertex && pair.of_second.kind != FeatureKind::vertex) {
      bound = std::max({bound, ulp(position[k]) / 2, std::numeric_limits<S>::denorm_min()});
    }
  }
}

/// A vertex of the common set from double, or, if its bound is not small enough, exactly.
template <FloatOrDouble S>
void set_with_bound(Vector3<S>& position, S& bound, const FeaturePair& pair,
                    const SortedPair<Vector3<double>>& sorted) {
  const auto x = bounded_position(pair, sorted.low.set, sorted.high.set);
  if (!x.sharp) return set_to_last_place(position, bound, pair, sorted);
  position = x.value.template cast<S>();
  if constexpr (std::same_as<S, double>) {
    bound = std::max(bound, x.bound);
  } else if (x.bound > 0) {
    // Half an ulp for the conversion, and as much to round the bound itself up.
    constexpr S u = std::numeric_limits<S>::epsilon();
    for (int k = 0; k < 3; ++k) {
      bound = std::max(bound, static_cast<S>(x.bound) * (1 + u) + ulp(position[k]));
    }
  }
}

/// The common points with positions by set(position, bound, pair, sorted).
template <FloatOrDouble S, class Set>
TriangleIntersection<S> intersection_by(const Triangle<S>& first, const Triangle<S>& second,
                                        const Set& set) {
  TriangleIntersection<S> found;
  const auto sorted = sorted_pair(first, second);
  if (!sorted) return found;
  found.kind = sorted->pairs.kind();
  found.count = sorted->pairs.count;
  for (int i = 0; i < found.count; ++i) {
    CommonPoint<S>& point = found.points[static_cast<std::size_t>(i)];
    const FeaturePair given = sorted->as_given(i);
    point.of_first = given.of_first;
    point.of_second = given.of_second;
    set(point.position, found.bound, sorted->pairs[i], *sorted);
  }
  return found;
}

}  // namespace triangle_intersection_detail

// [intersect-triangles]
/// What two triangles have in common: the book's choice.
///
/// Kind and features are right for every finite input, by orientation predicates alone. Touching
/// counts. A triangle without area is the segment or the point that it is. Triangles with a
/// coordinate that is not finite have nothing in common.
///
/// The points: the single one; the two ends of a segment; the vertices of a polygon,
/// counter-clockwise in the first projection (to yz, zx, xy) in which the triangles have area. For
/// each, the smallest features of both triangles that contain it. A triangle without area has no
/// face, and where two of its vertices or edges are equal as sets of points, the one with the
/// smaller index is taken.
///
/// Positions that are vertices are copied (−0 becomes 0). The others are a point p + t (q − p) of
/// an edge. t is computed in double; if its bound is above 2^-40, exact arithmetic computes the
/// point and rounds it once. So `bound` is at most about 2^-40 of the edge, plus 4 roundings of a
/// coordinate. The position need not be exactly on either triangle.
///
/// Vertices and triangles are sorted first, so positions, bound and the order of the points have
/// the same bits for every order of the vertices of each triangle and of the two triangles.
/// @param first m, finite
/// @param second m, finite
template <FloatOrDouble S>
TriangleIntersection<S> intersect_triangles(const Triangle<S>& first, const Triangle<S>& second) {
  return triangle_intersection_detail::intersection_by(
      first, second, [](Vector3<S>& position, S& bound, const auto& pair, const auto& sorted) {
        triangle_intersection_detail::set_with_bound(position, bound, pair, sorted);
      });
}

/// The same, with each coordinate rounded once, to the nearest number of S: exact arithmetic for
/// every point, slow. The bound is half an ulp of the largest coordinate that was rounded, 0 if all
/// points are vertices.
template <FloatOrDouble S>
TriangleIntersection<S> intersect_triangles_to_last_place(const Triangle<S>& first,
                                                          const Triangle<S>& second) {
  return triangle_intersection_detail::intersection_by(
      first, second, [](Vector3<S>& position, S& bound, const auto& pair, const auto& sorted) {
        triangle_intersection_detail::set_to_last_place(position, bound, pair, sorted);
      });
}

/// Only the kind of what `intersect_triangles` returns.
template <FloatOrDouble S>
CommonPoints common_points(const Triangle<S>& first, const Triangle<S>& second) {
  const auto sorted = triangle_intersection_detail::sorted_pair(first, second);
  return sorted ? sorted->pairs.kind() : CommonPoints::none;
}
// [/intersect-triangles]

}  // namespace contact
