/// @file
/// A moving sphere against a static segment or capsule.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include <contact/entry_time.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/shapes.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The problem: a point that moves from m (relative to the segment's start) by w, against all
/// points at most R from the segment from 0 to e.
struct CapsuleQuestion {
  Vector3<Exact> m;
  Vector3<Exact> w;
  Vector3<Exact> e;
  Exact radius_sum;

  bool meets_at_start() const {
    const Exact along = m.dot(e);
    const Exact length = e.dot(e);
    if (along.sign() <= 0) return (m.dot(m) - radius_sum * radius_sum).sign() <= 0;
    const Vector3<Exact> from_end = m - e;
    if (length <= along) return (from_end.dot(from_end) - radius_sum * radius_sum).sign() <= 0;
    const Vector3<Exact> across = m.cross(e);
    return (across.dot(across) - radius_sum * radius_sum * length).sign() <= 0;
  }

  /// The terms of the infinite cylinder: those of the motion perpendicular to the axis, times |e|².
  EntryTerms<Exact> side() const {
    const Vector3<Exact> across = m.cross(e);
    const Vector3<Exact> moved = w.cross(e);
    const Exact square = moved.dot(moved);
    const Exact approach = -across.dot(moved);
    const Exact gap = across.dot(across) - radius_sum * radius_sum * e.dot(e);
    return {square, approach, gap, approach * approach - square * gap};
  }

  /// Whether the point enters the cylinder between both ends: 0 ≤ (m + w t) · e ≤ e · e at that t.
  bool enters_between_ends(const EntryTerms<Exact>& side) const {
    const Exact along = w.dot(e);
    const Exact at = side.square * m.dot(e) + side.approach * along;
    const Exact past = at - side.square * e.dot(e);
    return sign_with_root(at, -along, side.depth) >= 0 &&
           sign_with_root(past, -along, side.depth) <= 0;
  }
};

}  // namespace detail

// [sphere-capsule-impact]
/// The time at which a moving sphere first touches a capsule. With radius 0 the capsule is a
/// segment; with two equal ends it is a sphere.
///
/// The centre of the sphere, as a point, hits a capsule with the sum of both radii (Minkowski sum):
/// the side of a cylinder and a ball at each end; the flat ends of the cylinder lie inside the
/// balls. The balls are inside the infinite cylinder, so if the side is entered between the ends,
/// it is entered first. Signs are exact, also that of the position along the axis at the entry,
/// which has one square root.
/// @param sphere at the start, m, finite, with a radius that is not negative
/// @param displacement of its centre in the step, m, finite
/// @param axis of the static capsule, m, finite; both ends may be equal
/// @param radius of the capsule, m, finite and not negative
/// @return t, the fraction of the displacement, from 0 to 1: 0 if they meet at the start, in
/// whichever direction the sphere moves; nothing if they do not touch. The decision is right for
/// every finite input; t has a relative error of at most 5 u, without underflow
/// @see *Fundamentals of Computer Animation*, slide "Sphere-Plane Collision", for a plane
template <std::floating_point S>
std::optional<S> sphere_capsule_impact(const Sphere<S>& sphere, const Vector3<S>& displacement,
                                       const Segment<S>& axis, S radius) {
  const detail::CapsuleQuestion question{exact_vector_difference(sphere.centre, axis.start),
                                         exact_vector(displacement),
                                         exact_vector_difference(axis.end, axis.start),
                                         Exact(double(sphere.radius)) + Exact(double(radius))};
  if (question.meets_at_start()) return S(0);
  const Exact last(1.0);
  const EntryTerms<Exact> side = question.side();
  if (side.enters() && question.enters_between_ends(side)) {
    if (!side.enters_by(last)) return std::nullopt;
    return std::min(S(1), entry_time<S>(side));
  }
  std::optional<S> first;
  for (const Vector3<Exact>& from : {question.m, Vector3<Exact>(question.m - question.e)}) {
    const EntryTerms<Exact> ball = entry_terms<Exact>(from, question.w, question.radius_sum);
    if (!ball.enters_by(last)) continue;
    const S t = std::min(S(1), entry_time<S>(ball));
    if (!first || t < *first) first = t;
  }
  return first;
}

/// The same for a segment.
template <std::floating_point S>
std::optional<S> sphere_segment_impact(const Sphere<S>& sphere, const Vector3<S>& displacement,
                                       const Segment<S>& segment) {
  return sphere_capsule_impact(sphere, displacement, segment, S(0));
}
// [/sphere-capsule-impact]

}  // namespace contact
