/// @file
/// A point and any polygon, concave and self-crossing ones included: by the sum of angles, by
/// quadrants, by crossings, by a scanline, and by an exact winding number, which the book uses.
///
/// The lecture's four methods have two answers, inside and outside; only `winding_number` and
/// `where` tell `on` apart for every point.
///
/// Degenerate input, unless a function says otherwise: without vertices, and for a point with a
/// coordinate that is not finite, sums, counts and winding numbers are 0, and the point is outside.
/// Vertices must be finite (`Polygon`). Numbers that overflow can make any answer wrong but those
/// of `winding_number` and `where`.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <contact/polygon.hpp>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

namespace contact {

/// Which regions of a polygon that crosses itself are inside: those around which the boundary winds
/// an odd number of times, or any number of times but zero. For a polygon that does not cross
/// itself both are the same.
enum class Rule { even_odd, non_zero };

// [angle-sum]
/// The sum of the signed angles at p from each vertex to the next, rad: 2π times the winding number
/// if p is not on the boundary.
///
/// Limits: rounded; about n u π. On the boundary, an edge through p contributes +π or −π by chance,
/// and a vertex at p two angles of a zero vector. One arc tangent for each edge makes it the
/// slowest method. The last bits may differ from machine to machine, with `std::atan2`. A point
/// that is not finite gives NaN, or 0. Products that underflow can give a wrong sum.
///
/// Source: *Interaction and Normals*, slide "Ray Basics".
template <std::floating_point S>
S angle_sum(const Polygon<S>& polygon, const Vector2<S>& p) {
  S sum = S(0);
  for_each_edge(polygon, [&](const Vector2<S>& a, const Vector2<S>& b) {
    const Vector2<S> to_a = a - p, to_b = b - p;
    sum += std::atan2(cross2<S>(to_a, to_b), to_a.dot(to_b));
  });
  return sum;
}

/// Inside if the angles' sum is closer to ±2π (or a multiple) than to 0: the non-zero rule.
///
/// Two answers: on the boundary it is inside or outside, by chance. A sum that is NaN gives
/// outside.
template <std::floating_point S>
Where where_by_angle_sum(const Polygon<S>& polygon, const Vector2<S>& p) {
  return std::abs(angle_sum(polygon, p)) > std::numbers::pi_v<S> ? Where::inside : Where::outside;
}
// [/angle-sum]

// [quadrants]
/// The sum of the changes of quadrant from each vertex to the next, as seen from p: 4 times the
/// winding number if p is not on the boundary.
///
/// An edge to the opposite quadrant changes by +2 or −2. The side on which it passes p decides
/// which, and only this decision rounds. A cross product that is NaN or underflows to 0 gives −2:
/// so a point whose x is NaN can have a sum that is not 0.
///
/// Source: *Interaction and Normals*, slide "Ray Basics".
template <Ring S>
int quadrant_sum(const Polygon<S>& polygon, const Vector2<S>& p) {
  const auto quadrant = [&p](const Vector2<S>& v) {
    if (v.y() >= p.y()) return v.x() >= p.x() ? 0 : 1;
    return v.x() < p.x() ? 2 : 3;
  };
  int sum = 0;
  for_each_edge(polygon, [&](const Vector2<S>& a, const Vector2<S>& b) {
    const int change = (quadrant(b) - quadrant(a) + 4) % 4;
    if (change == 1) sum += 1;
    if (change == 3) sum -= 1;
    if (change == 2) sum += cross2<S>(a - p, b - p) > S(0) ? 2 : -2;
  });
  return sum;
}

/// Inside if the sum of the changes of quadrant is not 0: the non-zero rule. Two answers.
///
/// Limits: rounded, an edge that passes close to p may be seen on the wrong side. On the boundary
/// it is inside or outside, depending on the edge. With S = Exact it is right off the boundary. A
/// point whose x is NaN can be inside; an infinite one is outside.
template <Ring S>
Where where_by_quadrants(const Polygon<S>& polygon, const Vector2<S>& p) {
  return quadrant_sum(polygon, p) != 0 ? Where::inside : Where::outside;
}
// [/quadrants]

// [crossings-closed]
/// The number of edges that meet the ray from p to larger x if each edge includes both its ends:
/// the first idea. A vertex at the level of p belongs to two edges, and so is counted twice. For
/// p.x = −∞ all edges that reach the level count, and their number can be odd.
template <Scalar S>
int crossings_with_ends(const Polygon<S>& polygon, const Vector2<S>& p) {
  int count = 0;
  for_each_edge(polygon, [&](const Vector2<S>& a, const Vector2<S>& b) {
    if (a.y() == b.y() || p.y() < std::min(a.y(), b.y()) || p.y() > std::max(a.y(), b.y())) return;
    const S x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > p.x()) ++count;
  });
  return count;
}

/// Inside if that number is odd. Wrong at the level of many vertices, where even a point with
/// x = −∞ can be inside.
template <Scalar S>
Where where_by_crossings_with_ends(const Polygon<S>& polygon, const Vector2<S>& p) {
  return crossings_with_ends(polygon, p) % 2 != 0 ? Where::inside : Where::outside;
}
// [/crossings-closed]

// [crossings]
/// The number of edges that the ray from p to larger x crosses. An edge has its lower end and not
/// its upper end, so a vertex at the level of p counts once where the boundary passes through the
/// level, and twice or not at all where it turns back.
///
/// Limits: rounded, the crossing point may be on the wrong side of p. Level edges are never
/// counted. For p.x = −∞ all edges that cross the level count, an even number.
template <Scalar S>
int crossings(const Polygon<S>& polygon, const Vector2<S>& p) {
  int count = 0;
  for_each_edge(polygon, [&](const Vector2<S>& a, const Vector2<S>& b) {
    if ((a.y() > p.y()) == (b.y() > p.y())) return;
    const S x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (p.x() < x) ++count;
  });
  return count;
}
// [/crossings]

/// Inside if the number of crossings is odd: the even-odd rule. Two answers.
///
/// Limits: close to the boundary rounding decides. On the boundary, points of a left or lower edge
/// tend to be inside and those of a right or upper edge outside. A point that is not finite is
/// outside.
///
/// Source: the method of many programs, after W. R. Franklin's PNPOLY, 1970.
template <Scalar S>
Where where_by_crossings(const Polygon<S>& polygon, const Vector2<S>& p) {
  return crossings(polygon, p) % 2 != 0 ? Where::inside : Where::outside;
}

// [scanline]
/// Where a horizontal line crosses an edge of a polygon.
template <Scalar S>
struct ScanlineCrossing {
  S x = S(0);    ///< m
  int step = 0;  ///< +1 if the edge goes up, −1 if it goes down
};

/// The crossings of a polygon with the horizontal line at y, from left to right. An edge has its
/// lower end and not its upper end; level edges are left out. No vertices, or a y that is not
/// finite, give none. An edge whose crossing point is NaN, by overflow, is left out.
template <Scalar S>
std::vector<ScanlineCrossing<S>> scanline(const Polygon<S>& polygon, const S& y) {
  std::vector<ScanlineCrossing<S>> found;
  for_each_edge(polygon, [&](const Vector2<S>& a, const Vector2<S>& b) {
    if ((a.y() > y) == (b.y() > y)) return;
    const S x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (!(x <= S(0) || x >= S(0))) return;  // NaN, which cannot be sorted
    found.push_back({x, b.y() > y ? 1 : -1});
  });
  std::sort(found.begin(), found.end(), [](const auto& f, const auto& g) { return f.x < g.x; });
  return found;
}

/// Inside if the steps to the right of p have a sum that is not 0 (non_zero) or is odd (even_odd).
/// The sum is the winding number: an edge that goes up has p on its left.
///
/// The scanline can be computed once for all points of one row. Two answers. Without crossings, and
/// for an x that is NaN or +∞, outside; for −∞ all steps are to the right, and those of a polygon
/// have the sum 0.
///
/// Limits: as `crossings`.
///
/// Source: *Interaction and Normals*, slide "Ray Basics": scanline +/−.
template <Scalar S>
Where where_on_scanline(const std::vector<ScanlineCrossing<S>>& crossings, const S& x,
                        Rule rule = Rule::non_zero) {
  int sum = 0;
  for (const ScanlineCrossing<S>& c : crossings) {
    if (x < c.x) sum += c.step;
  }
  const bool inside = rule == Rule::non_zero ? sum != 0 : sum % 2 != 0;
  return inside ? Where::inside : Where::outside;
}

/// The same for one point. A point that is not finite is outside.
template <Scalar S>
Where where_by_scanline(const Polygon<S>& polygon, const Vector2<S>& p,
                        Rule rule = Rule::non_zero) {
  return where_on_scanline<S>(scanline<S>(polygon, p.y()), p.x(), rule);
}
// [/scanline]

// [winding-by-edges]
/// How often the polygon winds around p, edge by edge; nothing if p is on an edge or a vertex.
///
/// Limits: exact for S = Exact and for rationals. In floating point the rounded orientation puts a
/// point near an edge on either side or on it. `winding_number` decides the same without error.
template <Ring S>
std::optional<int> winding_by_edges(const Polygon<S>& polygon, const Vector2<S>& p) {
  int winding = 0;
  bool on = false;
  for_each_edge(polygon, [&](const Vector2<S>& a, const Vector2<S>& b) {
    const S side = orientation<S>(a, b, p);
    if (side == S(0) && polygon_detail::in_box(a, b, p)) on = true;
    const bool up = b.y() > p.y();
    if ((a.y() > p.y()) == up) return;
    if (up ? side > S(0) : side < S(0)) winding += up ? 1 : -1;
  });
  return on ? std::nullopt : std::optional<int>(winding);
}
// [/winding-by-edges]

namespace polygon_detail {

/// How up to 64 edges lie to a level, one bit each; bit k is the edge that ends in the vertex k
/// before the last.
struct EdgesAtLevel {
  std::uint64_t crossing = 0;  ///< whether the start is above and the end not, or the reverse
  std::uint64_t ending = 0;    ///< whether the end is at the level
};

// [edges-at-level]
/// Compares the edges from `before` over the vertices with the level y.
///
/// Which edges cross a level is hard to predict, and a wrong prediction costs more time than
/// several edges without one. So nothing branches on a comparison, and the next loop gets bits.
/// Four vertices at a time save an eighth of the time. They are read in the order of memory:
/// backwards, with the first edge in the lowest bit, polygons outside of the cache take twice as
/// long.
template <std::floating_point S>
EdgesAtLevel edges_at_level(const Vector2<S>& before, const Vector2<S>* vertices, int count, S y) {
  std::uint64_t above = 0, not_below = 0;
  const auto compare = [&](const Vector2<S>& v) {
    above = 2 * above + std::uint64_t{v.y() > y};
    not_below = 2 * not_below + std::uint64_t{v.y() >= y};
  };
  const Vector2<S>*v = vertices, *end = vertices + count;
  for (; end - v >= 4; v += 4) {
    compare(v[0]);
    compare(v[1]);
    compare(v[2]);
    compare(v[3]);
  }
  for (; v != end; ++v) compare(*v);
  const std::uint64_t start_above = (above >> 1) | (std::uint64_t{before.y() > y} << (count - 1));
  return {above ^ start_above, above ^ not_below};
}
// [/edges-at-level]

/// Whether p is at b, or on the edge from a to b along its level. b is at the level of p.
template <std::floating_point S>
bool touches_at_level(const Vector2<S>& a, const Vector2<S>& b, const Vector2<S>& p) {
  return b.x() == p.x() || (a.y() == b.y() && (a.x() < p.x()) != (b.x() < p.x()));
}

}  // namespace polygon_detail

/// How often the polygon winds around p, counter-clockwise; nothing if p is on an edge or a vertex.
///
/// Right for every finite input. A polygon without edges, or a point that is not finite: 0.
///
/// An edge that crosses the level of p upwards with p on its left counts +1, one that crosses it
/// downwards with p on its right −1; again an edge has its lower end and not its upper end. For
/// most edges comparing y is enough, 64 at a time (`edges_at_level`). For those that cross the
/// level the sign of the orientation decides: by a filter, with `side_in_doubt` behind it. If it is
/// 0, p is on the edge. Edges that do not cross the level can still touch it, at their upper end or
/// along it.
///
/// Source: Sunday, Inclusion of a Point in a Polygon, 2001, for the winding number by crossings.
template <std::floating_point S>
std::optional<int> winding_number(const Polygon<S>& polygon, const Vector2<S>& p) {
  using namespace polygon_detail;
  if (polygon.empty()) return 0;
  const Vector2<double> to = in_double(p);
  // [winding-number]
  int winding = 0;
  const Vector2<S>* before = &polygon.back();
  for (std::size_t first = 0; first < polygon.size(); first += 64) {
    const Vector2<S>* v = &polygon[first];
    const int count = static_cast<int>(std::min(polygon.size() - first, std::size_t{64}));
    const EdgesAtLevel edges = edges_at_level(*before, v, count, p.y());
    for (std::uint64_t left = edges.ending; left != 0; left &= left - 1) {
      const int k = count - 1 - std::countr_zero(left);
      if (touches_at_level(k == 0 ? *before : v[k - 1], v[k], p)) return std::nullopt;
    }
    for (std::uint64_t left = edges.crossing; left != 0; left &= left - 1) {
      const int k = count - 1 - std::countr_zero(left);
      const Vector2<S>&a = k == 0 ? *before : v[k - 1], &b = v[k];
      auto [side, bound] = bounded_orientation(in_double(a), in_double(b), to);
      if (!(std::abs(side) > bound)) {
        if (!all_finite(p)) return 0;
        side = side_in_doubt(in_double(a), in_double(b), to);
        if (side == 0) return std::nullopt;
      }
      // +1: up, and p on the left. −1: down, and p on the right. Otherwise 0.
      winding += int{side > 0} + int{b.y() > p.y()} - 1;
    }
    before = v + count - 1;
  }
  return winding;
  // [/winding-number]
}

// [where]
/// Where p is: the book's choice. On means on an edge or a vertex, also if both sides of that edge
/// are inside.
///
/// Right for every finite input. On random points it takes no more time than the plain crossing
/// test. A point that is not finite is outside; so is every point if there are no vertices. A
/// polygon without area has no inside: the point is on it or outside.
template <std::floating_point S>
Where where(const Polygon<S>& polygon, const Vector2<S>& p, Rule rule = Rule::even_odd) {
  const std::optional<int> winding = winding_number(polygon, p);
  if (!winding) return Where::on;
  const bool inside = rule == Rule::non_zero ? *winding != 0 : *winding % 2 != 0;
  return inside ? Where::inside : Where::outside;
}

/// The same for a polygon with holes: on if p is on the boundary of the outer polygon or of a hole
/// in it, inside if it is inside of the outer polygon and of no hole. A point outside of the outer
/// polygon is outside, whatever the holes are. A hole without area takes only its own points away:
/// they are on.
template <std::floating_point S>
Where where(const PolygonWithHoles<S>& polygon, const Vector2<S>& p, Rule rule = Rule::even_odd) {
  const Where outer = where(polygon.outer, p, rule);
  if (outer != Where::inside) return outer;
  Where answer = Where::inside;
  for (const Polygon<S>& hole : polygon.holes) {
    const Where in_hole = where(hole, p, rule);
    if (in_hole == Where::on) return Where::on;
    if (in_hole == Where::inside) answer = Where::outside;
  }
  return answer;
}
// [/where]

}  // namespace contact
