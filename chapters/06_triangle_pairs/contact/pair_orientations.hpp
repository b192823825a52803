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

/// The vertices of a triangle in any order, as what the functors below take: pointers or indices.
template <class V>
struct Ordered {
  V a;  ///< the first
  V b;  ///< the second
  V c;  ///< the third
};

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
  const int row = s[0] + 3 * s[1] + 9 * s[2] + 13;
  return table[static_cast<std::size_t>(row)];
}

/// The triangle with the vertex of that index first, in the same orientation.
template <class V>
Ordered<V> starting_at(int index, const Ordered<V>& t) {
  if (index == 0) return t;
  return index == 1 ? Ordered<V>{t.b, t.c, t.a} : Ordered<V>{t.c, t.a, t.b};
}

// [intervals-overlap]
/// Two triangles u and v whose planes meet in a line, each with vertices on both sides of the
/// other's plane or on it: whether their intervals on the line overlap.
///
/// The edges u.a u.b and u.a u.c end u's interval, v.a v.b and v.a v.c that of v. With u.a in front
/// of v and v.a in front of u, both intervals run in one direction: u's must not begin after the
/// end of v's, nor end before its begin.
/// @param volume the sign of `signed_volume` of four vertices
template <class V, class Volume>
bool intervals_overlap(const Ordered<V>& u, const Ordered<V>& v, const Volume& volume) {
  return volume(u.a, u.b, v.a, v.b) <= 0 && volume(u.a, u.c, v.c, v.a) <= 0;
}
// [/intervals-overlap]

/// The same for vertices in any order.
/// @param of_u the apex of u, seen from v's plane
/// @param of_v the apex of v, seen from u's plane
template <class V, class Volume>
bool intervals_overlap(Ordered<V> u, Ordered<V> v, const Apex& of_u, const Apex& of_v,
                       const Volume& volume) {
  u = starting_at(of_u.index, u);
  v = starting_at(of_v.index, v);
  if (!of_u.front) std::swap(v.b, v.c);  // turns v, so that u.a is in front of it
  if (!of_v.front) std::swap(u.b, u.c);
  return intervals_overlap(u, v, volume);
}

// [flat]
/// u.a is beyond the edge from v.c to v.a alone: whether u meets v. Both are counter-clockwise.
/// @param area the sign of `orientation` of three vertices
template <class V, class Area>
bool meet_beyond_edge(const Ordered<V>& u, const Ordered<V>& v, const Area& area) {
  if (area(v.c, v.a, u.b) >= 0) {
    if (area(u.a, v.a, u.b) >= 0) return area(u.a, u.b, v.c) >= 0;
    return area(u.b, u.c, v.a) >= 0 && area(u.c, u.a, v.a) >= 0;
  }
  if (area(v.c, v.a, u.c) < 0 || area(u.a, v.a, u.c) < 0) return false;
  return area(u.a, u.c, v.c) >= 0 || area(u.b, u.c, v.c) >= 0;
}
/// u.a is beyond both edges at v.c.
template <class V, class Area>
bool meet_beyond_vertex(const Ordered<V>& u, const Ordered<V>& v, const Area& area) {
  if (area(v.c, v.a, u.b) >= 0) {
    if (area(v.c, v.b, u.b) <= 0) {
      if (area(u.a, v.a, u.b) > 0) return area(u.a, v.b, u.b) <= 0;
      return area(u.a, v.a, u.c) >= 0 && area(u.b, u.c, v.a) >= 0;
    }
    return area(u.a, v.b, u.b) <= 0 && area(v.c, v.b, u.c) <= 0 && area(u.b, u.c, v.b) >= 0;
  }
  if (area(v.c, v.a, u.c) < 0) return false;
  if (area(u.b, u.c, v.c) >= 0) return area(u.a, v.a, u.c) >= 0;
  return area(u.b, u.c, v.b) >= 0 && area(v.c, u.c, v.b) >= 0;
}
/// Whether two counter-clockwise triangles of the plane meet. The lines along the edges of v divide
/// the plane into seven regions: the one in which u.a is determines which tests decide.
template <class V, class Area>
bool meet_in_plane(const Ordered<V>& u, const Ordered<V>& v, const Area& area) {
  const bool ab = area(v.a, v.b, u.a) >= 0;
  const bool bc = area(v.b, v.c, u.a) >= 0;
  const bool ca = area(v.c, v.a, u.a) >= 0;
  const Ordered<V> from_b{v.b, v.c, v.a}, from_c{v.c, v.a, v.b};
  if (ab && bc) return ca || meet_beyond_edge(u, v, area);
  if (ab) return ca ? meet_beyond_edge(u, from_c, area) : meet_beyond_vertex(u, v, area);
  if (!bc) return meet_beyond_vertex(u, from_c, area);
  return ca ? meet_beyond_edge(u, from_b, area) : meet_beyond_vertex(u, from_b, area);
}
/// The vertices counter-clockwise.
/// @param orientation theirs: +1 or −1
template <class V>
Ordered<V> counter_clockwise(const Ordered<V>& t, int orientation) {
  return orientation < 0 ? Ordered<V>{t.a, t.c, t.b} : t;
}
// [/flat]

/// The normal (b − a) × (c − a) of a triangle.
template <Ring S>
Vector3<S> normal_of(const Triangle<S>& t) {
  const Vector3<S> ab = t.b - t.a, ac = t.c - t.a;
  return ab.cross(ac);
}
/// n · (v − a): the volume with a plane through a, to which n is normal.
template <Ring S>
S height(const Vector3<S>& n, const Vector3<S>& a, const Vector3<S>& v) {
  const Vector3<S> away = v - a;
  return away.dot(n);
}

/// Two triangles in one plane, rounded.
template <Ring S>
bool coplanar_meet(const Triangle<S>& first, const Triangle<S>& second, const Vector3<S>& normal) {
  const auto area = [](const Vector2<S>* a, const Vector2<S>* b, const Vector2<S>* c) {
    return sign_of<S>(orientation<S>(*a, *b, *c));
  };
  const int k = largest_dimension<S>(normal);
  const auto flat = [k](const Vector3<S>& v) { return drop_dimension<S>(v, k); };
  const std::array<Vector2<S>, 6> points{flat(first.a),  flat(first.b),  flat(first.c),
                                         flat(second.a), flat(second.b), flat(second.c)};
  const Ordered<const Vector2<S>*> u{&points[0], &points[1], &points[2]};
  const Ordered<const Vector2<S>*> v{&points[3], &points[4], &points[5]};
  return meet_in_plane(counter_clockwise(u, area(u.a, u.b, u.c)),
                       counter_clockwise(v, area(v.a, v.b, v.c)), area);
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
  const auto on_one_side = [](const S& a, const S& b, const S& c) {
    return (a > S(0) && b > S(0) && c > S(0)) || (a < S(0) && b < S(0) && c < S(0));
  };
  const Vector3<S> n = normal_of<S>(second);
  const S ua = height<S>(n, second.a, first.a);
  const S ub = height<S>(n, second.a, first.b);
  const S uc = height<S>(n, second.a, first.c);
  if (on_one_side(ua, ub, uc)) return false;
  const Vector3<S> m = normal_of<S>(first);
  const S va = height<S>(m, first.a, second.a);
  const S vb = height<S>(m, first.a, second.b);
  const S vc = height<S>(m, first.a, second.c);
  if (on_one_side(va, vb, vc)) return false;

  const Sides of_first{sign_of<S>(ua), sign_of<S>(ub), sign_of<S>(uc)};
  const Sides of_second{sign_of<S>(va), sign_of<S>(vb), sign_of<S>(vc)};
  if (on_the_plane(of_first) || on_the_plane(of_second)) return coplanar_meet<S>(first, second, n);
  using Vertex = const Vector3<S>*;
  return intervals_overlap(Ordered<Vertex>{&first.a, &first.b, &first.c},
                           Ordered<Vertex>{&second.a, &second.b, &second.c}, apex(of_first),
                           apex(of_second), [](Vertex a, Vertex b, Vertex c, Vertex d) {
                             return sign_of<S>(signed_volume<S>(*a, *b, *c, *d));
                           });
}
// [/meet-by-orientations]

}  // namespace contact
