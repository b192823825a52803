/// @file
/// Whether two triangles meet, never wrong for finite input: also where they touch, lie in one
/// plane, or have no area.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/exact_ray_triangle.hpp>
#include <contact/pair_decision.hpp>
#include <contact/pair_orientations.hpp>
#include <contact/pair_signs.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>

namespace contact {

namespace triangles_meet_detail {

using pair_decision_detail::Decision;
using pair_decision_detail::Vertices;

/// All six vertices: those of the first triangle, then those of the second.
inline Vertices six_vertices(const Triangle<double>& first, const Triangle<double>& second) {
  return {first.a, first.b, first.c, second.a, second.b, second.c};
}

/// The decision where the filter of `triangles_meet` was in doubt about many signs.
///
/// A vertex in common is a common point, so it needs no sign. Otherwise all signs are computed in
/// integers: small ones if all coordinates are multiples of one unit and not too many of it, larger
/// ones if they span at most 84 bits. If not, each sign has its own filter and exact arithmetic.
/// @param bound of the error of a volume in double
[[gnu::noinline]] inline bool meet_in_doubt(const Triangle<double>& first,
                                            const Triangle<double>& second, double bound) {
  using namespace pair_signs_detail;
  const Vertices vertices = six_vertices(first, second);
  for (const Vector3<double>& v : vertices) {
    if (!all_finite(v)) return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 3; j < 6; ++j) {
      if (vertices[i] == vertices[j]) return true;
    }
  }
  if (const auto whole = Whole::of(vertices)) return Decision(vertices, *whole).meet();
  if (const auto wide = Wide::of(vertices, bound)) return Decision(vertices, *wide).meet();
  return Decision(vertices, Filtered{vertices}).meet();
}

/// Two triangles of which neither is on one side of the plane of the other, or in it. A volume is
/// computed exactly if it is in doubt.
inline bool meet_crossing(const Triangle<double>& t, const Triangle<double>& u,
                          const pair_orientations_detail::Apex& of_t,
                          const pair_orientations_detail::Apex& of_u, double bound) {
  using Vertex = const Vector3<double>*;
  using pair_orientations_detail::Ordered;
  return intervals_overlap(Ordered<Vertex>{&t.a, &t.b, &t.c}, Ordered<Vertex>{&u.a, &u.b, &u.c},
                           of_t, of_u, [bound](Vertex a, Vertex b, Vertex c, Vertex d) {
                             const double volume = signed_volume<double>(*a, *b, *c, *d);
                             if (std::abs(volume) > bound) return volume > 0 ? 1 : -1;
                             return orient_3d_in_doubt(*a, *b, *c, *d);
                           });
}

/// The decision if the height of a vertex above the plane of the other triangle is in doubt. Up to
/// two such heights are computed exactly, one by one. Triangles that are in one plane or have no
/// area have at least three.
/// @param heights of the vertices of t, then of those of u; with a vertex that is NaN, at least
/// three are NaN
[[gnu::noinline]] inline bool meet_touching(const Triangle<double>& t, const Triangle<double>& u,
                                            const std::array<double, 6>& heights, double bound) {
  using namespace pair_orientations_detail;
  const auto certain = [bound](double height) { return std::abs(height) > bound; };
  if (std::count_if(heights.begin(), heights.end(), certain) < 4) {
    return meet_in_doubt(t, u, bound);
  }
  const std::array<const Vector3<double>*, 6> v{&t.a, &t.b, &t.c, &u.a, &u.b, &u.c};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 3; j < 6; ++j) {
      if (*v[i] == *v[j]) return true;
    }
  }
  std::array<int, 6> signs;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t plane = i < 3 ? 3 : 0;
    signs[i] = certain(heights[i])
                   ? (heights[i] > 0 ? 1 : -1)
                   : orient_3d_in_doubt(*v[plane], *v[plane + 1], *v[plane + 2], *v[i]);
  }
  const Sides of_t{signs[0], signs[1], signs[2]}, of_u{signs[3], signs[4], signs[5]};
  if (on_one_side(of_t) || on_one_side(of_u)) return false;
  return meet_crossing(t, u, apex(of_t), apex(of_u), bound);
}

/// The smallest and the largest of three numbers.
struct Range {
  double low, high;
};
inline Range range(double a, double b, double c) {
  return {std::min(std::min(a, b), c), std::max(std::max(a, b), c)};
}

/// The apex of a triangle of which no vertex is on the plane: of numbers that are not 0, and not
/// all of one sign.
inline pair_orientations_detail::Apex certain_apex(double a, double b, double c) {
  using pair_orientations_detail::Apex;
  static constexpr std::array<Apex, 8> table{Apex{0, true}, {0, true},  {1, true},  {2, false},
                                             {2, true},     {1, false}, {0, false}, {0, true}};
  const auto bit = [](double x, int i) { return static_cast<std::size_t>(x > 0) << i; };
  return table[bit(a, 0) | bit(b, 1) | bit(c, 2)];
}

// [filter]
/// The decision in double, with one bound for all signs of a pair, and exact signs where it does
/// not decide.
///
/// The bound: all determinants are of differences of vertices, of which none is larger than the
/// common box, whose sides are x, y and z. Each of the six terms of a determinant has one factor
/// along each axis, so all are at most xyz, and as for `bounded_volume` the error is at most γ₈
/// times their sum: 6·8u xyz. The computed sides and their product are at most 5 roundings smaller:
/// 50u covers 48u (1 + 14u) and the rounding of the product. With sides below 2^300 nothing
/// overflows, and underflow adds at most half of 2^-1074 to each of nine products, of which six are
/// then multiplied by a side: far less than 2^-700. With a vertex that is NaN all
/// heights above its triangle's plane are NaN, so none of their signs is certain.
inline bool meet_filtered(const Triangle<double>& t, const Triangle<double>& u) {
  using namespace pair_orientations_detail;
  const Range tx = range(t.a.x(), t.b.x(), t.c.x()), ux = range(u.a.x(), u.b.x(), u.c.x());
  const Range ty = range(t.a.y(), t.b.y(), t.c.y()), uy = range(u.a.y(), u.b.y(), u.c.y());
  const Range tz = range(t.a.z(), t.b.z(), t.c.z()), uz = range(u.a.z(), u.b.z(), u.c.z());
  const auto apart = [](const Range& r, const Range& s) {
    return (r.high < s.low) | (s.high < r.low);
  };
  const bool along_x = apart(tx, ux), along_y = apart(ty, uy), along_z = apart(tz, uz);
  if (along_x | along_y | along_z) return false;

  const auto side = [](const Range& r, const Range& s) {
    return std::max(r.high, s.high) - std::min(r.low, s.low);
  };
  const double x = side(tx, ux), y = side(ty, uy), z = side(tz, uz);
  if (!(x + y + z < 0x1p300)) {
    return meet_in_doubt(t, u, std::numeric_limits<double>::infinity());
  }
  constexpr double fifty_u = 25 * std::numeric_limits<double>::epsilon();
  const double bound = fifty_u * (x * y * z) + 0x1p-700;

  const auto one_side = [bound](double a, double b, double c) {
    const Range heights = range(a, b, c);
    return (heights.low > bound) | (heights.high < -bound);
  };
  const auto smallest = [](double a, double b, double c) {
    return std::min(std::min(std::abs(a), std::abs(b)), std::abs(c));
  };
  const Vector3<double> nu = normal_of(u);
  const double ta = height(nu, u.a, t.a), tb = height(nu, u.a, t.b), tc = height(nu, u.a, t.c);
  if (one_side(ta, tb, tc)) return false;
  const Vector3<double> nt = normal_of(t);
  const double ua = height(nt, t.a, u.a), ub = height(nt, t.a, u.b), uc = height(nt, t.a, u.c);
  if (one_side(ua, ub, uc)) return false;
  const bool of_t = smallest(ta, tb, tc) > bound, of_u = smallest(ua, ub, uc) > bound;
  if (!of_t || !of_u) return meet_touching(t, u, {ta, tb, tc, ua, ub, uc}, bound);
  return meet_crossing(t, u, certain_apex(ta, tb, tc), certain_apex(ua, ub, uc), bound);
}
// [/filter]

}  // namespace triangles_meet_detail

// [triangles-meet]
/// Whether two triangles have a point in common: the book's choice.
///
/// The answer is right for every finite input: a floating-point filter decides most pairs, and
/// exact arithmetic the rest. Touching counts. A triangle without area is the segment or the point
/// that its vertices span. A coordinate that is not finite: false.
/// @param first m, any scale
/// @param second m, any scale
///
/// Source: Guigue and Devillers, Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates, Journal of Graphics Tools 8 (2003).
template <FloatOrDouble S>
bool triangles_meet(const Triangle<S>& first, const Triangle<S>& second) {
  if constexpr (std::same_as<S, float>) {
    return triangles_meet_detail::meet_filtered(in_double(first), in_double(second));
  } else {
    return triangles_meet_detail::meet_filtered(first, second);
  }
}
// [/triangles-meet]

/// The same decision, every sign in exact arithmetic: slow. It shows what the filter saves.
template <FloatOrDouble S>
bool triangles_meet_unfiltered(const Triangle<S>& first, const Triangle<S>& second) {
  const auto vertices = triangles_meet_detail::six_vertices(in_double(first), in_double(second));
  for (const Vector3<double>& v : vertices) {
    if (!all_finite(v)) return false;
  }
  return pair_decision_detail::Decision(vertices, pair_signs_detail::Exactly{vertices}).meet();
}

}  // namespace contact
