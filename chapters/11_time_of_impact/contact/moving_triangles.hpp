/// @file
/// Moving triangles (continuous collision detection): the first time at which a moving point is on
/// a moving triangle, or two moving edges meet, without a miss and without a false alarm.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <contact/exact_ray_triangle.hpp>
#include <contact/exact_roots.hpp>
#include <contact/moving_features.hpp>
#include <contact/moving_features_exact.hpp>
#include <contact/proximity.hpp>
#include <contact/shapes.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A vertex that moves in a straight line during a step.
template <Ring S>
struct MovingVertex {
  Vector3<S> start = Vector3<S>::Zero();  ///< at t = 0, m
  Vector3<S> end = Vector3<S>::Zero();    ///< at t = 1, m
};

/// An edge whose ends move in straight lines during a step: it may turn and change its length.
template <Ring S>
struct MovingEdge {
  Segment<S> start;  ///< at t = 0, m
  Segment<S> end;    ///< at t = 1, m
};

/// A triangle whose vertices move in straight lines during a step: it may turn and change its
/// shape, also to a segment or a point.
template <Ring S>
struct MovingTriangle {
  Triangle<S> start;  ///< at t = 0, m
  Triangle<S> end;    ///< at t = 1, m
};

/// Bounds of the time at which two moving features first meet, as fractions of the step.
template <Ring S>
struct FeatureImpact {
  S t = S(0);       ///< from 0 to 1; before it they have no common point
  S t_high = S(0);  ///< from t to 1; they first meet at this time at the t_high
};

namespace detail {

/// The answer of floating-point arithmetic, in doubt that without rounding.
template <FloatOrDouble S, class FirstTimeOf>
std::optional<FeatureImpact<S>> feature_impact(const FloatingTime& proved,
                                               const FirstTimeOf& exactly) {
  if (proved.state == FloatingTime::State::clear) return std::nullopt;
  if (proved.state == FloatingTime::State::meets) {
    return FeatureImpact<S>{time_down<S>(Exact(proved.t)), time_up<S>(Exact(proved.t_high))};
  }
  const FirstTime first = exactly();
  if (!first) return std::nullopt;
  return FeatureImpact<S>{time_down<S>(first->low), time_up<S>(first->high)};
}

/// Positions of a vertex at both ends of the step.
template <FloatOrDouble S>
std::array<Vector3<double>, 2> both_ends(const Vector3<S>& start, const Vector3<S>& end) {
  return {Vector3<double>(start.template cast<double>()),
          Vector3<double>(end.template cast<double>())};
}

inline bool all_ends_finite(const std::array<Vector3<double>, 2>& ends) {
  return all_finite(ends[0]) && all_finite(ends[1]);
}

}  // namespace detail

// [vertex-face]
/// The first time in a step at which a moving point is on a moving triangle.
///
/// Planes prove that they do not meet, signs of polynomials with bounds on their errors that they
/// do; in doubt the cubic is solved without rounding. So no contact is missed, and none is
/// invented: the answer is right for the stored numbers, whatever finite doubles they are. A point
/// that is on the triangle only at the start, only at the end, or only on its edge counts. A
/// triangle that is a segment or a point is treated as one, and nothing need move.
/// @return nothing if they do not meet from 0 to 1, or if a number is not finite
template <FloatOrDouble S>
std::optional<FeatureImpact<S>> vertex_face_impact(const MovingVertex<S>& point,
                                                   const MovingTriangle<S>& face) {
  const auto p = detail::both_ends<S>(point.start, point.end);
  const std::array<std::array<Vector3<double>, 2>, 3> vertices{
      detail::both_ends<S>(face.start.a, face.end.a),
      detail::both_ends<S>(face.start.b, face.end.b),
      detail::both_ends<S>(face.start.c, face.end.c)};
  bool finite = detail::all_ends_finite(p);
  for (const auto& vertex_ends : vertices) finite = finite && detail::all_ends_finite(vertex_ends);
  if (!finite) return std::nullopt;
  return detail::feature_impact<S>(
      detail::first_time_in_floating_point(detail::SeenTriangle(p, vertices)), [&] {
        const auto seen = [&](std::size_t i) { return detail::moving_vector(p, vertices[i]); };
        return detail::first_time_on_triangle(seen(0), seen(1), seen(2));
      });
}
// [/vertex-face]

// [edge-edge]
/// The first time in a step at which two moving segments have a common point.
///
/// Right for all finite numbers, as vertex_face_impact(). Parallel segments, segments in a plane
/// all the time and segments of length 0 are no exceptions.
/// @return nothing if they do not meet from 0 to 1, or if a number is not finite
template <FloatOrDouble S>
std::optional<FeatureImpact<S>> edge_edge_impact(const MovingEdge<S>& a, const MovingEdge<S>& b) {
  const auto p = detail::both_ends<S>(a.start.start, a.end.start);
  const auto q = detail::both_ends<S>(a.start.end, a.end.end);
  const auto r = detail::both_ends<S>(b.start.start, b.end.start);
  const auto s = detail::both_ends<S>(b.start.end, b.end.end);
  if (!detail::all_ends_finite(p) || !detail::all_ends_finite(q) || !detail::all_ends_finite(r) ||
      !detail::all_ends_finite(s)) {
    return std::nullopt;
  }
  return detail::feature_impact<S>(
      detail::first_time_in_floating_point(detail::SeenSegments(p, q, r, s)), [&] {
        using detail::moving_vector;
        return detail::first_time_of_segments(moving_vector(r, p), moving_vector(s, p),
                                              moving_vector(r, q), moving_vector(s, q));
      });
}
// [/edge-edge]

namespace detail {

/// Vertex i of a moving triangle; 3 is 0 again.
template <FloatOrDouble S>
MovingVertex<S> moving_vertex(const MovingTriangle<S>& triangle, int i) {
  return {vertex(triangle.start, i % 3), vertex(triangle.end, i % 3)};
}

/// The edge of a moving triangle from vertex i to the next.
template <FloatOrDouble S>
MovingEdge<S> moving_edge(const MovingTriangle<S>& triangle, int i) {
  const MovingVertex<S> from = moving_vertex(triangle, i), to = moving_vertex(triangle, i + 1);
  return {{from.start, to.start}, {from.end, to.end}};
}

}  // namespace detail

// [moving-triangles]
/// The first time in a step at which two moving triangles have a common point.
///
/// If they have none at the start, at their first common point a vertex of one is on the other or
/// two edges meet: where two triangles are in each other by more than that, they also were just
/// before. So six vertices against faces and nine pairs of edges are enough.
/// @return nothing if they do not meet from 0 to 1, or if a number is not finite
template <FloatOrDouble S>
std::optional<FeatureImpact<S>> moving_triangles_impact(const MovingTriangle<S>& a,
                                                        const MovingTriangle<S>& b) {
  for (const Triangle<S>* triangle : {&a.start, &a.end, &b.start, &b.end}) {
    for (int i = 0; i < 3; ++i) {
      if (!all_finite(vertex(*triangle, i))) return std::nullopt;
    }
  }
  if (proximity(a.start, b.start) != Proximity::disjoint) return FeatureImpact<S>{};
  std::optional<FeatureImpact<S>> first;
  const auto keep = [&first](const std::optional<FeatureImpact<S>>& found) {
    if (!found) return;
    if (!first) {
      first = found;
    } else {
      first =
          FeatureImpact<S>{std::min(first->t, found->t), std::min(first->t_high, found->t_high)};
    }
  };
  for (int i = 0; i < 3; ++i) {
    keep(vertex_face_impact(detail::moving_vertex(a, i), b));
    keep(vertex_face_impact(detail::moving_vertex(b, i), a));
    for (int k = 0; k < 3; ++k) {
      keep(edge_edge_impact(detail::moving_edge(a, i), detail::moving_edge(b, k)));
    }
  }
  return first;
}
// [/moving-triangles]

}  // namespace contact
