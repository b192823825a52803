/// @file
/// A moving sphere against a plane at rest, as its centre against the plane moved by the radius:
/// decided exactly.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The distance of the centre from the plane at the start, and its change in the step: both times
/// |normal|, which is 1 up to rounding.
template <class T>
struct PlaneMotion {
  T distance;
  T change;
  T radius;
};

template <class T, FloatOrDouble S>
PlaneMotion<T> plane_motion(const Sphere<S>& sphere, const Vector3<S>& displacement,
                            const Plane<S>& plane) {
  const auto n = triple<T>(plane.normal.template cast<double>());
  return {dot(n, triple<T>(sphere.centre.template cast<double>())) - T(double(plane.offset)),
          dot(n, triple<T>(displacement.template cast<double>())), T(double(sphere.radius))};
}

/// How a sphere moves towards the side of the plane on which it starts.
template <class T>
struct OffsetPlane {
  bool front;  ///< whether the centre starts in front of the plane
  T gap;       ///< of the centre from the offset plane at the start
  T closing;   ///< by how much the gap shrinks in the step
};

// [offset-plane]
/// The offset plane of the side on which the centre starts; `sure` becomes false if that side is
/// not certain. A centre on the plane counts as in front unless it moves to the front: then the
/// motion is against the normal, or along the plane.
template <class T>
OffsetPlane<T> offset_plane(const PlaneMotion<T>& motion, bool& sure) {
  // [offset-of-side]
  const int side = sign_of(motion.distance, sure);
  const bool front = side > 0 || (side == 0 && sign_of(motion.change, sure) <= 0);
  return {front, (front ? motion.distance : -motion.distance) - motion.radius,
          front ? -motion.change : motion.change};
  // [/offset-of-side]
}

/// −1: no touch in the step; 0: it meets the plane at the start; 1: a touch later.
template <class T>
int touches_offset_plane(const OffsetPlane<T>& plane, bool& sure) {
  if (sign_of(plane.gap, sure) <= 0) return 0;
  return sign_of(plane.closing - plane.gap, sure) >= 0 ? 1 : -1;
}
// [/offset-plane]

}  // namespace detail

/// When and where a moving sphere first touches a plane, which it can do from either side.
///
/// At the first touch the distance of the centre from the plane is r: the centre is on the plane
/// moved by r towards the side on which it starts. Let d be its distance from the plane at the
/// start with the sign s, n the normal and D the displacement. The gap s d − r closes by −s n · D
/// in the step, so t is their quotient; a distance and a displacement give a fraction of the step,
/// multiplied by the step's duration it is a time. The collision point of the centre, start + D t,
/// is on the offset plane; that of the surface is r further, against the normal.
///
/// The signs of d, of the gap and of closing − gap decide. Each is computed with a bound on its
/// error, and where one is not certain all are computed without rounding. So for the stored
/// numbers no touch is missed and none is invented. There n · c − k counts as the distance of the
/// centre: a stored normal has the length 1 up to rounding only, so a sphere that is farther or
/// closer by that may get another answer than from translating_impact(), which takes the length
/// into account.
/// @param sphere at the start, m, with a radius that is not negative
/// @param displacement of its centre in the step, m
/// @param plane with a unit normal; infinite and of no thickness
/// @return the first touch with t from 0 to 1: 0 if the sphere meets the plane at the start,
/// whatever its displacement. The normal leads from the plane to the centre; if that starts on the
/// plane, it is the one opposed to the motion, or the plane's own if the motion is along it. t is
/// off by at most 32 u of itself, or the smallest number; the centre by that and two roundings for
/// each coordinate, and infinite where it overflows. Nothing if there is no touch or a number is
/// not finite. No number is −0
/// @see *Fundamentals of Computer Animation*, slides "Exact Collision Time", which calls a time a
/// fraction and has 0/0 at rest, and "The Collision Point"
template <FloatOrDouble S>
std::optional<MovingSphereHit<S>> sphere_plane_impact(const Sphere<S>& sphere,
                                                      const Vector3<S>& displacement,
                                                      const Plane<S>& plane) {
  if (!all_finite(sphere.centre) || !all_finite(displacement) || !all_finite(plane.normal) ||
      !std::isfinite(sphere.radius) || !std::isfinite(plane.offset)) {
    return std::nullopt;
  }
  bool sure = true;
  const auto rounded =
      detail::offset_plane(detail::plane_motion<RunningError>(sphere, displacement, plane), sure);
  int touch = detail::touches_offset_plane(rounded, sure);
  bool front = rounded.front;
  S t(0);
  const RunningError quotient_bounded = rounded.gap / rounded.closing;
  const bool accurate =
      quotient_bounded.bound <= 30 * tolerance::unit_roundoff<S> * std::abs(quotient_bounded.value);
  if (sure && (touch <= 0 || accurate)) {
    t = touch > 0 ? static_cast<S>(quotient_bounded.value) : S(0);
  } else {
    bool certain = true;
    const auto exact =
        detail::offset_plane(detail::plane_motion<Exact>(sphere, displacement, plane), certain);
    touch = detail::touches_offset_plane(exact, certain);
    front = exact.front;
    if (touch > 0) t = quotient<S>(exact.gap, exact.closing);
  }
  if (touch < 0) return std::nullopt;
  t = std::min(t, S(1));
  const Vector3<S> zero = Vector3<S>::Zero();
  const Vector3<S> normal =
      front ? Vector3<S>(plane.normal + zero) : Vector3<S>(zero - plane.normal);
  const Vector3<S> centre = sphere.centre + t * displacement + zero;
  // A sphere that meets the plane at the start touches it at the foot of the perpendicular.
  const S along =
      touch > 0 ? sphere.radius : S(front ? S(1) : S(-1)) * signed_distance(plane, sphere.centre);
  return MovingSphereHit<S>{t, centre, Vector3<S>(centre - along * normal + zero), normal};
}

}  // namespace contact
