/// @file
/// Conservative advancement: rotating bodies are advanced to their impact without passing it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include <contact/box_sweep.hpp>
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plane.hpp>
#include <contact/pose.hpp>
#include <contact/quaternion.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// How a conservative advancement ended.
enum class ConservativeEnd {
  impact,  ///< the bodies are separated by at most the tolerance
  clear,   ///< the end of the step is reached without a touch
  gave_up  ///< too many advances: the bodies do not touch before t, and the rest is unknown
};

/// The result of a conservative advancement.
template <std::floating_point S>
struct ConservativeAdvance {
  ConservativeEnd end = ConservativeEnd::clear;  ///< how it ended
  S t = S(0);         ///< in the unit of the duration; the bodies do not touch before it
  S distance = S(0);  ///< the lower bound on their distance at t, m
  int advances = 0;   ///< number of distance evaluations
};

// [conservative-advancement]
/// Advances two bodies towards each other by steps that cannot reach an impact.
///
/// If the distance of the bodies is at least `distance(t)` at t, and no two of their points
/// approach faster than μ, they cannot touch before t + distance(t) / μ. There the distance is
/// evaluated again. So no impact is passed, however fast the bodies rotate. The price: close
/// to a touch the advances get shorter and shorter, and end at a small distance in place of 0.
/// @param distance distance(t): a lower bound on the distance of the bodies at t, m; defined for
/// all t, at most 0 where they touch
/// @param approach μ, an upper bound on the speed at which any two of their points approach in the
/// step, m for each unit of time, finite and not negative; see approach_bound()
/// @param duration of the step, finite and not negative: 1 for times that are fractions of the
/// step, and then speeds are displacements in the step; or in s, with speeds in m/s
/// @param tolerance m, greater than 0: an impact is where the lower bound is no greater. It must
/// exceed the rounding error of `distance`
/// @param max_advances at least 1
/// @return t is never after the impact, up to the rounding of its sum: each advance is shortened by
/// 4 u of itself, and t is rounded down. In exact arithmetic an advance covers at least tolerance /
/// μ, so with max_advances > μ duration / tolerance the result is never gave_up. It is gave_up if
/// a distance is NaN
/// @throws std::invalid_argument if a number does not satisfy these conditions
///
/// Source: Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, PhD thesis,
/// University of California, Berkeley (1996), section 2.3.
template <std::floating_point S, std::invocable<S> Distance>
ConservativeAdvance<S> conservative_advancement(const Distance& distance, S approach, S duration,
                                                S tolerance, int max_advances) {
  require_finite("approach", approach);
  require_finite("duration", duration);
  require_finite("tolerance", tolerance);
  if (approach < S(0)) throw_invalid_argument("approach", number_text(approach), "is negative");
  if (duration < S(0)) throw_invalid_argument("duration", number_text(duration), "is negative");
  if (!(tolerance > S(0))) {
    throw_invalid_argument("tolerance", number_text(tolerance), "must exceed 0");
  }
  ConservativeAdvance<S> advance;
  // [advance]
  while (advance.advances < max_advances) {
    advance.distance = distance(advance.t);
    ++advance.advances;
    if (std::isnan(advance.distance)) break;
    if (advance.distance <= tolerance) {
      advance.end = ConservativeEnd::impact;
      return advance;
    }
    const S sure = advance.distance * (S(1) - S(4) * tolerance::unit_roundoff<S>);
    if (!(sure < approach * (duration - advance.t))) {
      advance.t = duration;
      advance.end = ConservativeEnd::clear;
      return advance;
    }
    advance.t = std::nextafter(advance.t + sure / approach, S(0));
  }
  // [/advance]
  advance.end = ConservativeEnd::gave_up;
  return advance;
}
// [/conservative-advancement]

/// A box that moves with constant velocity and angular velocity about its centre during a step. The
/// unit of time is that of the step's duration: with a duration of 1 these are a displacement and
/// an angle in the step.
template <std::floating_point S>
struct RotatingBox {
  Vector3<S> position = Vector3<S>::Zero();      ///< of its centre at the start, m
  Quaternion<S> orientation;                     ///< at the start; from the box's axes to the world
  Vector3<S> half_lengths = Vector3<S>::Zero();  ///< m, each greater than 0
  Vector3<S> velocity = Vector3<S>::Zero();      ///< m/s, constant during the step
  Vector3<S> angular_velocity =
      Vector3<S>::Zero();  ///< in the world, rad/s, constant during the step
};

/// Position and orientation of the box at a time.
/// @param t in the unit of the velocities
template <std::floating_point S>
CoordinateFrame<S> frame_at(const RotatingBox<S>& box, S t) {
  const Quaternion<S> rotation = exponential<S>(box.angular_velocity * t);
  return frame_of<S>({box.position + box.velocity * t, normalised(rotation * box.orientation)});
}

// [approach-bound]
/// An upper bound on the speed at which any two points of two boxes approach each other: |v_a −
/// v_b| + |ω_a| r_a + |ω_b| r_b, where r is half the diagonal of a box. Rounded upwards.
/// @return m for each unit of time of the velocities
template <std::floating_point S>
S approach_bound(const RotatingBox<S>& a, const RotatingBox<S>& b) {
  const auto length = [](const Vector3<S>& v) {
    const S largest = v.cwiseAbs().maxCoeff();
    if (!(largest > S(0))) return S(0);
    const Vector3<S> share = v / largest;
    return largest * std::sqrt(share.dot(share));
  };
  const S bound = length(a.velocity - b.velocity) +
                  length(a.angular_velocity) * length(a.half_lengths) +
                  length(b.angular_velocity) * length(b.half_lengths);
  return bound + (tolerance::gamma<S>(32) * bound + S(32) * tolerance::underflow_unit<S>);
}
// [/approach-bound]

// [axis-distance]
/// A lower bound on the distance of two boxes: the largest gap on one of the fifteen axes.
///
/// Two bodies whose projections on a line are a gap apart have at least this distance. It equals
/// the distance where a face is closest to a vertex or an edge to an edge, and is smaller where two
/// vertices, or a vertex and an edge, are closest. It is above 0 if and only if they do not touch,
/// up to rounding; an axis of two nearly parallel edges is left out.
/// @param half_a, half_b half lengths along the boxes' axes, m
/// @return m; negative if the projections overlap on every axis. Error at most 2^-45 of the sum of
/// distance and half diagonals in double
template <std::floating_point S>
S axis_distance(const CoordinateFrame<S>& a, const Vector3<S>& half_a, const CoordinateFrame<S>& b,
                const Vector3<S>& half_b) {
  const Vector3<S> d = b.origin - a.origin;
  S widest = -std::numeric_limits<S>::infinity();
  const auto try_axis = [&](const Vector3<S>& axis) {
    const S square = axis.dot(axis);
    if (!(square > S(0x1p-20))) return;
    S radius_sum(0);
    for (int k = 0; k < 3; ++k) {
      radius_sum += std::abs(axis.dot(a.axes.col(k))) * half_a(k);
      radius_sum += std::abs(axis.dot(b.axes.col(k))) * half_b(k);
    }
    widest = std::max(widest, (std::abs(axis.dot(d)) - radius_sum) / std::sqrt(square));
  };
  for (int k = 0; k < 3; ++k) {
    try_axis(a.axes.col(k));
    try_axis(b.axes.col(k));
    for (int j = 0; j < 3; ++j) try_axis(Vector3<S>(a.axes.col(k)).cross(b.axes.col(j)));
  }
  return widest;
}
// [/axis-distance]

// [turning-boxes-impact]
/// The time at which two boxes with constant velocities and angular velocities first come within
/// the tolerance of each other.
/// @param a, b with orthonormal axes and positive half lengths
/// @param duration of the step, in the unit of time of the velocities
/// @param tolerance m, well above 2^-45 of the boxes' sizes and distance
/// @param max_advances at least 1
/// @return see ConservativeAdvance. If two edges stay parallel to 2^-10 while their axis is the
/// only one that separates the boxes, the impact may be reported too early, never too late
template <std::floating_point S>
ConservativeAdvance<S> rotating_boxes_impact(const RotatingBox<S>& a, const RotatingBox<S>& b,
                                             S duration, S tolerance, int max_advances) {
  const auto distance = [&](S t) {
    return axis_distance<S>(frame_at(a, t), a.half_lengths, frame_at(b, t), b.half_lengths);
  };
  return conservative_advancement<S>(distance, approach_bound(a, b), duration, tolerance,
                                     max_advances);
}
// [/turning-boxes-impact]

// [turning-box-plane]
/// The time at which a box with constant velocity and angular velocity first comes within the
/// tolerance of a plane.
///
/// Its distance from the plane has a closed form: that of the centre less the support of the half
/// lengths along the normal, n·c − k − Σ hⱼ |n·axisⱼ|.
/// @param plane with a unit normal; the half-space behind it is solid
/// @param duration of the step, in the unit of time of the velocities
/// @param tolerance m
/// @param max_advances at least 1
template <std::floating_point S>
ConservativeAdvance<S> rotating_box_plane_impact(const RotatingBox<S>& box, const Plane<S>& plane,
                                                 S duration, S tolerance, int max_advances) {
  const auto distance = [&](S t) {
    const CoordinateFrame<S> frame = frame_at(box, t);
    S gap = signed_distance(plane, frame.origin);
    for (int k = 0; k < 3; ++k)
      gap -= std::abs(plane.normal.dot(frame.axes.col(k))) * box.half_lengths(k);
    return gap;
  };
  RotatingBox<S> at_rest;  // the plane
  return conservative_advancement<S>(distance, approach_bound(box, at_rest), duration, tolerance,
                                     max_advances);
}
// [/turning-box-plane]

}  // namespace contact
