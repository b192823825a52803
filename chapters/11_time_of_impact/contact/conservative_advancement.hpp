/// @file
/// Turning bodies: advancing to their impact without ever passing it.
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
#include <contact/rotation.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// How an advance ended.
enum class ConservativeEnd {
  impact,  ///< the bodies are apart, and no further than the tolerance
  clear,   ///< the step is over, and they never touched
  gave_up  ///< too many advances: they are apart until t, and what comes after is not known
};

/// Where an advance ended.
template <std::floating_point S>
struct ConservativeAdvance {
  ConservativeEnd end = ConservativeEnd::clear;  ///< why
  S t = S(0);                                    ///< s; the bodies do not touch before it
  S distance = S(0);                             ///< the lower bound on their distance at t, m
  int advances = 0;                              ///< how often the distance was asked for
};

// [conservative-advancement]
/// Advances two bodies towards each other by steps that cannot reach an impact.
///
/// If the bodies are at least `distance(t)` apart at t, and no two points of them approach faster
/// than μ, they cannot touch before t + distance(t) / μ. There the distance is asked for again. So
/// no impact is passed, however fast the bodies turn; the price is that the last bit of the way is
/// covered ever more slowly, and ends at a distance that is small instead of 0.
/// @param distance distance(t): a lower bound on the distance of the bodies at t, m; total, at most
/// 0 where they touch
/// @param approach μ, an upper bound on the speed at which any two of their points approach in the
/// step, m/s, finite and not negative; see approach_bound()
/// @param duration of the step, s, finite and not negative
/// @param tolerance m, greater than 0: an impact is where the lower bound is no greater. It must
/// exceed the rounding error of `distance`
/// @param most_advances at least 1
/// @return t is never later than the impact, but for the rounding of its sum: each advance is made
/// shorter by 4 u of itself, and t is rounded down. In exact arithmetic an advance covers at least
/// tolerance / μ, so with most_advances > μ duration / tolerance it does not give up
/// @throws std::invalid_argument if a number is not as said
///
/// Source: Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, PhD thesis,
/// University of California, Berkeley (1996), section 2.3.
template <std::floating_point S, std::invocable<S> Distance>
ConservativeAdvance<S> conservative_advancement(const Distance& distance, S approach, S duration,
                                                S tolerance, int most_advances) {
  require_finite("approach", approach);
  require_finite("duration", duration);
  require_finite("tolerance", tolerance);
  if (approach < S(0)) throw_invalid_argument("approach", number_text(approach), "is negative");
  if (duration < S(0)) throw_invalid_argument("duration", number_text(duration), "is negative");
  if (!(tolerance > S(0))) {
    throw_invalid_argument("tolerance", number_text(tolerance), "must exceed 0");
  }
  ConservativeAdvance<S> advance;
  while (advance.advances < most_advances) {
    advance.distance = distance(advance.t);
    ++advance.advances;
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
  advance.end = ConservativeEnd::gave_up;
  return advance;
}
// [/conservative-advancement]

/// A body that moves and turns evenly during a step: a box about its centre.
template <std::floating_point S>
struct TurningBox {
  Vector3<S> half_lengths = Vector3<S>::Zero();  ///< m, each greater than 0
  Vector3<S> position = Vector3<S>::Zero();      ///< of its centre at the start, m
  Rotor<S> orientation;                          ///< at the start; turns its axes into the world's
  Vector3<S> velocity = Vector3<S>::Zero();      ///< m/s, the same all through the step
  Vector3<S> spin = Vector3<S>::Zero();          ///< in the world, rad/s, the same all through
};

/// Where the box is and how it lies at a time.
/// @param t s
template <std::floating_point S>
CoordinateFrame<S> frame_at(const TurningBox<S>& box, S t) {
  CoordinateFrame<S> frame;
  frame.origin = box.position + box.velocity * t;
  frame.axes = matrix_of(normalised(exponential_step<S>(box.orientation, box.spin, t)));
  return frame;
}

// [approach-bound]
/// An upper bound on how fast any two points of two boxes approach each other: |v_a − v_b| + |ω_a|
/// r_a + |ω_b| r_b, with r half a box's diagonal. Rounded upwards.
/// @return m/s
template <std::floating_point S>
S approach_bound(const TurningBox<S>& a, const TurningBox<S>& b) {
  const auto length = [](const Vector3<S>& v) {
    const S largest = v.cwiseAbs().maxCoeff();
    if (!(largest > S(0))) return S(0);
    const Vector3<S> share = v / largest;
    return largest * std::sqrt(share.dot(share));
  };
  const S bound = length(a.velocity - b.velocity) + length(a.spin) * length(a.half_lengths) +
                  length(b.spin) * length(b.half_lengths);
  return bound + (tolerance::gamma<S>(32) * bound + S(32) * tolerance::underflow_unit<S>);
}
// [/approach-bound]

// [axis-distance]
/// A lower bound on the distance of two boxes: the widest gap on one of the fifteen axes.
///
/// Between two bodies whose shadows on a line are a gap apart, no two points are nearer. It is the
/// distance itself where a face is nearest to a vertex or an edge to an edge, and less where two
/// vertices, or a vertex and an edge, are. It is above 0 if and only if they do not touch, to
/// rounding; an axis of two nearly parallel edges is left out.
/// @param half_a, half_b half lengths along the boxes' axes, m
/// @return m; negative where they overlap on every axis. Off by at most 2^-45 of the sum of
/// distance and half diagonals in double
template <std::floating_point S>
S axis_distance(const CoordinateFrame<S>& a, const Vector3<S>& half_a, const CoordinateFrame<S>& b,
                const Vector3<S>& half_b) {
  const Vector3<S> d = b.origin - a.origin;
  S widest = -std::numeric_limits<S>::infinity();
  const auto try_axis = [&](const Vector3<S>& axis) {
    const S square = axis.dot(axis);
    if (!(square > S(0x1p-20))) return;
    S reach(0);
    for (int k = 0; k < 3; ++k) {
      reach += std::abs(axis.dot(a.axes.col(k))) * half_a(k);
      reach += std::abs(axis.dot(b.axes.col(k))) * half_b(k);
    }
    widest = std::max(widest, (std::abs(axis.dot(d)) - reach) / std::sqrt(square));
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
/// When two boxes that move and turn evenly first come within the tolerance of each other.
/// @param a, b with axes and half lengths as said
/// @param duration of the step, s
/// @param tolerance m, well above 2^-45 of the boxes' sizes and distance
/// @param most_advances at least 1
/// @return see ConservativeAdvance. If two edges stay parallel to 2^-10 while their axis is the
/// only one that separates the boxes, the impact may be reported too early, never too late
template <std::floating_point S>
ConservativeAdvance<S> turning_boxes_impact(const TurningBox<S>& a, const TurningBox<S>& b,
                                            S duration, S tolerance, int most_advances) {
  const auto distance = [&](S t) {
    return axis_distance<S>(frame_at(a, t), a.half_lengths, frame_at(b, t), b.half_lengths);
  };
  return conservative_advancement<S>(distance, approach_bound(a, b), duration, tolerance,
                                     most_advances);
}
// [/turning-boxes-impact]

// [turning-box-plane]
/// When a box that moves and turns evenly first comes within the tolerance of a plane's front.
///
/// Its distance from the plane is exact in formula: that of the centre, less the half lengths as
/// the normal sees them, n·c − k − Σ hⱼ |n·axisⱼ|.
/// @param plane with a unit normal; its back is full
/// @param duration of the step, s
/// @param tolerance m
/// @param most_advances at least 1
template <std::floating_point S>
ConservativeAdvance<S> turning_box_plane_impact(const TurningBox<S>& box, const Plane<S>& plane,
                                                S duration, S tolerance, int most_advances) {
  const auto distance = [&](S t) {
    const CoordinateFrame<S> frame = frame_at(box, t);
    S gap = signed_distance(plane, frame.origin);
    for (int k = 0; k < 3; ++k)
      gap -= std::abs(plane.normal.dot(frame.axes.col(k))) * box.half_lengths(k);
    return gap;
  };
  TurningBox<S> at_rest;  // the plane
  return conservative_advancement<S>(distance, approach_bound(box, at_rest), duration, tolerance,
                                     most_advances);
}
// [/turning-box-plane]

}  // namespace contact
