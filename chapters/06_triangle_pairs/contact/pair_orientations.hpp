/// @file
/// Whether two triangles meet, by the signs of volumes and areas alone: the method of Guigue and
/// Devillers, in the rounding of the scalar.
#pragma once

#include <array>
#include <contact/drop_dimension.hpp>
#include <contact/orientation.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace contact {

namespace pair_orientations_detail {

/// −1, 0 or +1; 0 for NaN.
template <Ring S>
int sign_of(const S& x) {
  return x > S(0) ? 1 : (x < S(0) ? -1 : 0);
}

/// The vertices of a triangle in another order.
template <class P>
struct Ordered {
  const P* a;  ///< the first
  const P* b;  ///< the second
  const P* c;  ///< the third
};
/// In the order in which they are stored.
template <Ring S>
Ordered<Vector3<S>> as_stored(const Triangle<S>& t) {
  return {&t.a, &t.b, &t.c};
}

/// On which side of a plane the three vertices of a triangle are: +1 in front, −1 behind, 0 on it.
using Sides = std::array<int, 3>;

/// Whether all three are strictly on one side.
constexpr bool on_one_side(const Sides& s) { return s[0] == s[1] && s[1] == s[2] && s[0] != 0; }
/// Whether all three are on the plane.
constexpr bool on_the_plane(const Sides& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }

/// The vertex of a triangle that crosses a plane or touches it which is alone on its side: the two
/// edges from it reach the plane, at the ends of the interval that the triangle has on it.
struct Apex {
  std::uint8_t index;  ///< of the vertex
  bool front;          ///< whether it is in front of the plane, or on it with the others behind
};
/// Finds it. If all three are on the plane, or on one side, there is none: {0, true}.
constexpr Apex find_apex(const Sides& s) {
  for (std::uint8_t i = 0; i < 3; ++i) {
    const int own = s[i], other = s[(i + 1U) % 3], another = s[(i + 2U) % 3];
    const bool both_behind = other < 0 && another<0, both_in_front = other> 0 && another > 0;
    if ((own > 0 && other <= 0 && another <= 0) || (own == 0 && both_behind)) return {i, true};
    if ((own < 0 && other >= 0 && another >= 0) || (own == 0 && both_in_front)) return {i, false};
  }
  return {0, true};
}
/// The same from a table.
inline Apex apex(const Sides& s) {
  static constexpr auto table = [] {
    std::array<Apex, 27> found{};
    for (int i = 0; i < 27; ++i) {
      found[static_cast<std::size_t>(i)] = find_apex({i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1});
    }
    return found;
  }();
  return table[static_cast<std::size_t>(s[0] + 3 * s[1] + 9 * s[2] + 13)];
}

/// The triangle with the vertex of that index first, in the same orientation.
template <class P>
Ordered<P> starting_at(int index, const Ordered<P>& t) {
  if (index == 0) return t;
  return index == 1 ? Ordered<P>{t.b, t.c, t.a} : Ordered<P>{t.c, t.a, t.b};
}

// [intervals-overlap]
/// Two triangles u and v whose planes meet in a line, each with vertices on both sides of the
/// other's plane or on it: whether their intervals on the line overlap.
///
/// The edges u.a u.b and u.a u.c end u's interval, v.a v.b and v.a v.c that of v, where u.a is in
/// front of v and v.a in front of u. Then u's interval must not begin after that of v ends, nor end
/// before it begins.
/// @param volume the sign of `signed_volume` of four points
template <class P, class Volume>
bool intervals_overlap(const Ordered<P>& u, const Ordered<P>& v, const Volume& volume) {
  return volume(*u.a, *u.b, *v.a, *v.b) <= 0 && volume(*u.a, *u.c, *v.c, *v.a) <= 0;
}
// [/intervals-overlap]

/// The same for vertices in any order.
/// @param of_u, of_v the sides of u's vertices of v's plane, and of v's vertices of u's plane
template <class P, class Volume>
bool intervals_overlap(Ordered<P> u, Ordered<P> v, const Sides& of_u, const Sides& of_v,
                       const Volume& volume) {
  const Apex of_first = apex(of_u), of_second = apex(of_v);
  u = starting_at(of_first.index, u);
  v = starting_at(of_second.index, v);
  if (!of_first.front) std::swap(v.b, v.c);  // turns v, so that u.a is in front of it
  if (!of_second.front) std::swap(u.b, u.c);
  return intervals_overlap(u, v, volume);
}

// [flat]
/// u.a is beyond the edge from v.c to v.a alone: whether u meets v. Both are counter-clockwise.
/// @param area the sign of `orientation` of three points
template <class P, class Area>
bool meet_beyond_edge(const Ordered<P>& u, const Ordered<P>& v, const Area& area) {
  const auto &p = *u.a, &q = *u.b, &r = *u.c, &start = *v.c, &end = *v.a;
  if (area(start, end, q) >= 0) {
    if (area(p, end, q) >= 0) return area(p, q, start) >= 0;
    return area(q, r, end) >= 0 && area(r, p, end) >= 0;
  }
  if (area(start, end, r) < 0 || area(p, end, r) < 0) return false;
  return area(p, r, start) >= 0 || area(q, r, start) >= 0;
}
/// u.a is beyond both edges at v.c.
template <class P, class Area>
bool meet_beyond_vertex(const Ordered<P>& u, const Ordered<P>& v, const Area& area) {
  const auto &p = *u.a, &q = *u.b, &r = *u.c;
  if (area(*v.c, *v.a, q) >= 0) {
    if (area(*v.c, *v.b, q) <= 0) {
      if (area(p, *v.a, q) > 0) return area(p, *v.b, q) <= 0;
      return area(p, *v.a, r) >= 0 && area(q, r, *v.a) >= 0;
    }
    return area(p, *v.b, q) <= 0 && area(*v.c, *v.b, r) <= 0 && area(q, r, *v.b) >= 0;
  }
  if (area(*v.c, *v.a, r) < 0) return false;
  if (area(q, r, *v.c) >= 0) return area(p, *v.a, r) >= 0;
  return area(q, r, *v.b) >= 0 && area(*v.c, r, *v.b) >= 0;
}
/// Whether two counter-clockwise triangles of the plane meet. The edges of v divide the plane into
/// seven regions: the one in which u.a is determines which tests decide.
template <class P, class Area>
bool meet_in_plane(const Ordered<P>& u, const Ordered<P>& v, const Area& area) {
  const bool ab = area(*v.a, *v.b, *u.a) >= 0;
  const bool bc = area(*v.b, *v.c, *u.a) >= 0;
  const bool ca = area(*v.c, *v.a, *u.a) >= 0;
  const Ordered<P> from_b{v.b, v.c, v.a}, from_c{v.c, v.a, v.b};
  if (ab && bc) return ca || meet_beyond_edge(u, v, area);
  if (ab) return ca ? meet_beyond_edge(u, from_c, area) : meet_beyond_vertex(u, v, area);
  if (!bc) return meet_beyond_vertex(u, from_c, area);
  return ca ? meet_beyond_edge(u, from_b, area) : meet_beyond_vertex(u, from_b, area);
}
// [/flat]

/// Three points of the plane.
template <Ring S>
using Flat = std::array<Vector2<S>, 3>;

/// A triangle without coordinate k.
template <Ring S>
Flat<S> flattened(const Triangle<S>& t, int k) {
  return {drop_dimension<S>(t.a, k), drop_dimension<S>(t.b, k), drop_dimension<S>(t.c, k)};
}
/// Its vertices counter-clockwise.
/// @param orientation their orientation, +1 or −1
template <Ring S>
Ordered<Vector2<S>> counter_clockwise(const Flat<S>& t, int orientation) {
  if (orientation < 0) return {&t[0], &t[2], &t[1]};
  return {&t[0], &t[1], &t[2]};
}

/// On which sides of the plane of a triangle the vertices of another are, rounded.
/// @param normal (b − a) × (c − a) of the triangle
template <Ring S>
Sides rounded_sides(const Vector3<S>& normal, const Vector3<S>& on_plane, const Triangle<S>& of) {
  const auto side = [&](const Vector3<S>& v) {
    const Vector3<S> away = v - on_plane;
    return sign_of<S>(away.dot(normal));
  };
  return {side(of.a), side(of.b), side(of.c)};
}

/// Two triangles in one plane, rounded.
template <Ring S>
bool coplanar_meet(const Triangle<S>& first, const Triangle<S>& second, const Vector3<S>& normal) {
  const auto area = [](const Vector2<S>& a, const Vector2<S>& b, const Vector2<S>& c) {
    return sign_of<S>(orientation<S>(a, b, c));
  };
  const int k = largest_dimension<S>(normal);
  const Flat<S> u = flattened<S>(first, k), v = flattened<S>(second, k);
  return meet_in_plane(counter_clockwise<S>(u, area(u[0], u[1], u[2])),
                       counter_clockwise<S>(v, area(v[0], v[1], v[2])), area);
}

}  // namespace pair_orientations_detail

// [meet-by-orientations]
/// Whether two triangles have a point in common, by orientations of their vertices, each as the
/// scalar rounds it: at most six volumes for the planes, and two for the order of the ends of two
/// intervals. Touching counts. No point is computed.
///
/// Triangles in one plane are projected along the largest component of a normal and decided by
/// orientations of three points.
///
/// Limits: a sign that rounds to another one can make the answer wrong, which happens for triangles
/// that touch or nearly touch, in both directions. There is no tolerance. With S = Exact each sign
/// is right, and so is the answer, for triangles that have area; those without are taken for
/// coplanar and may be decided wrongly (`triangles_meet` decides all). NaN and overflow: false or
/// true, without meaning.
///
/// Source: Guigue and Devillers, Fast and Robust Triangle-Triangle Overlap Test Using Orientation
/// Predicates, Journal of Graphics Tools 8 (2003).
template <Ring S>
bool meet_by_orientations(const Triangle<S>& first, const Triangle<S>& second) {
  using namespace pair_orientations_detail;
  const Vector3<S> ab = second.b - second.a, ac = second.c - second.a;
  const Vector3<S> normal = ab.cross(ac);
  const Sides of_first = rounded_sides<S>(normal, second.a, first);
  if (on_one_side(of_first)) return false;

  const Vector3<S> de = first.b - first.a, df = first.c - first.a;
  const Vector3<S> normal_of_first = de.cross(df);
  const Sides of_second = rounded_sides<S>(normal_of_first, first.a, second);
  if (on_one_side(of_second)) return false;

  if (on_the_plane(of_first) || on_the_plane(of_second)) {
    return coplanar_meet<S>(first, second, normal);
  }
  return intervals_overlap(as_stored(first), as_stored(second), of_first, of_second,
                           [](const auto& a, const auto& b, const auto& c, const auto& d) {
                             return sign_of<S>(signed_volume<S>(a, b, c, d));
                           });
}
// [/meet-by-orientations]

}  // namespace contact
