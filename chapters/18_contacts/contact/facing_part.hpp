/// @file
/// The part of a polytope that faces a direction: a face, an edge or a vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/close_points.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/manifold_point.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

// [facing-part]
/// A face, an edge or a vertex of a polytope.
template <Ring S>
struct FacingPart {
  std::vector<int> vertices;  ///< of a face three or more, counter-clockwise from outside
  Vector3<S> normal = Vector3<S>::Zero();  ///< of a face: outward, unit vector; else 0
};
// [/facing-part]

namespace detail {

/// A vertex relative to the farthest one along n: two coordinates perpendicular to n, and how much
/// less far it is.
template <Ring S>
struct VertexBelow {
  S x, y, drop;
  int index;
};

/// The vertices of a convex polygon, counter-clockwise, of points that may lie on its edges and in
/// it (Andrew's monotone chain). Points nearer than `nothing` to a line of others are left out.
template <std::floating_point S>
std::vector<VertexBelow<S>> outline(std::vector<VertexBelow<S>> points, const S& nothing) {
  std::sort(points.begin(), points.end(), [](const auto& p, const auto& q) {
    if (p.x != q.x) return p.x < q.x;
    return p.y != q.y ? p.y < q.y : p.index < q.index;
  });
  const auto same = [](const auto& p, const auto& q) { return p.x == q.x && p.y == q.y; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  if (points.size() < 3) return points;
  const auto turns_left = [&](const auto& p, const auto& q, const auto& r) {
    const S dx = r.x - p.x, dy = r.y - p.y;
    return (q.x - p.x) * dy - (q.y - p.y) * dx > nothing * std::sqrt(dx * dx + dy * dy);
  };
  std::vector<VertexBelow<S>> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t first = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= first + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The outward unit normal of a polygon: of the sum of its triangles over the first vertex.
template <PolytopeCore Body>
Vector3<ScalarOf<Body>> normal_of_polygon(const Body& body, const std::vector<int>& polygon) {
  using S = ScalarOf<Body>;
  Vector3<S> sum = Vector3<S>::Zero();
  const Vector3<S> first = vertex(body, polygon[0]);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector3<S> d = vertex(body, polygon[i - 1]) - first;
    const Vector3<S> e = vertex(body, polygon[i]) - first;
    sum += Vector3<S>(d.cross(e));
  }
  return normalised<S>(sum);
}

}  // namespace detail

// [facing-part-of]
/// The part of a polytope's core that is farthest along n: a face if it falls by at most `steepest`
/// of the length along it, else such an edge, else the farthest vertex (the first of equal ones).
///
/// Gift wrapping from that vertex, without a list of faces. Of the edges at the vertex the one that
/// falls least for its length is taken. The plane through it that is perpendicular to n otherwise
/// has no vertex beyond it: the plane through the vertex has none, and it is rotated about the
/// horizontal line through the vertex until it meets the edge that falls least. Rotated about the
/// edge until it meets another vertex, to the side where that takes less, it is a face's plane.
/// Lengths below 2^-20 (float: 2^-12) of the polytope's size count as 0.
/// @param n a unit vector
/// @return time is proportional to the number of vertices, but for sorting those of the face
template <PolytopeCore Body>
FacingPart<ScalarOf<Body>> facing_part(const Body& body, const Vector3<ScalarOf<Body>>& n,
                                       const ScalarOf<Body>& steepest) {
  using S = ScalarOf<Body>;
  const int top = support_vertex(body, n);
  if (vertex_count(body) == 1) return {{top}, Vector3<S>::Zero()};
  const Vector3<S> right = detail::perpendicular_to<S>(n), up = n.cross(right),
                   at = vertex(body, top);
  std::vector<detail::VertexBelow<S>> points;
  S size(0);
  for (int i = 0; i < vertex_count(body); ++i) {
    const Vector3<S> d = vertex(body, i) - at;
    points.push_back({right.dot(d), up.dot(d), std::max(S(0), S(-n.dot(d))), i});
    size = std::max(size, d.cwiseAbs().maxCoeff());
  }
  const S nothing = detail::flatness<S> * size;
  S slope = std::numeric_limits<S>::infinity(), x(1), y(0);  // of the edge, seen along n
  for (const auto& p : points) {
    const S length = std::sqrt(p.x * p.x + p.y * p.y);
    if (!(length > nothing && p.drop < slope * length)) continue;
    slope = p.drop / length;
    x = p.x / length;
    y = p.y / length;
  }
  if (!(slope <= steepest)) return {{top}, Vector3<S>::Zero()};
  const auto beside = [&](const auto& p) { return x * p.y - y * p.x; };
  const auto below_edge = [&](const auto& p) { return p.drop - slope * (x * p.x + y * p.y); };
  S tilt = std::numeric_limits<S>::infinity();
  bool left = true;
  for (const auto& p : points) {
    const S away = std::abs(beside(p));
    if (!(away > nothing && below_edge(p) < tilt * away)) continue;
    tilt = below_edge(p) / away;
    left = beside(p) > S(0);
  }
  const bool is_face = tilt <= steepest;
  std::erase_if(points, [&](const auto& p) {
    const S away = beside(p);
    if (!is_face) return std::abs(away) > nothing || below_edge(p) > nothing;
    return below_edge(p) - tilt * (left ? away : -away) > nothing;
  });
  FacingPart<S> part;
  for (const auto& p : detail::outline<S>(points, nothing)) part.vertices.push_back(p.index);
  if (part.vertices.size() > 2) part.normal = detail::normal_of_polygon(body, part.vertices);
  return part;
}
// [/facing-part-of]

/// Which feature a part is.
template <Ring S>
SurfaceFeature feature_of(const FacingPart<S>& part) {
  if (part.vertices.size() == 1) return vertex_feature(part.vertices[0]);
  if (part.vertices.size() == 2) return edge_feature(part.vertices[0], part.vertices[1]);
  return {};
}

/// The feature of a body that is farthest along a unit vector: that of its core.
template <PolytopeCore Body>
SurfaceFeature facing_feature(const Body& body, const Vector3<ScalarOf<Body>>& n) {
  return feature_of(facing_part(body, n, detail::flatness<ScalarOf<Body>>));
}
/// A half-space has a surface only.
template <Ring S>
SurfaceFeature facing_feature(const HalfSpace<S>&, const Vector3<S>&) {
  return {};
}

}  // namespace contact
