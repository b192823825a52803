/// @file
/// Squared distances of segments and boxes as stored, in exact arithmetic.
///
/// A squared distance is a quotient of polynomials, so exact fractions compute it without rounding.
/// A box is taken as the parallelepiped of its stored numbers: its axes need not be orthogonal.
#pragma once

#include <concepts>
#include <optional>

#include <contact/convex_shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// An exact Scalar: fractions.
template <class S>
concept ExactScalar = Scalar<S> && !std::floating_point<S>;

// [exact-point-segment]
/// The squared distance of a point from a segment, which may have length 0.
/// @return m²
template <ExactScalar S>
S exact_squared_distance(const Vector3<S>& p, const Segment<S>& segment) {
  const Vector3<S> d = segment.end - segment.start;
  const Vector3<S> w = p - segment.start;
  const S along = w.dot(d);
  const S whole = d.dot(d);
  if (!(S(0) < along)) return w.dot(w);
  if (!(along < whole)) {
    const Vector3<S> beyond = p - segment.end;
    return beyond.dot(beyond);
  }
  return w.dot(w) - along * along / whole;
}
// [/exact-point-segment]

// [exact-segments]
/// The squared distance of two segments: that of their lines if the closest points lie on both
/// segments, otherwise that of an end of one of them.
/// @return m²
template <ExactScalar S>
S exact_squared_distance(const Segment<S>& a, const Segment<S>& b) {
  S least = exact_squared_distance<S>(a.start, b);
  const auto consider = [&least](const S& other) {
    if (other < least) least = other;
  };
  consider(exact_squared_distance<S>(a.end, b));
  consider(exact_squared_distance<S>(b.start, a));
  consider(exact_squared_distance<S>(b.end, a));
  const Vector3<S> d = a.end - a.start;
  const Vector3<S> e = b.end - b.start;
  const Vector3<S> w = b.start - a.start;
  const Vector3<S> n = d.cross(e);
  const S whole = n.dot(n);
  if (whole == S(0)) return least;
  const S s = n.dot(Vector3<S>(w.cross(e)));
  const S t = n.dot(Vector3<S>(w.cross(d)));
  if (S(0) < s && s < whole && S(0) < t && t < whole) {
    const S across = n.dot(w);
    consider(across * across / whole);
  }
  return least;
}
// [/exact-segments]

namespace detail {

/// The parallelepiped of a box: its half edges, and the cross products that give a point's
/// coordinates.
template <ExactScalar S>
struct HalfEdges {
  Vector3<S> edge[3];   ///< m
  Vector3<S> cross[3];  ///< cross[i] = edge[i + 1] × edge[i + 2], m²
  S volume = S(0);      ///< absolute value of edge[0] · cross[0], m³

  explicit HalfEdges(const OrientedBox<S>& box) {
    for (int i = 0; i < 3; ++i) {
      edge[i] = Vector3<S>(box.axes.col(i)) * S(box.half_lengths(i));
    }
    for (int i = 0; i < 3; ++i) cross[i] = edge[(i + 1) % 3].cross(edge[(i + 2) % 3]);
    volume = edge[0].dot(cross[0]);
    if (volume < S(0)) volume = -volume;
  }
};

/// The squared distance of p from the face centre + side edge[k] + ..., if the foot of the
/// perpendicular lies on it.
template <ExactScalar S>
std::optional<S> squared_distance_from_face(const Vector3<S>& p, const Vector3<S>& middle,
                                            const HalfEdges<S>& box, int k) {
  const Vector3<S> w = p - middle;
  const Vector3<S>& n = box.cross[k];
  const Vector3<S>& e = box.edge[(k + 1) % 3];
  const Vector3<S>& f = box.edge[(k + 2) % 3];
  const S whole = n.dot(n);
  const S x = n.dot(Vector3<S>(w.cross(f)));
  const S y = n.dot(Vector3<S>(e.cross(w)));
  if (whole < x || x < -whole || whole < y || y < -whole || whole == S(0)) return std::nullopt;
  const S across = n.dot(w);
  return across * across / whole;
}

}  // namespace detail

// [exact-meets]
/// Whether a segment has a point in common with a box, or, if `within`, with its interior.
template <ExactScalar S>
bool segment_meets_box(const Segment<S>& segment, const OrientedBox<S>& box, bool within = false) {
  const detail::HalfEdges<S> half(box);
  const Vector3<S> w = segment.start - box.centre;
  const Vector3<S> d = segment.end - segment.start;
  std::optional<S> first;  // entry into the last slab, as a fraction of d
  std::optional<S> last;   // exit from the first slab
  for (int i = 0; i < 3; ++i) {
    // −volume ≤ at + t rate ≤ volume
    const S at = half.cross[i].dot(w);
    const S rate = half.cross[i].dot(d);
    if (rate == S(0)) {
      if (half.volume < at || at < -half.volume) return false;
      if (within && (half.volume == at || at == -half.volume)) return false;
      continue;
    }
    const S limit = rate < S(0) ? S(-half.volume) : half.volume;
    const S enters = (-limit - at) / rate;
    const S leaves = (limit - at) / rate;
    if (!first || *first < enters) first = enters;
    if (!last || leaves < *last) last = leaves;
  }
  if (!first) return true;  // parallel to all slabs (length 0), and inside them
  if (within) return *first < *last && *first < S(1) && S(0) < *last;
  return !(*last < *first) && !(S(1) < *first) && !(*last < S(0));
}
// [/exact-meets]

// [exact-segment-box]
/// The squared distance of a segment from a box; 0 if they meet.
///
/// If they do not, the closest points are an end of the segment and a point of a face, or a point
/// of the segment and one of an edge.
/// @return m²
template <ExactScalar S>
S exact_squared_distance(const Segment<S>& segment, const OrientedBox<S>& box) {
  if (segment_meets_box(segment, box)) return S(0);
  S least = exact_squared_distance<S>(segment, box_edge(box, 0));
  const auto consider = [&least](const S& other) {
    if (other < least) least = other;
  };
  for (int k = 1; k < 12; ++k) consider(exact_squared_distance<S>(segment, box_edge(box, k)));
  const detail::HalfEdges<S> half(box);
  for (int k = 0; k < 3; ++k) {
    for (const Vector3<S>& middle :
         {Vector3<S>(box.centre + half.edge[k]), Vector3<S>(box.centre - half.edge[k])}) {
      for (const Vector3<S>& end : {segment.start, segment.end}) {
        const auto face = detail::squared_distance_from_face<S>(end, middle, half, k);
        if (face) consider(*face);
      }
    }
  }
  return least;
}

/// The squared distance of a point from a box; 0 if it is in the box.
/// @return m²
template <ExactScalar S>
S exact_squared_distance(const Vector3<S>& p, const OrientedBox<S>& box) {
  return exact_squared_distance<S>(Segment<S>{p, p}, box);
}
// [/exact-segment-box]

// [exact-boxes]
/// The squared distance of two boxes; 0 if they meet. Each edge of one is tested against the other:
/// boxes that meet have an edge of one that meets the other, or one contains the other.
/// @return m²
template <ExactScalar S>
S exact_squared_distance(const OrientedBox<S>& a, const OrientedBox<S>& b) {
  S least = exact_squared_distance<S>(box_edge(a, 0), b);
  for (int k = 1; k < 24 && S(0) < least; ++k) {
    const S other = k < 12 ? exact_squared_distance<S>(box_edge(a, k), b)
                           : exact_squared_distance<S>(box_edge(b, k - 12), a);
    if (other < least) least = other;
  }
  return least;
}
// [/exact-boxes]

}  // namespace contact
