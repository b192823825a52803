/// @file
/// The closest points of segments and boxes, in floating point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/convex_shapes.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A pair of closest points of A and B.
template <Ring S>
struct ClosestPoints {
  Vector3<S> on_a = Vector3<S>::Zero();  ///< m
  Vector3<S> on_b = Vector3<S>::Zero();  ///< m
};

namespace detail {

template <std::floating_point S>
S squared_between(const ClosestPoints<S>& points) {
  const Vector3<S> between = points.on_a - points.on_b;
  return between.dot(between);
}

/// The point of a segment at the fraction t, computed from the closer end.
template <std::floating_point S>
Vector3<S> point_at(const Segment<S>& segment, const S& t) {
  const Vector3<S> d = segment.end - segment.start;
  if (t <= S(0.5)) return segment.start + d * t;
  return segment.end - d * (S(1) - t);
}

/// Keeps the closer of two pairs; of equal ones the first.
template <std::floating_point S>
void keep_nearer(ClosestPoints<S>& best, const ClosestPoints<S>& other) {
  if (squared_between(other) < squared_between(best)) best = other;
}

template <std::floating_point S>
ClosestPoints<S> exchanged(const ClosestPoints<S>& points) {
  return {points.on_b, points.on_a};
}

}  // namespace detail

// [point-segment]
/// The closest point of a segment to p. For a segment of length 0 it is the start.
/// @return m, error a few u of the coordinates' magnitude
template <std::floating_point S>
Vector3<S> closest_point(const Vector3<S>& p, const Segment<S>& segment) {
  const Vector3<S> d = segment.end - segment.start;
  const S along = d.dot(Vector3<S>(p - segment.start));
  const S whole = d.dot(d);
  if (!(along > S(0))) return segment.start;
  if (!(along < whole)) return segment.end;
  return detail::point_at<S>(segment, along / whole);
}
// [/point-segment]

// [crossing]
namespace detail {

/// The closest points of the lines of two segments, as fractions of the segments, if both fractions
/// are from 0 to 1; {−1, −1} otherwise, or if the lines are parallel.
///
/// With n = d × e: s = n · (w × e) / n², t = n · (w × d) / n². If the sine of the angle between the
/// segments is below 2^-12, rounding would spoil n, and the fractions are computed exactly up to
/// the last step (for long double, which has no exact arithmetic here, always in floating point).
template <std::floating_point S>
Vector2<S> crossing_fractions(const Segment<S>& a, const Segment<S>& b) {
  const auto solve = [](const auto& d, const auto& e, const auto& w, auto& s, auto& t,
                        auto& whole) {
    const auto n = d.cross(e).eval();
    whole = n.dot(n);
    s = n.dot(w.cross(e).eval());
    t = n.dot(w.cross(d).eval());
  };
  const Vector2<S> none(S(-1), S(-1));
  const Vector3<S> d = a.end - a.start;
  const Vector3<S> e = b.end - b.start;
  const Vector3<S> w = b.start - a.start;
  S s(0);
  S t(0);
  S whole(0);
  solve(d, e, w, s, t, whole);
  const S lengths = d.dot(d) * e.dot(e);
  if constexpr (std::numeric_limits<S>::digits <= 53) {
    if (!(whole > lengths * S(0x1p-24))) {
      if (d == Vector3<S>::Zero() || e == Vector3<S>::Zero()) return none;
      const bool finite =
          all_finite(a.start) && all_finite(a.end) && all_finite(b.start) && all_finite(b.end);
      if (!finite) return none;
      const Vector3<Exact> start = exact_vector(a.start);
      const Vector3<Exact> other = exact_vector(b.start);
      const Vector3<Exact> exact_d = exact_vector(a.end) - start;
      const Vector3<Exact> exact_e = exact_vector(b.end) - other;
      const Vector3<Exact> exact_w = other - start;
      Exact es;
      Exact et;
      Exact ew;
      solve(exact_d, exact_e, exact_w, es, et, ew);
      if (ew.sign() == 0 || es.sign() < 0 || et.sign() < 0 || ew < es || ew < et) return none;
      return {quotient<S>(es, ew), quotient<S>(et, ew)};
    }
  }
  if (!(whole > S(0)) || s < S(0) || t < S(0) || s > whole || t > whole) return none;
  return {s / whole, t / whole};
}

}  // namespace detail
// [/crossing]

// [segments]
/// The closest points of two segments, which may be parallel or of length 0.
///
/// Four candidates are an end of one segment and the closest point of the other. The fifth is the
/// pair of closest points of the lines, if it lies between the ends; the sixth projects these
/// points onto the segments once more, which removes the effect of rounding. The closest pair is
/// kept; of equal ones the first, so parallel segments give an end.
template <std::floating_point S>
ClosestPoints<S> closest_points(const Segment<S>& a, const Segment<S>& b) {
  ClosestPoints<S> best{a.start, closest_point<S>(a.start, b)};
  detail::keep_nearer<S>(best, {a.end, closest_point<S>(a.end, b)});
  detail::keep_nearer<S>(best, {closest_point<S>(b.start, a), b.start});
  detail::keep_nearer<S>(best, {closest_point<S>(b.end, a), b.end});
  const Vector2<S> at = detail::crossing_fractions(a, b);
  if (at.x() >= S(0)) {
    const Vector3<S> on_a = detail::point_at<S>(a, at.x());
    detail::keep_nearer<S>(best, {on_a, detail::point_at<S>(b, at.y())});
    const Vector3<S> on_b = closest_point<S>(on_a, b);
    detail::keep_nearer<S>(best, {closest_point<S>(on_b, a), on_b});
  }
  return best;
}
// [/segments]

// [point-box]
/// A point in the axes of a box, relative to its centre.
template <Ring S>
Vector3<S> in_box_axes(const OrientedBox<S>& box, const Vector3<S>& p) {
  const Vector3<S> w = p - box.centre;
  return {w.dot(Vector3<S>(box.axes.col(0))), w.dot(Vector3<S>(box.axes.col(1))),
          w.dot(Vector3<S>(box.axes.col(2)))};
}

/// The world coordinates of a point given in the axes of a box.
template <Ring S>
Vector3<S> out_of_box_axes(const OrientedBox<S>& box, const Vector3<S>& local) {
  Vector3<S> p = box.centre;
  for (int i = 0; i < 3; ++i) p = p + Vector3<S>(box.axes.col(i)) * S(local(i));
  return p;
}

/// The closest point of a box to p: each coordinate in the box's axes is clamped to the half
/// length. A point inside the box is its own closest point.
/// @return m, error a few u of the coordinates' magnitude
template <std::floating_point S>
Vector3<S> closest_point(const Vector3<S>& p, const OrientedBox<S>& box) {
  const Vector3<S> local = in_box_axes(box, p);
  Vector3<S> inside;
  for (int i = 0; i < 3; ++i) {
    inside(i) = std::clamp<S>(local(i), -box.half_lengths(i), box.half_lengths(i));
  }
  if (inside == local) return p;
  return out_of_box_axes(box, inside);
}
// [/point-box]

namespace detail {

// [nearer-edges]
/// Which edges of a box can have points nearer to a segment than the best pair so far: a filter.
///
/// Along n every point of the segment is at least `low` and every point of edge k at most high(k).
/// So two points of them are (low − high)/|n| apart at least; if that exceeds the distance of the
/// best pair, they are no better. The projections have three roundings each, two computed points
/// six in each coordinate, and the squares five: 64 u of all terms are more. So what is skipped
/// would not have been kept, and the result does not depend on n.
template <std::floating_point S>
class NearerEdges {
 public:
  explicit NearerEdges(const OrientedBox<S>& box) {
    for (int k = 0; k < 12; ++k) edges_[at(k)] = box_edge(box, k);
    for (const Segment<S>& edge : edges_) size_ = std::max(size_, largest(edge));
  }
  /// Edge k, as box_edge().
  const Segment<S>& edge(int k) const { return edges_[at(k)]; }
  /// Filters along the direction n from now on.
  void use(const Vector3<S>& n) {
    n_ = n;
    length_ = std::sqrt(n.dot(n));
    for (int k = 0; k < 12; ++k) {
      high_[at(k)] = std::max(n.dot(edges_[at(k)].start), n.dot(edges_[at(k)].end));
    }
  }
  /// Takes the segment and the best pair so far.
  void compare(const Segment<S>& a, const ClosestPoints<S>& best) {
    constexpr S room = S(32) * std::numeric_limits<S>::epsilon();
    constexpr S infinity = std::numeric_limits<S>::infinity();
    constexpr S least = std::numeric_limits<S>::min() / std::numeric_limits<S>::epsilon();
    const S squared = squared_between(best), reach = length_ * std::sqrt(squared);
    limit_ = -infinity;
    if (!(squared > least && length_ * length_ > least)) return;
    limit_ = std::min(n_.dot(a.start), n_.dot(a.end)) - reach -
             room * (length_ * S(2) * std::max(size_, largest(a)) + reach);
    if (!(limit_ < infinity)) limit_ = -infinity;
  }
  /// Whether no point of edge k is nearer.
  bool excludes(int k) const { return limit_ > high_[at(k)]; }

 private:
  std::array<Segment<S>, 12> edges_;
  std::array<S, 12> high_{};
  Vector3<S> n_ = Vector3<S>::Zero();
  S length_ = S(0);
  S size_ = S(0);                                  // the largest coordinate of the box
  S limit_ = -std::numeric_limits<S>::infinity();  // edges with a smaller projection are no nearer

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  static S largest(const Segment<S>& s) {
    return std::max(s.start.cwiseAbs().maxCoeff(), s.end.cwiseAbs().maxCoeff());
  }
};
// [/nearer-edges]

/// A common point of a segment and a box, up to rounding: the middle of the part of the segment
/// inside the slabs. Equal points mean that there is one.
template <std::floating_point S>
bool rounded_meeting(const Segment<S>& segment, const OrientedBox<S>& box, Vector3<S>& meeting) {
  const Vector3<S> start = in_box_axes(box, segment.start);
  const Vector3<S> end = in_box_axes(box, segment.end);
  S first(0);
  S last(1);
  for (int i = 0; i < 3; ++i) {
    const S half = box.half_lengths(i);
    const S rate = end(i) - start(i);
    if (rate == S(0)) {
      if (std::abs(start(i)) > half) return false;
      continue;
    }
    const S one = (-half - start(i)) / rate;
    const S other = (half - start(i)) / rate;
    first = std::max(first, std::min(one, other));
    last = std::min(last, std::max(one, other));
    if (!(first <= last)) return false;
  }
  meeting = point_at<S>(segment, (first + last) / S(2));
  return true;
}

/// Keeps the closest points of a segment and the edges of a box, if they are nearer. The filter
/// continues along the difference of each pair that is kept.
template <std::floating_point S>
void keep_nearest_edges(const Segment<S>& a, NearerEdges<S>& edges, ClosestPoints<S>& best) {
  edges.compare(a, best);
  S nearest = squared_between(best);
  for (int k = 0; k < 12; ++k) {
    if (edges.excludes(k)) continue;
    keep_nearer<S>(best, closest_points<S>(a, edges.edge(k)));
    const S squared = squared_between(best);
    if (!(squared < nearest)) continue;
    nearest = squared;
    edges.use(Vector3<S>(best.on_a - best.on_b));
    edges.compare(a, best);
  }
}

}  // namespace detail

// [segment-box]
/// The closest points of a segment and a box. If they meet, both are one common point.
///
/// Otherwise the candidates are an end of the segment and the closest point of the box, and the
/// closest points of the segment and each edge of the box.
/// @return m; the error of their distance is a few u of the coordinates' magnitude
template <std::floating_point S>
ClosestPoints<S> closest_points(const Segment<S>& a, const OrientedBox<S>& b) {
  Vector3<S> meeting;
  if (detail::rounded_meeting<S>(a, b, meeting)) {
    return {meeting, closest_point<S>(meeting, b)};
  }
  ClosestPoints<S> best{a.start, closest_point<S>(a.start, b)};
  detail::keep_nearer<S>(best, {a.end, closest_point<S>(a.end, b)});
  if (a.start == a.end) return best;
  detail::NearerEdges<S> edges(b);
  edges.use(Vector3<S>(best.on_a - best.on_b));
  detail::keep_nearest_edges<S>(a, edges, best);
  return best;
}
// [/segment-box]

// [boxes]
/// The closest points of two separated boxes.
///
/// Candidates are a corner of one and the closest point of the other, and the closest points of two
/// edges: 16 and 144 candidates, in a fixed order. Most pairs of edges are skipped, because they
/// are too far apart along one direction.
/// @param along a direction from B to A along which the boxes may be separated, of any length; it
/// changes the time only
/// @return m; the error of their distance is a few u of the coordinates' magnitude. For overlapping
/// boxes the pair has no meaning
template <std::floating_point S>
ClosestPoints<S> closest_points(const OrientedBox<S>& a, const OrientedBox<S>& b,
                                const Vector3<S>& along = Vector3<S>::Zero()) {
  ClosestPoints<S> best{box_corner(a, 0), closest_point<S>(box_corner(a, 0), b)};
  for (int k = 1; k < 8; ++k) {
    const Vector3<S> corner = box_corner(a, k);
    detail::keep_nearer<S>(best, {corner, closest_point<S>(corner, b)});
  }
  for (int k = 0; k < 8; ++k) {
    const Vector3<S> corner = box_corner(b, k);
    detail::keep_nearer<S>(best, {closest_point<S>(corner, a), corner});
  }
  detail::NearerEdges<S> edges(b);
  edges.use(along == Vector3<S>::Zero() ? Vector3<S>(best.on_a - best.on_b) : along);
  for (int i = 0; i < 12; ++i) detail::keep_nearest_edges<S>(box_edge(a, i), edges, best);
  return best;
}
// [/boxes]

}  // namespace contact
