/// @file
/// Which features of two triangles have isolated common points: the combinatorial part of
/// `contact/triangle_intersection.hpp`, by orientation predicates alone.
///
/// What two triangles have in common is convex, and its vertices are what has to be found. Let x be
/// one of its points, and f and g the smallest features of the two triangles that contain x. Then
/// the smallest face of the common set that contains x is f ∩ g. So x is a vertex of the set if f
/// and g, extended to planes or lines, meet in x alone: vertex and anything, two edges that are not
/// parallel, or an edge and a face that it crosses. Hence two different vertices have different
/// pairs of features, and nothing has to be computed to tell them apart.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <contact/drop_dimension.hpp>
#include <contact/exact.hpp>
#include <contact/orientation.hpp>
#include <contact/polygon.hpp>
#include <contact/triangle_features.hpp>
#include <contact/vector.hpp>
#include <cstddef>

namespace contact::feature_pairs_detail {

/// A triangle as a set of points: with area its three vertices, without it the ends of a segment,
/// or one point. A segment has edge 0, from vertex 0 to vertex 1.
///
/// P is the type of a point: `Vector3<double>`, `Vector3<Exact>`, or another one with the
/// predicates below.
template <class P>
struct PointSet {
  std::array<P, 3> at;  ///< m
  int size;             ///< 3, 2 or 1

  /// Vertex i modulo 3.
  const P& operator[](int i) const { return at[static_cast<std::size_t>(i % 3)]; }
  /// How many edges it has.
  int edges() const { return size == 3 ? 3 : size - 1; }
};

/// A pair of features whose relative interiors have exactly one point in common, and that stays the
/// only one if they are extended to lines or planes.
struct FeaturePair {
  Feature of_first, of_second;
  friend bool operator==(const FeaturePair&, const FeaturePair&) = default;
};

/// The vertices of the common set: in any order, but those of a polygon counter-clockwise in the
/// first projection (to yz, zx, xy) in which it has area.
struct FeaturePairs {
  std::array<FeaturePair, 6> pair{};
  int count = 0;

  /// Adds one that is not there yet.
  void add(const Feature& of_first, const Feature& of_second) {
    const FeaturePair added{of_first, of_second};
    const auto end = pair.begin() + count;
    if (std::find(pair.begin(), end, added) == end) pair[static_cast<std::size_t>(count++)] = added;
  }
  /// The same from the other triangle's point of view.
  void add(const Feature& of_one, const Feature& of_other, bool one_is_second) {
    one_is_second ? add(of_other, of_one) : add(of_one, of_other);
  }
  const FeaturePair& operator[](int i) const { return pair[static_cast<std::size_t>(i)]; }
  /// What these are the vertices of.
  CommonPoints kind() const {
    return count > 2 ? CommonPoints::area : static_cast<CommonPoints>(count);
  }
};

// ---------------------------------------------------------------- predicates

inline int space_sign(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c,
                      const Vector3<double>& d) {
  return orient_3d(a, b, c, d);
}
inline int space_sign(const Vector3<Exact>& a, const Vector3<Exact>& b, const Vector3<Exact>& c,
                      const Vector3<Exact>& d) {
  return signed_volume<Exact>(a, b, c, d).sign();
}
inline int plane_sign(const Vector2<double>& a, const Vector2<double>& b,
                      const Vector2<double>& c) {
  return polygon_detail::side(a, b, c);
}
inline int plane_sign(const Vector2<Exact>& a, const Vector2<Exact>& b, const Vector2<Exact>& c) {
  return orientation<Exact>(a, b, c).sign();
}
/// The orientation of three points in the projection without coordinate k.
template <Ring T>
int projected_sign(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c, int k) {
  return plane_sign(drop_dimension<T>(a, k), drop_dimension<T>(b, k), drop_dimension<T>(c, k));
}

/// The order of points by x, then y, then z. Along a line it is the order on the line.
template <Ring T>
bool is_before(const Vector3<T>& p, const Vector3<T>& q) {
  for (int k = 0; k < 3; ++k) {
    if (p[k] != q[k]) return p[k] < q[k];
  }
  return false;
}
/// Whether p is between q and r, for three points of a line; not if it is one of them.
template <class P>
bool is_between(const P& p, const P& q, const P& r) {
  return is_before(q, p) ? is_before(p, r) : is_before(r, p) && is_before(p, q);
}

/// The signs of the three vertices of a set (as many as it has) for the plane of a triangle.
using Signs = std::array<int, 3>;
template <class P>
Signs signs_for_plane(const PointSet<P>& triangle, const PointSet<P>& points) {
  Signs signs{};
  for (int i = 0; i < points.size; ++i) {
    signs[static_cast<std::size_t>(i)] =
        space_sign(triangle[0], triangle[1], triangle[2], points[i]);
  }
  return signs;
}
/// Whether all of the first n are positive, or all negative.
inline bool on_one_side(const Signs& signs, int n) {
  const auto end = signs.begin() + n;
  return std::all_of(signs.begin(), end, [](int s) { return s > 0; }) ||
         std::all_of(signs.begin(), end, [](int s) { return s < 0; });
}

/// The smallest feature of a triangle that contains a point of its plane, from the signs of the
/// point for its three edges, positive inside. Two of them are zero at a vertex only.
inline bool find_in_triangle(const Signs& signs, Feature& found) {
  found = {FeatureKind::face, 0};
  for (int j = 0; j < 3; ++j) {
    if (signs[static_cast<std::size_t>(j)] < 0) return false;
    if (signs[static_cast<std::size_t>(j)] > 0) continue;
    // The lines of edges j and j − 1 meet in vertex j.
    const bool both = found.kind == FeatureKind::edge;
    found = both ? Feature{FeatureKind::vertex, j == 2 && found.index == 0 ? 0 : j}
                 : Feature{FeatureKind::edge, j};
  }
  return true;
}

// ---------------------------------------------------------------- different planes

/// The point in which an edge that crosses the plane of a triangle meets it, if it does.
template <class P>
void add_crossing(FeaturePairs& found, const PointSet<P>& one, int edge,
                  const PointSet<P>& triangle, bool one_is_second) {
  const int other_end = one.size == 2 ? 1 : edge + 1;
  Signs signs{};
  int side = 0;
  for (int j = 0; j < 3; ++j) {
    const int s = space_sign(one[edge], one[other_end], triangle[j], triangle[j + 1]);
    if (s * side < 0) return;
    if (s != 0) side = s;
    signs[static_cast<std::size_t>(j)] = s * s;
  }
  Feature of_triangle;
  if (find_in_triangle(signs, of_triangle)) {
    found.add({FeatureKind::edge, edge}, of_triangle, one_is_second);
  }
}

/// The points of a triangle at which vertices and edges of another set meet it that is not in its
/// plane; `signs` are those of the set's vertices for the plane.
template <class P>
void add_meetings(FeaturePairs& found, const PointSet<P>& one, const PointSet<P>& triangle,
                  const Signs& signs, bool one_is_second) {
  int dropped = -1, turn = 0;
  for (int i = 0; i < one.size; ++i) {
    if (signs[static_cast<std::size_t>(i)] != 0) continue;
    for (int k = 0; turn == 0 && k < 3; ++k) {
      dropped = k;
      turn = projected_sign(triangle[0], triangle[1], triangle[2], k);
    }
    Signs inside{};
    for (int j = 0; j < 3; ++j) {
      inside[static_cast<std::size_t>(j)] =
          turn * projected_sign(triangle[j], triangle[j + 1], one[i], dropped);
    }
    Feature of_triangle;
    if (find_in_triangle(inside, of_triangle)) {
      found.add({FeatureKind::vertex, i}, of_triangle, one_is_second);
    }
  }
  for (int i = 0; i < one.edges(); ++i) {
    const std::size_t from = static_cast<std::size_t>(i);
    const std::size_t to = one.size == 2 ? 1 : (from + 1) % 3;
    if (signs[from] * signs[to] < 0) add_crossing(found, one, i, triangle, one_is_second);
  }
}

// ---------------------------------------------------------------- one plane, or one line

/// For each edge of one set (first index) and each vertex of another (second) of the same plane:
/// on which side of the edge the vertex is in a projection. Positive is inside, if the one is a
/// triangle.
using SideTable = std::array<Signs, 3>;

/// All signs of two sets in one plane, in a projection that is injective on it; all are zero if
/// they are on one line.
template <class P>
struct FlatSigns {
  int turn[2] = {0, 0};  ///< the orientations of the sets that are triangles
  SideTable of_second;   ///< of the second set's vertices, for the first set's edges
  SideTable of_first;    ///< of the first set's vertices, for the second set's edges

  FlatSigns(const PointSet<P>& a, const PointSet<P>& b) {
    for (int k = 0; k < 3; ++k) {
      turn[0] = a.size == 3 ? projected_sign(a[0], a[1], a[2], k) : 1;
      turn[1] = b.size == 3 ? projected_sign(b[0], b[1], b[2], k) : 1;
      if (turn[0] == 0 || turn[1] == 0) continue;
      const bool any = fill(of_second, a, b, turn[0], k);
      if (fill(of_first, b, a, turn[1], k) || any || a.size == 3 || b.size == 3) return;
    }
  }

 private:
  static bool fill(SideTable& table, const PointSet<P>& edges, const PointSet<P>& points, int turn,
                   int k) {
    table = {};
    bool any = false;
    for (int i = 0; i < edges.edges(); ++i) {
      for (int j = 0; j < points.size; ++j) {
        const int s = turn * projected_sign(edges[i], edges[i + 1], points[j], k);
        table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = s;
        any = any || s != 0;
      }
    }
    return any;
  }
};

/// The smallest feature of a set that contains a point of its plane.
template <class P>
bool find_in_set(const PointSet<P>& set, const SideTable& table, int j, const P& point,
                 Feature& found) {
  const auto column = static_cast<std::size_t>(j);
  if (set.size == 3) {
    return find_in_triangle({table[0][column], table[1][column], table[2][column]}, found);
  }
  for (int i = 0; i < set.size; ++i) {
    found = {FeatureKind::vertex, i};
    if (point == set[i]) return true;
  }
  found = {FeatureKind::edge, 0};
  return set.size == 2 && table[0][column] == 0 && is_between(point, set[0], set[1]);
}

/// Whether a vertex of the common polygon is the start of its side along an edge of one of the two
/// triangles, counter-clockwise; `turn` is the orientation of this triangle.
///
/// The vertex is an end of the edge, or is on an edge of the other triangle that is not parallel to
/// it. Then it is the start if the edge goes on to the inner side there.
inline bool starts_side(const Feature& here, const Feature& there, int edge, int turn,
                        const SideTable& of_ends) {
  const int last = (turn > 0 ? edge + 1 : edge) % 3;
  if (here.kind == FeatureKind::vertex) return here.index != last;
  for (int i = 0; i < 3; ++i) {
    const int side = of_ends[static_cast<std::size_t>(i)][static_cast<std::size_t>(last)];
    if (contains({FeatureKind::edge, i}, there) && side != 0) return side > 0;
  }
  return false;
}

/// Whether the side of the common polygon that leaves p ends in q. Each side is on an edge of one
/// of the triangles, and no edge has more than two of the polygon's vertices.
template <class P>
bool is_next(const FeaturePair& p, const FeaturePair& q, const FlatSigns<P>& signs) {
  for (int i = 0; i < 3; ++i) {
    const Feature edge{FeatureKind::edge, i};
    if (contains(edge, p.of_first) && contains(edge, q.of_first)) {
      return starts_side(p.of_first, p.of_second, i, signs.turn[0], signs.of_first);
    }
    if (contains(edge, p.of_second) && contains(edge, q.of_second)) {
      return starts_side(p.of_second, p.of_first, i, signs.turn[1], signs.of_second);
    }
  }
  return false;
}

/// Puts the vertices of a polygon in order.
template <class P>
void order_polygon(FeaturePairs& found, const FlatSigns<P>& signs) {
  for (int i = 0; i + 2 < found.count; ++i) {
    const auto here = found.pair.begin() + i;
    const auto next = std::find_if(here + 1, found.pair.begin() + found.count,
                                   [&](const FeaturePair& q) { return is_next(*here, q, signs); });
    if (next != found.pair.begin() + found.count) std::iter_swap(here + 1, next);
  }
}

/// The common vertices of two sets in one plane.
template <class P>
FeaturePairs flat_pairs(const PointSet<P>& a, const PointSet<P>& b) {
  const FlatSigns<P> signs(a, b);
  FeaturePairs found;
  Feature feature;
  for (int i = 0; i < a.size; ++i) {
    if (find_in_set(b, signs.of_first, i, a[i], feature)) {
      found.add({FeatureKind::vertex, i}, feature);
    }
  }
  for (int j = 0; j < b.size; ++j) {
    if (find_in_set(a, signs.of_second, j, b[j], feature)) {
      found.add(feature, {FeatureKind::vertex, j});
    }
  }
  const auto crosses = [](const SideTable& table, int edge, int i, int size) {
    const Signs& of = table[static_cast<std::size_t>(edge)];
    return of[static_cast<std::size_t>(i)] * of[static_cast<std::size_t>((i + 1) % size)] < 0;
  };
  for (int i = 0; i < a.edges(); ++i) {
    for (int j = 0; j < b.edges(); ++j) {
      if (crosses(signs.of_second, i, j, b.size) && crosses(signs.of_first, j, i, a.size)) {
        found.add({FeatureKind::edge, i}, {FeatureKind::edge, j});
      }
    }
  }
  if (found.count > 2) order_polygon(found, signs);
  return found;
}

// ---------------------------------------------------------------- all

/// Whether the four ends of two segments are not in one plane.
template <class P>
bool are_skew(const PointSet<P>& a, const PointSet<P>& b) {
  return a.size == 2 && b.size == 2 && space_sign(a[0], a[1], b[0], b[1]) != 0;
}

/// The vertices of what two sets have in common.
template <class P>
FeaturePairs feature_pairs(const PointSet<P>& a, const PointSet<P>& b) {
  Signs of_a{}, of_b{};
  if (a.size == 3) of_b = signs_for_plane(a, b);
  if (on_one_side(of_b, b.size)) return {};
  if (b.size == 3) of_a = signs_for_plane(b, a);
  if (on_one_side(of_a, a.size)) return {};
  if (a.size < 3 && b.size < 3 && are_skew(a, b)) return {};
  if (of_a == Signs{} && of_b == Signs{}) return flat_pairs(a, b);
  FeaturePairs found;
  if (b.size == 3) add_meetings(found, a, b, of_a, false);
  if (a.size == 3) add_meetings(found, b, a, of_b, true);
  return found;
}

/// The triangle with its vertices sorted, as a set of points.
template <class P>
PointSet<P> point_set(const std::array<P, 3>& sorted) {
  for (int k = 0; k < 3; ++k) {
    if (projected_sign(sorted[0], sorted[1], sorted[2], k) != 0) return {sorted, 3};
  }
  if (sorted[0] == sorted[2]) return {sorted, 1};
  return {{sorted[0], sorted[2], sorted[2]}, 2};
}

}  // namespace contact::feature_pairs_detail
