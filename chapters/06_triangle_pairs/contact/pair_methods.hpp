/// @file
/// Whether two triangles meet, by four methods as they are often written, each in the rounding of
/// the scalar: the lecture's steps, intervals on a line, edges against faces, separating axes.
///
/// None is right for every input; `triangles_meet` is. With an exact field for S, such as the
/// rationals, each is exact within the limits that its comment names.
#pragma once

#include <algorithm>
#include <array>
#include <contact/drop_dimension.hpp>
#include <contact/ray_triangle.hpp>
#include <contact/segments.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <utility>

namespace contact {

/// What the lecture's four steps find about two triangles, and in which step they decide.
template <Ring S>
struct PairBySteps {
  bool meet = false;      ///< the answer; false if the steps have none
  int decided_in = 0;     ///< 2: a plane separates them; 4: the segment pq decides; 0: no answer
  bool coplanar = false;  ///< all d_i are 0: the steps have no answer
  bool crosses_plane = false;         ///< whether step 3 was reached, so that p and q are set
  Vector3<S> p = Vector3<S>::Zero();  ///< m; where the first's border meets the second's plane
  Vector3<S> q = Vector3<S>::Zero();  ///< m; the other such point, or p again if there is only one
};

namespace pair_methods_detail {

/// One number for each vertex of a triangle.
template <Ring S>
using OfVertices = std::array<S, 3>;

template <Ring S>
std::array<Vector3<S>, 3> vertices(const Triangle<S>& t) {
  return {t.a, t.b, t.c};
}
template <Ring S>
Vector3<S> normal_of(const Triangle<S>& t) {
  const Vector3<S> ab = t.b - t.a, ac = t.c - t.a;
  return ab.cross(ac);
}

/// The signed distances of the vertices from the plane n·x + offset = 0, times |n|.
template <Ring S>
OfVertices<S> distances(const Vector3<S>& n, const S& offset, const Triangle<S>& t) {
  return {S(n.dot(t.a)) + offset, S(n.dot(t.b)) + offset, S(n.dot(t.c)) + offset};
}
template <Ring S>
bool all_positive(const OfVertices<S>& d) {
  return d[0] > S(0) && d[1] > S(0) && d[2] > S(0);
}
template <Ring S>
bool all_negative(const OfVertices<S>& d) {
  return d[0] < S(0) && d[1] < S(0) && d[2] < S(0);
}
template <Ring S>
bool all_zero(const OfVertices<S>& d) {
  return d[0] == S(0) && d[1] == S(0) && d[2] == S(0);
}
template <Ring S>
bool differ_in_sign(const S& x, const S& y) {
  return (x < S(0) && y > S(0)) || (x > S(0) && y < S(0));
}

/// A triangle without one coordinate.
template <Ring S>
std::array<Vector2<S>, 3> without(int k, const Triangle<S>& t) {
  return {drop_dimension<S>(t.a, k), drop_dimension<S>(t.b, k), drop_dimension<S>(t.c, k)};
}
/// Edge i of three points.
template <Ring S>
Segment2<S> edge(const std::array<Vector2<S>, 3>& t, std::size_t i) {
  return {t[i], t[(i + 1) % 3]};
}
/// Whether p is in the triangle or on its border.
template <Ring S>
bool contains(const std::array<Vector2<S>, 3>& t, const Vector2<S>& p) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const S side = orientation<S>(t[i], t[(i + 1) % 3], p);
    left = left || side > S(0);
    right = right || side < S(0);
  }
  return !(left && right);
}
/// Whether a segment meets an edge of the triangle.
template <Ring S>
bool crosses_edge(const Segment2<S>& s, const std::array<Vector2<S>, 3>& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (meet_rounded<S>(s, edge(t, i)) != Meeting::none) return true;
  }
  return false;
}

/// Whether two triangles of the plane meet: an edge of one meets an edge of the other, or one
/// contains the other.
template <Ring S>
bool flat_meet(const std::array<Vector2<S>, 3>& t, const std::array<Vector2<S>, 3>& u) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (crosses_edge(edge(t, i), u)) return true;
  }
  return contains(u, t[0]) || contains(t, u[0]);
}

}  // namespace pair_methods_detail

/// Whether two triangles meet, by the lecture's steps:
/// 1. the plane of the second triangle: n₂ = (v₁ − v₀) × (v₂ − v₀), offset d₂ = −n₂·v₀;
/// 2. d_i = n₂·u_i + d₂ for the vertices of the first. All positive or all negative: apart. Then
///    the same for the second triangle and the plane of the first;
/// 3. the points p and q in which edges of the first meet the plane of the second;
/// 4. whether an end of the segment pq is in the second triangle, or pq meets an edge of it, in the
///    projection without the coordinate in which |n₂| is largest.
///
/// Touching counts. If all d_i are 0, the first triangle is in the plane of the second, or the
/// second has no area: the steps have no answer, and `coplanar` says so. If the first has no area,
/// it is the segment or the point that it is.
///
/// Limits: every number is rounded, d_i by a few u |n₂||u_i|, and p and q with them, so triangles
/// that touch or nearly touch may be decided wrongly in both directions; far from the origin also
/// others. NaN and overflow: no meaning.
///
/// Source: *Interaction and Normals*, slide "Triangle vs. Triangle".
template <Scalar S>
PairBySteps<S> meet_by_steps(const Triangle<S>& first, const Triangle<S>& second) {
  using namespace pair_methods_detail;
  PairBySteps<S> found;
  // [step-1]
  const Vector3<S> n2 = normal_of(second), n1 = normal_of(first);
  const S d2 = -S(n2.dot(second.a)), d1 = -S(n1.dot(first.a));
  // [/step-1]
  // [step-2]
  const OfVertices<S> d = distances<S>(n2, d2, first);
  found.decided_in = 2;
  if (all_positive(d) || all_negative(d)) return found;
  const OfVertices<S> of_second = distances<S>(n1, d1, second);
  if (all_positive(of_second) || all_negative(of_second)) return found;
  // [/step-2]
  found.coplanar = all_zero(d);
  found.decided_in = found.coplanar ? 0 : 4;
  if (found.coplanar) return found;

  // [step-3]
  const std::array<Vector3<S>, 3> u = vertices(first);
  int count = 0;
  const auto add = [&](const Vector3<S>& point) {
    if (count == 0) found.p = point;
    found.q = point;
    ++count;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (d[i] == S(0)) add(u[i]);
    if (differ_in_sign(d[i], d[j])) add(u[i] + d[i] / (d[i] - d[j]) * (u[j] - u[i]));
  }
  found.crosses_plane = count > 0;
  // [/step-3]
  // [step-4]
  const int k = largest_dimension<S>(n2);
  const std::array<Vector2<S>, 3> flat = without(k, second);
  const Segment2<S> pq{drop_dimension<S>(found.p, k), drop_dimension<S>(found.q, k)};
  found.meet = found.crosses_plane &&
               (contains(flat, pq.a) || contains(flat, pq.b) || crosses_edge(pq, flat));
  // [/step-4]
  return found;
}

namespace pair_methods_detail {

/// Numbers between `low` and `high`.
template <Ring S>
struct Interval {
  S low, high;
};

/// The interval on an axis where a triangle crosses a plane.
/// @param at the vertices on the axis
/// @param d their distances from the plane, not all 0
template <Scalar S>
Interval<S> interval(const OfVertices<S>& at, const OfVertices<S>& d) {
  // The vertex alone on its side: the other two have one sign, or it is the first that is not 0.
  const auto same = [](const S& x, const S& y) { return x * y > S(0); };
  std::size_t alone = 2;
  if (same(d[0], d[1])) {
    alone = 2;
  } else if (same(d[0], d[2])) {
    alone = 1;
  } else if (same(d[1], d[2]) || d[0] != S(0)) {
    alone = 0;
  } else if (d[1] != S(0)) {
    alone = 1;
  }
  const auto end = [&](std::size_t i) {
    return at[alone] + (at[i] - at[alone]) * d[alone] / (d[alone] - d[i]);
  };
  const S one = end((alone + 1) % 3), other = end((alone + 2) % 3);
  return {std::min(one, other), std::max(one, other)};
}

/// Sets what is nearer to 0 than epsilon to 0.
template <Ring S>
OfVertices<S> without_small(OfVertices<S> d, const S& epsilon) {
  for (S& x : d) {
    if (x < epsilon && -x < epsilon) x = S(0);
  }
  return d;
}

}  // namespace pair_methods_detail

// [meet-by-intervals]
/// Whether two triangles meet, by the intervals that they have on the line of both planes.
///
/// The line has the direction n₁ × n₂. Only the order of points on it is needed, so the coordinate
/// in which this direction is largest stands for the distance along it. Triangles in one plane
/// (all distances 0) are projected: an edge of one meets an edge of the other, or one contains the
/// other. Touching counts.
///
/// @param epsilon m³: each d_i nearer to 0 is taken for 0. It is no length, but a length times
/// twice an area: of triangles with an area of 1 m², 10⁻⁶ is half a micrometre; of those with 1 mm²
/// half a metre. Below 0 or NaN: as 0; ∞: all triangles count as coplanar
///
/// Limits: distances and ends of intervals are rounded, so triangles that nearly touch may be
/// decided wrongly in both directions; a product of two d_i can underflow, and then two vertices
/// on one side are not seen as such. With an epsilon, triangles that are apart can be taken for
/// coplanar. A triangle without area counts as coplanar, and one that is apart can be taken for
/// meeting. NaN and overflow: no meaning.
///
/// Source: Möller, A Fast Triangle-Triangle Intersection Test, Journal of Graphics Tools 2 (1997).
template <Scalar S>
bool meet_by_intervals(const Triangle<S>& first, const Triangle<S>& second, S epsilon = S(0)) {
  using namespace pair_methods_detail;
  const Vector3<S> n1 = normal_of(first), n2 = normal_of(second);
  const S d1 = -S(n1.dot(first.a)), d2 = -S(n2.dot(second.a));
  const OfVertices<S> of_first = without_small<S>(distances<S>(n2, d2, first), epsilon);
  if (all_positive(of_first) || all_negative(of_first)) return false;
  const OfVertices<S> of_second = without_small<S>(distances<S>(n1, d1, second), epsilon);
  if (all_positive(of_second) || all_negative(of_second)) return false;
  if (all_zero(of_first) || all_zero(of_second)) {
    const int dropped = largest_dimension<S>(n1);
    return flat_meet(without(dropped, first), without(dropped, second));
  }
  const Vector3<S> line = n1.cross(n2);
  const int k = largest_dimension<S>(line);
  const auto along = [k](const Triangle<S>& t) { return OfVertices<S>{t.a[k], t.b[k], t.c[k]}; };
  const Interval<S> u = interval<S>(along(first), of_first);
  const Interval<S> v = interval<S>(along(second), of_second);
  return u.low <= v.high && v.low <= u.high;
}
// [/meet-by-intervals]

// [meet-by-edges]
/// Whether two triangles meet: whether one of the six edges meets the other triangle, by
/// `intersect_moller_trumbore`.
///
/// Right in exact arithmetic for triangles with area that are not in one plane: an end of their
/// common segment is on an edge. In one plane no edge has a single meeting point: false, also where
/// they overlap. A triangle without area is met by no edge.
///
/// Limits: rounded; two triangles that touch may be decided wrongly. An edge or a triangle with a
/// NaN meets nothing, but other edges of the same pair may. ∞ and overflow: no meaning.
template <Scalar S>
bool meet_by_edges(const Triangle<S>& first, const Triangle<S>& second) {
  const auto an_edge_meets = [](const Triangle<S>& t, const Triangle<S>& face) {
    return intersect_moller_trumbore(Segment<S>{t.a, t.b}, face).has_value() ||
           intersect_moller_trumbore(Segment<S>{t.b, t.c}, face).has_value() ||
           intersect_moller_trumbore(Segment<S>{t.c, t.a}, face).has_value();
  };
  return an_edge_meets(first, second) || an_edge_meets(second, first);
}
// [/meet-by-edges]

// [meet-by-axes]
/// Whether two triangles meet: whether none of 17 axes separates their projections. These are the
/// two normals, the nine cross products of an edge of each, and for triangles in one plane the six
/// perpendiculars to an edge in the plane, which are tested always, because a rounded test for one
/// plane would be wrong for most of them.
///
/// Two triangles with area are apart if and only if the projections on one of these axes are.
/// Touching counts.
///
/// Limits: rounded; triangles that touch may be decided wrongly in both directions. With a triangle
/// without area some axes are zero and separate nothing: those that are apart can be taken for
/// meeting. NaN and overflow: no meaning.
///
/// Source: Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996 (for boxes); Eberly, *3D Game Engine
/// Design*, for triangles.
template <Scalar S>
bool meet_by_axes(const Triangle<S>& first, const Triangle<S>& second) {
  using namespace pair_methods_detail;
  const auto separates = [&](const Vector3<S>& axis) {
    const auto [u_low, u_high] =
        std::minmax({S(axis.dot(first.a)), S(axis.dot(first.b)), S(axis.dot(first.c))});
    const auto [v_low, v_high] =
        std::minmax({S(axis.dot(second.a)), S(axis.dot(second.b)), S(axis.dot(second.c))});
    return u_high < v_low || v_high < u_low;
  };
  const auto edges = [](const Triangle<S>& t) {
    return std::array<Vector3<S>, 3>{t.b - t.a, t.c - t.b, t.a - t.c};
  };
  const Vector3<S> n1 = normal_of(first), n2 = normal_of(second);
  if (separates(n1) || separates(n2)) return false;
  const std::array<Vector3<S>, 3> of_first = edges(first), of_second = edges(second);
  for (const Vector3<S>& e : of_first) {
    for (const Vector3<S>& f : of_second) {
      if (separates(e.cross(f))) return false;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (separates(n1.cross(of_first[i])) || separates(n2.cross(of_second[i]))) return false;
  }
  return true;
}
// [/meet-by-axes]

}  // namespace contact
