/// @file
/// Triangulation of polygons with holes by ear clipping, decided without rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/orientation.hpp>
#include <contact/point_in_polygon.hpp>
#include <contact/polygon.hpp>
#include <contact/polygon_in_space.hpp>
#include <contact/segments.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contact {

namespace triangulate_detail {

/// A vertex of the rings: which ring (0 is the outer one, 1 + i hole i) and which vertex of it.
struct RingVertex {
  std::size_t ring = 0;
  std::size_t vertex = 0;
};

/// Its name in a message: "outer[3]" or "holes[0][3]".
inline std::string name_of(const RingVertex& v) {
  const std::string ring = v.ring == 0 ? "outer" : "holes[" + std::to_string(v.ring - 1) + "]";
  return ring + "[" + std::to_string(v.vertex) + "]";
}

using Rings = std::vector<Polygon<double>>;

/// Throws unless the rings bound a region: see `triangulate`.
class RingCheck {
 public:
  explicit RingCheck(const Rings& rings) : rings_(rings) {}

  void run() const {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const std::size_t n = rings_[r].size();
      if (n < 3) {
        throw_invalid_argument(r == 0 ? "outer" : "holes[" + std::to_string(r - 1) + "]",
                               std::to_string(n) + " vertices", "must have at least 3");
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (!all_finite(rings_[r][i])) refuse({r, i}, "every coordinate must be finite");
        if (rings_[r][i] == rings_[r][(i + 1) % n]) {
          refuse({r, (i + 1) % n}, "must differ from the vertex before it");
        }
      }
    }
    check_edges();
    // The rings do not meet, so one vertex of each says where all of it is.
    for (std::size_t r = 1; r < rings_.size(); ++r) {
      if (where(rings_[0], rings_[r][0]) != Where::inside) {
        refuse({r, 0}, "must be inside of the outer polygon");
      }
      for (std::size_t other = 1; other < rings_.size(); ++other) {
        if (other != r && where(rings_[other], rings_[r][0]) == Where::inside) {
          refuse({r, 0}, "must not be inside of holes[" + std::to_string(other - 1) + "]");
        }
      }
    }
  }

 private:
  const Rings& rings_;

  const Vector2<double>& at(const RingVertex& v) const {
    const Polygon<double>& ring = rings_[v.ring];
    return ring[v.vertex % ring.size()];
  }
  Segment2<double> edge(const RingVertex& start) const {
    return {at(start), at({start.ring, start.vertex + 1})};
  }
  [[noreturn]] void refuse(const RingVertex& v, const std::string& reason) const {
    throw_invalid_argument(name_of(v), vector_text(at(v)), reason);
  }

  /// Edges that follow each other have one common point, all others none. Sorted by their least x,
  /// an edge is compared with those that start before it ends.
  void check_edges() const {
    std::vector<RingVertex> edges;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (std::size_t i = 0; i < rings_[r].size(); ++i) edges.push_back({r, i});
    }
    const auto low = [this](const RingVertex& v) {
      const Segment2<double> e = edge(v);
      return std::min(e.a.x(), e.b.x());
    };
    std::stable_sort(edges.begin(), edges.end(),
                     [&low](const RingVertex& v, const RingVertex& w) { return low(v) < low(w); });
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Segment2<double> first = edge(edges[i]);
      const double high = std::max(first.a.x(), first.b.x());
      for (std::size_t j = i + 1; j < edges.size() && low(edges[j]) <= high; ++j) {
        const Meeting meeting = meet(first, edge(edges[j]));
        if (meeting == Meeting::none) continue;
        if (meeting == Meeting::touching && follow(edges[i], edges[j])) continue;
        refuse(edges[i], std::string("the edge from here ") +
                             (meeting == Meeting::crossing ? "crosses" : "touches") +
                             " the edge from " + name_of(edges[j]));
      }
    }
  }
  bool follow(const RingVertex& v, const RingVertex& w) const {
    if (v.ring != w.ring) return false;
    const std::size_t n = rings_[v.ring].size();
    return (v.vertex + 1) % n == w.vertex || (w.vertex + 1) % n == v.vertex;
  }
};

/// The boundary as one closed chain, counter-clockwise, and the two steps of the method.
class EarClipper {
 public:
  /// The rings must have passed the check.
  explicit EarClipper(const Rings& rings) {
    std::vector<int> rightmost;  // a node of each hole
    int first = 0;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const int n = static_cast<int>(rings[r].size());
      const bool forward = (area_sign(rings[r]) > 0) == (r == 0);
      for (int i = 0; i < n; ++i) {
        const int before = first + (i + n - 1) % n, after = first + (i + 1) % n;
        nodes_.push_back({rings[r][static_cast<std::size_t>(i)], first + i,
                          forward ? before : after, forward ? after : before, false, false});
      }
      if (r > 0) {
        int right = first;
        for (int i = first; i < first + n; ++i) {
          if (further_right(i, right)) right = i;
        }
        rightmost.push_back(right);
      }
      first += n;
    }
    remaining_ = static_cast<int>(rings[0].size());
    std::stable_sort(rightmost.begin(), rightmost.end(),
                     [this](int i, int j) { return further_right(i, j); });
    for (const int hole : rightmost) join(hole);
  }

  std::vector<std::array<int, 3>> clip() {
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(static_cast<std::size_t>(remaining_));
    // [ear-clipping]
    int i = 0;
    for (int k = 0; k < remaining_; ++k, i = node(i).next) {
      node(i).convex = turn(node(i).before, i, node(i).next) > 0;
    }
    for (int k = 0; k < remaining_; ++k, i = node(i).next) node(i).ear = is_ear(i);
    for (int steps = 0; remaining_ > 3 && steps < remaining_;) {
      const int before = node(i).before, next = node(i).next;
      if (!node(i).ear) {
        i = next;
        ++steps;
        continue;
      }
      triangles.push_back({node(before).vertex, node(i).vertex, node(next).vertex});
      node(before).next = next;
      node(next).before = before;
      --remaining_;
      for (const int changed : {before, next}) {
        node(changed).convex = turn(node(changed).before, changed, node(changed).next) > 0;
      }
      for (const int changed : {before, next}) node(changed).ear = is_ear(changed);
      i = node(next).next;  // not the neighbour: a fan of ears has thinner triangles
      steps = 0;
    }
    // [/ear-clipping]
    assert(remaining_ == 3);  // there is always an ear
    triangles.push_back({node(node(i).before).vertex, node(i).vertex, node(node(i).next).vertex});
    return triangles;
  }

 private:
  struct Node {
    Vector2<double> at;
    int vertex;  // index in the result
    int before, next;
    bool convex, ear;
  };
  std::vector<Node> nodes_;
  int remaining_ = 0;  // nodes in the chain, which node 0 is part of until clip() begins

  Node& node(int i) { return nodes_[static_cast<std::size_t>(i)]; }
  const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  int turn(int i, int j, int k) const {
    return polygon_detail::side(node(i).at, node(j).at, node(k).at);
  }
  bool further_right(int i, int j) const {
    const Vector2<double>&p = node(i).at, &q = node(j).at;
    return p.x() != q.x() ? p.x() > q.x() : p.y() > q.y();
  }

  // [is-ear]
  /// Whether the triangle of a node and its neighbours can be cut off: its angle is convex, and no
  /// other vertex is in the triangle or on its border.
  ///
  /// Vertices at the positions of the three are the other copies of a bridge's ends; their edges
  /// are outside, because the angles of the copies do not overlap. Only nodes that are not convex
  /// are tested: of the vertices in the triangle, the one furthest from the line from `before` to
  /// `next` has free space of half a turn or more on its far side, so one of its copies is not
  /// convex.
  bool is_ear(int i) const {
    if (!node(i).convex) return false;
    const Vector2<double>&a = node(node(i).before).at, &b = node(i).at, &c = node(node(i).next).at;
    const double low_x = std::min({a.x(), b.x(), c.x()}), high_x = std::max({a.x(), b.x(), c.x()});
    const double low_y = std::min({a.y(), b.y(), c.y()}), high_y = std::max({a.y(), b.y(), c.y()});
    for (int j = node(node(i).next).next; j != node(i).before; j = node(j).next) {
      const Vector2<double>& p = node(j).at;
      if (node(j).convex || p.x() < low_x || p.x() > high_x || p.y() < low_y || p.y() > high_y) {
        continue;
      }
      if (p == a || p == b || p == c) continue;
      using polygon_detail::side;
      if (side(c, a, p) >= 0 && side(a, b, p) >= 0 && side(b, c, p) >= 0) return false;
    }
    return true;
  }
  // [/is-ear]

  // [bridge]
  /// Joins a hole to the chain by a bridge, an edge that is passed in both directions, from the
  /// hole's rightmost vertex m (of several the highest).
  ///
  /// The ray from m to larger x first crosses some edge of the chain. If that edge's end e is to
  /// the right of m, the triangle of m, the crossing and e is free of edges, apart from those that
  /// start at a vertex in it. Of these vertices and e the one with the smallest angle to the ray,
  /// the nearest of several, sees m. Holes are joined from right to left, so that no hole that is
  /// not yet part of the chain reaches into the triangle.
  void join(int m) {
    const Vector2<double> from = node(m).at;
    std::optional<Segment2<double>> first;  // upwards
    int i = 0;
    for (int k = 0; k < remaining_; ++k, i = node(i).next) {
      const Vector2<double>&a = node(i).at, &b = node(node(i).next).at;
      if ((a.y() > from.y()) == (b.y() > from.y())) continue;
      const Segment2<double> up =
          a.y() > from.y() ? Segment2<double>{b, a} : Segment2<double>{a, b};
      if (polygon_detail::side(up.a, up.b, from) > 0 && (!first || is_left_of(up, *first)))
        first = up;
    }
    assert(first);
    const bool above = first->b.x() > from.x();
    const Vector2<double> end = above ? first->b : first->a;
    const int left = above ? 1 : -1;  // seen from m, the side of e on which the ray is not
    int best = -1;
    for (int k = 0; k < remaining_; ++k, i = node(i).next) {
      const Vector2<double>& p = node(i).at;
      if (p.x() <= from.x() || (above ? p.y() < from.y() : p.y() > from.y())) continue;
      using polygon_detail::side;
      if (side(from, end, p) * left > 0 || side(first->a, first->b, p) < 0) continue;
      const int angle = best < 0 ? -left : side(from, node(best).at, p);
      if (angle * left < 0 || (angle == 0 && p.x() < node(best).at.x())) best = i;
    }
    assert(best >= 0);
    splice(m, copy_facing(best, from));
  }
  // [/bridge]

  /// Whether s crosses a level, that both cross, to the left of t. They lead upwards and do not
  /// cross each other.
  static bool is_left_of(const Segment2<double>& s, const Segment2<double>& t) {
    using polygon_detail::side;
    const int low = s.a.y() >= t.a.y() ? side(t.a, t.b, s.a) : -side(s.a, s.b, t.a);
    if (low != 0) return low > 0;
    return (s.b.y() <= t.b.y() ? side(t.a, t.b, s.b) : -side(s.a, s.b, t.b)) > 0;
  }

  /// Of the nodes at the position of i, the one in whose angle p is.
  int copy_facing(int i, const Vector2<double>& p) const {
    int j = i;
    do {
      if (node(j).at == node(i).at) {
        const Vector2<double>&a = node(node(j).before).at, &b = node(node(j).next).at;
        const bool left_of_first = polygon_detail::side(a, node(j).at, p) > 0;
        const bool left_of_second = polygon_detail::side(node(j).at, b, p) > 0;
        const bool convex = polygon_detail::side(a, node(j).at, b) > 0;
        if (convex ? left_of_first && left_of_second : left_of_first || left_of_second) return j;
      }
      j = node(j).next;
    } while (j != i);
    assert(false);
    return i;
  }

  /// The chain passes from `at` to m, around the hole, and back from m to `at`: two new nodes.
  void splice(int m, int at) {
    int count = 1;
    for (int j = node(m).next; j != m; j = node(j).next) ++count;
    const int m2 = static_cast<int>(nodes_.size()), at2 = m2 + 1;
    nodes_.push_back({node(m).at, node(m).vertex, node(m).before, at2, false, false});
    nodes_.push_back({node(at).at, node(at).vertex, m2, node(at).next, false, false});
    node(node(m2).before).next = m2;
    node(node(at2).next).before = at2;
    node(at).next = m;
    node(m).before = at;
    remaining_ += count + 2;
  }
};

/// The rings in double.
template <std::floating_point S>
Rings rings_of(const PolygonWithHoles<S>& polygon) {
  Rings rings;
  const auto add = [&rings](const Polygon<S>& ring) {
    rings.emplace_back();
    for (const Vector2<S>& v : ring) rings.back().push_back(polygon_detail::in_double(v));
  };
  add(polygon.outer);
  for (const Polygon<S>& hole : polygon.holes) add(hole);
  return rings;
}

}  // namespace triangulate_detail

// [triangulate]
/// Triangles that cover a polygon with holes, by ear clipping: triples of indices of its vertices,
/// those of the outer polygon first, then those of the holes in order.
///
/// With n vertices in all and h holes there are n + 2h − 2 triangles. Each is counter-clockwise,
/// whatever the orientation of the rings, and none has area 0: there is always such a
/// triangulation, also with vertices on straight edges, which become vertices of triangles too. The
/// triangles do not overlap, so their areas' sum is the polygon's, exactly. All decisions are exact
/// signs of orientations of the given vertices, so this is right for every finite input. The
/// triangles may be thin: nothing is optimised.
///
/// First the holes are joined to the outer polygon by bridges; then ears, triangles of three
/// successive vertices that contain no other, are cut off until one triangle is left. Time O(n²) in
/// the worst case, with the check of the rings, which looks at pairs of edges that overlap in x.
///
/// @param polygon m, either orientation
/// @throws std::invalid_argument if a ring has fewer than 3 vertices, a coordinate is not finite, a
/// vertex equals the one before it, edges cross or touch each other (also of one ring: a vertex
/// that is passed twice, a spike), a hole is outside of the outer polygon or in another hole
///
/// Source: Meisters, Polygons Have Ears, 1975; Eberly, Triangulation by Ear Clipping, 2002, for
/// bridges and for the update of the ears.
template <std::floating_point S>
std::vector<std::array<int, 3>> triangulate(const PolygonWithHoles<S>& polygon) {
  using namespace triangulate_detail;
  const Rings rings = rings_of(polygon);
  RingCheck(rings).run();
  return EarClipper(rings).clip();
}

/// The same for a polygon without holes: n − 2 triangles.
template <std::floating_point S>
std::vector<std::array<int, 3>> triangulate(const Polygon<S>& polygon) {
  return triangulate(PolygonWithHoles<S>{polygon, {}});
}
// [/triangulate]

// [triangulate-in-space]
/// The same for a polygon in a plane of space: the outer ring first, then its holes. The triangles
/// have the orientation of the outer ring, so their front is the polygon's front.
///
/// The coordinate in which the outer ring's area vector is largest, exactly, is dropped. Vertices
/// need not be in one plane to the last bit: what counts is the projection, whose rings must bound
/// a region.
/// @param rings m
/// @throws std::invalid_argument as `triangulate`, and if there is no ring or the outer one has no
/// area
template <std::floating_point S>
std::vector<std::array<int, 3>> triangulate_in_space(const std::vector<SpacePolygon<S>>& rings) {
  if (rings.empty()) throw_invalid_argument("rings", "0 rings", "must have an outer ring");
  SpacePolygon<Exact> exact;
  for (const Vector3<S>& v : rings[0]) {
    require_finite("outer", v);
    exact.push_back({Exact(static_cast<double>(v.x())), Exact(static_cast<double>(v.y())),
                     Exact(static_cast<double>(v.z()))});
  }
  const Vector3<Exact> area = doubled_area_vector<Exact>(exact);
  const int k = largest_dimension<Exact>(area);
  if (area[k].sign() == 0) {
    throw_invalid_argument("outer", std::to_string(exact.size()) + " vertices", "has no area");
  }
  PolygonWithHoles<S> flat;
  flat.outer = drop_dimension<S>(rings[0], k);
  for (std::size_t r = 1; r < rings.size(); ++r) {
    for (const Vector3<S>& v : rings[r]) require_finite("holes", v);
    flat.holes.push_back(drop_dimension<S>(rings[r], k));
  }
  std::vector<std::array<int, 3>> triangles = triangulate(flat);
  if (area[k].sign() < 0) {
    for (auto& triangle : triangles) std::swap(triangle[1], triangle[2]);
  }
  return triangles;
}
// [/triangulate-in-space]

}  // namespace contact
