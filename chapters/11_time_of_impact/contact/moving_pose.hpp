/// @file
/// Bodies that translate and turn at constant rates during a step: their poses at any time, with a
/// bound on the rounding, and bounds on how fast their points move.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/exact_support.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/quaternion.hpp>
#include <contact/support.hpp>
#include <contact/support_bounds.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [turning-motion]
/// The motion of a body in a step: its centre moves in a straight line at a constant speed, and the
/// body turns about it at a constant rate.
///
/// A point x of the body at the start is at c + t d + R(t a)(x − c) at the time t, with the centre
/// c, the displacement d, the rotation vector a and the rotation R(t a) by the angle t |a| about a.
template <FloatOrDouble S>
struct TurningMotion {
  Vector3<S> centre = Vector3<S>::Zero();        ///< about which it turns, at the start, m
  Vector3<S> displacement = Vector3<S>::Zero();  ///< of the centre in the step, m
  Vector3<S> rotation = Vector3<S>::Zero();      ///< axis times angle of the whole step, rad
};
// [/turning-motion]

/// Checks a motion.
/// @param centre m, finite
/// @param displacement m, finite
/// @param rotation axis times angle, rad, finite; more than a full turn is allowed
/// @throws std::invalid_argument naming the argument and its value
template <FloatOrDouble S>
TurningMotion<S> turning_motion(const Vector3<S>& centre, const Vector3<S>& displacement,
                                const Vector3<S>& rotation) {
  require_finite("centre", centre);
  require_finite("displacement", displacement);
  require_finite("rotation", rotation);
  return {centre, displacement, rotation};
}

namespace detail {

/// The same motion in double: no number changes.
template <FloatOrDouble S>
TurningMotion<double> in_double(const TurningMotion<S>& motion) {
  return {motion.centre.template cast<double>(), motion.displacement.template cast<double>(),
          motion.rotation.template cast<double>()};
}

template <FloatOrDouble S>
bool is_finite_motion(const TurningMotion<S>& motion) {
  return all_finite(motion.centre) && all_finite(motion.displacement) &&
         all_finite(motion.rotation);
}

}  // namespace detail

// [moved-body]
/// The body at a time of its step, rounded.
/// @param body at the start, of any kind, finite
/// @param t from 0 to 1
/// @return in double, each of its points is at most pose_error() from where the motion takes it
template <ConvexBody Body>
Body moved_body(const Body& body, const TurningMotion<ScalarOf<Body>>& motion,
                const ScalarOf<Body>& t) {
  using S = ScalarOf<Body>;
  const Matrix3<S> rotation = matrix_of(exponential<S>(motion.rotation * t));
  const Vector3<S> centre = motion.centre + motion.displacement * t;
  const auto position = [&](const Vector3<S>& p) {
    return Vector3<S>(centre + rotation * Vector3<S>(p - motion.centre));
  };
  Body moved = body;
  if constexpr (requires { body.core; }) {
    moved.core = {position(body.core.start), position(body.core.end)};
  } else if constexpr (requires { body.vertices; }) {
    for (Vector3<S>& vertex : moved.vertices) vertex = position(vertex);
  } else if constexpr (requires { body.corner; }) {
    moved.corner = position(body.corner);
    moved.first_edge = rotation * body.first_edge;
    moved.second_edge = rotation * body.second_edge;
  } else if constexpr (requires { body.a; }) {
    moved = {position(body.a), position(body.b), position(body.c)};
  } else {
    moved.centre = position(body.centre);
    if constexpr (requires { body.axes; }) moved.axes = rotation * body.axes;
  }
  return moved;
}
// [/moved-body]

// [turning-radius]
/// At least the largest distance of a point of the body from the centre about which it turns: the
/// distance of the farthest vertex of its core, and its radius.
/// @param body, centre in double
/// @return m; infinite or NaN if it overflows
template <ConvexBody Body>
double turning_radius(const Body& body, const Vector3<double>& centre) {
  double farthest = 0;
  if constexpr (PolytopeCore<Body>) {
    for (int i = 0; i < vertex_count(body); ++i) {
      const Vector3<double> lever = vertex(body, i) - centre;
      farthest = std::max(farthest, support_detail::length(lever));
    }
  } else if constexpr (requires { body.core; }) {
    farthest = std::max(support_detail::length(Vector3<double>(body.core.start - centre)),
                        support_detail::length(Vector3<double>(body.core.end - centre))) +
               body.radius;
  } else {
    farthest = support_detail::length(Vector3<double>(body.centre - centre));
    for (int i = 0; i < 3; ++i) {
      farthest += body.half_lengths(i) * support_detail::length(Vector3<double>(body.axes.col(i)));
    }
  }
  const double numbers = gjk_detail::largest_number(body) + centre.cwiseAbs().maxCoeff();
  return (farthest + radius_of(body)) * (1 + 0x1p-48) +
         (0x1p-46 * numbers + 64 * tolerance::underflow_unit<double>);
}
// [/turning-radius]

// [pose-error]
/// A bound on the distance of each point of moved_body(), in double, from where the motion takes
/// it.
///
/// Let r be turning_radius(), φ = |a| and u the unit roundoff. The half angle is off by at most 3 u
/// φ, its sine and cosine by at most 4 u and u φ more (sine_cosine()), the axis by 8 u: the
/// quaternion by at most (16 + 4 φ) u, so its matrix by (128 + 32 φ) u as an operator, its own
/// roundings included. A lever arm has one rounding and its image three: r times (144 + 32 φ) u.
/// The centre and the last sum add 8 u (|c| + |d| + r). A point of a box or a lozenge is a sum of
/// up to three edges, none longer than 2 r: at most seven times as much. 2^-43 = 1024 u is more
/// than all of these for each unit of r (1 + φ), and 2^-47 = 64 u for each of |c| + |d|.
/// @return m
inline double pose_error(double radius, const TurningMotion<double>& motion) {
  const double angle = support_detail::length(motion.rotation);
  const double path =
      support_detail::length(motion.centre) + support_detail::length(motion.displacement);
  return 0x1p-43 * (radius * (1 + angle)) + 0x1p-47 * path +
         1024 * tolerance::underflow_unit<double>;
}
// [/pose-error]

}  // namespace contact
