/// @file
/// Turning convex bodies of any kind: the time of impact by conservative advancement from plane to
/// plane, never after the touch.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <contact/conservative_advancement.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/gjk.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/moving_pose.hpp>
#include <contact/outward.hpp>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <contact/support_bounds.hpp>
#include <contact/vector.hpp>

namespace contact {

// [turning-impact]
/// When two turning bodies come close to each other in a step.
template <FloatOrDouble S>
struct TurningImpact {
  /// impact: at t they are certainly no farther apart than the tolerance and the rounding, or this
  /// cannot be excluded; clear: they do not touch in the step; gave_up: too many advances.
  ConservativeEnd end = ConservativeEnd::gave_up;
  S t = S(0);  ///< fraction of the step; the bodies do not touch before it
  /// A lower bound on their distance, m, in double at t; in float at a time from t to the next
  /// number, because t is rounded towards the start. 0 for clear and gave_up.
  S distance = S(0);
  /// Unit vector from B to A: of the plane that last separated them; 0 if none did.
  Vector3<S> normal = Vector3<S>::Zero();
  int advances = 0;  ///< number of poses at which the bodies were measured
};
// [/turning-impact]

namespace detail {

/// A turning body in double, and what bounds the motion of its points.
template <ConvexBody Body>
struct TurningBody {
  Body start;
  TurningMotion<double> motion;
  double radius = 0;  // turning_radius()
  double error = 0;   // pose_error()

  TurningBody(const Body& body, const TurningMotion<double>& given)
      : start(body),
        motion(given),
        radius(turning_radius(body, given.centre)),
        error(pose_error(radius, given)) {}
  Body at(double t) const { return moved_body(start, motion, t); }
  bool usable() const {
    return is_convex_body(start) && is_finite_motion(motion) && std::isfinite(radius) &&
           std::isfinite(error);
  }
};

/// How the largest height of a body along a direction can grow after a time t: at most max (height
/// + rate s) + bend s²/2, and at most the support + speed s.
struct GrowingHeight {
  std::vector<double> height;  ///< of the vertices of the core, with the radius and the error
  std::vector<double> rate;    ///< of each, for the whole step
  double bend = 0;             ///< bound of the acceleration of a vertex
  double support = 0;          ///< upper bound at t
  double speed = 0;            ///< bound of the velocity of a point of the body

  double after(double s) const {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < height.size(); ++i) {
      largest = std::max(largest, height[i] + rate[i] * s);
    }
    return largest;
  }
};

// [growing-height]
/// The bounds of a turning body along a direction.
///
/// A point with the lever arm l has the velocity d + a × l, so along n it moves at n · d + n · (a ×
/// l), which is at most n · d + |n × a| r; and its acceleration a × (a × l) has at most the
/// component |n × a| |a| r along n. Taylor's theorem gives both bounds of GrowingHeight. For cores
/// without a radius or with one, the vertices are enough: the height of the core is the largest of
/// theirs, and the ball about each moves with it.
///
/// Roundings: heights include the error of the pose, and 2^-48 of the magnitudes of all terms is
/// above those of heights, rates and of the sums here and in advance_along(), which are fewer than
/// 16.
/// @param body at the time t
/// @param n of a length from 1/2 to 2
template <ConvexBody Body>
void grow_along(const TurningBody<Body>& turning, const Body& body, double t,
                const Vector3<double>& n, GrowingHeight& bound) {
  const TurningMotion<double>& motion = turning.motion;
  const Vector3<double> centre = motion.centre + motion.displacement * t;
  const Vector3<double> across = n.cross(motion.rotation);
  const double angle = support_detail::length(motion.rotation);
  const double r = turning.radius + turning.error;
  const double turn = (support_detail::length(across) + 0x1p-50 * angle) * (1 + 0x1p-48);
  const double along = dot3(n, motion.displacement);
  const double rounding = 0x1p-48 * (support_detail::length(motion.displacement) + angle * r) +
                          2 * angle * turning.error;
  bound.bend = turn * angle * r * (1 + 0x1p-48);
  bound.speed = along + turn * r * (1 + 0x1p-48) + rounding;
  bound.support = support_up(body, n) + 2 * turning.error;
  bound.height.clear();
  bound.rate.clear();
  if constexpr (PolytopeCore<Body>) {
    const double size = 3 * gjk_detail::largest_number(body) + radius_of(body);
    const double room = radius_of(body) * support_detail::length(n) + 2 * turning.error +
                        0x1p-46 * size + 64 * tolerance::underflow_unit<double>;
    for (int i = 0; i < vertex_count(body); ++i) {
      const Vector3<double> p = vertex(body, i);
      // n · (a × l) = l · (n × a)
      const double rate = along + dot3<double>(Vector3<double>(p - centre), across);
      bound.height.push_back(dot3(n, p) + room);
      bound.rate.push_back(rate + rounding);
    }
  }
}
// [/growing-height]

// [advance-along]
/// How long after t the plane perpendicular to n certainly separates two bodies.
///
/// −(height of A along −n) − (height of B along n) is at least F(s) = −max(…) − max(…) − bend s²/2,
/// a concave function. Where it is above 0 at 0 and at s, it is so between; so any s with F(s) > 0
/// is proved, and the chord from a proved s to one with F ≤ 0 leads to the next (regula falsi). The
/// linear bound, support and speed, is better for long times.
/// @param front of A along −n
/// @param back of B along n
/// @param rest of the step
/// @return from 0 to rest; rest: until the end of the step
inline double advance_along(const GrowingHeight& front, const GrowingHeight& back, double rest) {
  const double speed = front.speed + back.speed;
  const double apart = -(front.support + back.support);
  if (!(apart > 0)) return 0;
  if (!(speed > 0) || apart > speed * rest * (1 + 0x1p-48)) return rest;
  const double linear = apart / speed * (1 - 0x1p-48);
  if (front.height.empty() || back.height.empty()) return linear;
  const double bend = (front.bend + back.bend) / 2 * (1 + 0x1p-48);
  const auto separation = [&](double s) {
    return -(front.after(s) + back.after(s)) - bend * s * s;
  };
  double low = 0, high = rest, at_low = separation(0), at_high = separation(rest);
  if (!(at_low > 0)) return linear;
  if (at_high > 0) return rest;
  for (int k = 0; k < 8; ++k) {
    double s = low + (high - low) * (at_low / (at_low - at_high));
    if (k % 2 == 1) s += s - low;  // beyond the root, so that the chord becomes steeper
    if (!(low < s && s < high)) break;
    const double value = separation(s);
    (value > 0 ? low : high) = s;
    (value > 0 ? at_low : at_high) = value;
  }
  return std::max(low, linear);
}
// [/advance-along]

/// The direction of the largest gap of two boxes on the axes that are normals of faces or
/// perpendicular to two edges, of length 1 up to rounding; 0 if there is no gap.
inline Vector3<double> gap_direction(const OrientedBox<double>& a, const OrientedBox<double>& b) {
  const Vector3<double> d = a.centre - b.centre;
  double widest = 0;
  Vector3<double> best = Vector3<double>::Zero();
  const auto try_axis = [&](const Vector3<double>& axis) {
    const double square = dot3(axis, axis);
    if (!(square > 0x1p-20)) return;
    double radius_sum = 0;
    for (int k = 0; k < 3; ++k) {
      radius_sum += std::abs(dot3<double>(axis, a.axes.col(k))) * a.half_lengths(k);
      radius_sum += std::abs(dot3<double>(axis, b.axes.col(k))) * b.half_lengths(k);
    }
    const double along = dot3(axis, d), gap = std::abs(along) - radius_sum;
    if (!(gap > 0) || gap * gap <= widest * square) return;
    widest = gap * gap / square;
    best = axis * ((along < 0 ? -1 : 1) / std::sqrt(square));
  };
  for (int k = 0; k < 3; ++k) {
    try_axis(a.axes.col(k));
    try_axis(b.axes.col(k));
    for (int j = 0; j < 3; ++j) {
      try_axis(Vector3<double>(a.axes.col(k)).cross(Vector3<double>(b.axes.col(j))));
    }
  }
  return best;
}

/// A direction of the shortest difference of two bodies, of length 1 up to rounding, by GJK; 0 if
/// it finds none that is longer than the tolerance.
template <ConvexBody A, ConvexBody B>
Vector3<double> gjk_direction(const A& a, const B& b, double tolerance, GjkStart<double>& start) {
  const GjkResult<double> near = gjk(a, b, start);
  start = start_from(near);
  const double distance = near.distance - (radius_of(a) + radius_of(b));
  if (!(distance > tolerance)) return Vector3<double>::Zero();
  return near.between / support_detail::length(near.between);
}

template <FloatOrDouble S>
void require_advances(const S& tolerance, int max_advances) {
  require_finite("tolerance", tolerance);
  if (!(tolerance > S(0))) {
    throw_invalid_argument("tolerance", number_text(tolerance), "must exceed 0");
  }
  if (max_advances < 1) {
    throw_invalid_argument("max_advances", std::to_string(max_advances), "must be at least 1");
  }
}

/// The largest number of a type that is at most x.
template <FloatOrDouble S>
S rounded_towards_start(double x) {
  const S near = static_cast<S>(x);
  return double(near) <= x ? near : std::nextafter(near, -std::numeric_limits<S>::infinity());
}

/// Advances until the separation along the direction of `measure` is at most the tolerance.
/// @param measure measure(t, front, back) sets the bounds at t and returns the direction; 0 if the
/// bodies are not apart
template <FloatOrDouble S, class Measure>
TurningImpact<S> advance_turning(const Measure& measure, S tolerance, int max_advances) {
  TurningImpact<S> found;
  GrowingHeight front, back;
  double t = 0;
  while (found.advances < max_advances) {
    const Vector3<double> n = measure(t, front, back);
    ++found.advances;
    found.t = rounded_towards_start<S>(t);
    const bool apart = n != Vector3<double>::Zero();
    const double separation = apart ? -sum_up(front.support, back.support) : 0;
    found.distance = rounded_towards_start<S>(std::max(separation * (1 - 0x1p-50), 0.0));
    if (apart && separation > 0) found.normal = n.template cast<S>() + Vector3<S>::Zero();
    if (!(separation > double(tolerance))) {
      found.end = ConservativeEnd::impact;
      return found;
    }
    const double advance = advance_along(front, back, sum_up(1.0, -t));
    t = sum_down(t, advance);
    if (!(t < 1)) {
      found.end = ConservativeEnd::clear;
      found.t = S(1);
      found.distance = S(0);
      return found;
    }
  }
  found.t = rounded_towards_start<S>(t);
  found.distance = S(0);
  return found;
}

}  // namespace detail

// [turning-bodies-impact]
/// The time at which two bodies that translate and turn first come within the tolerance of each
/// other.
///
/// Conservative advancement: at each time a plane between the bodies is found, and it separates
/// them until the next time, whatever their points do within their velocities and accelerations.
/// The planes prove that the bodies do not touch before t, for the stored numbers and in spite of
/// all rounding: the bounds contain it. The impact is at the distance `tolerance` or below, so t is
/// before the touch by as long as the bodies need for this distance; if they only pass at such a
/// distance, it is a false alarm.
///
/// An advance covers at least the tolerance divided by the speed of approach, at most |d_a − d_b| +
/// |a_a| r_a + |a_b| r_b for the step. So in exact arithmetic it never gives up with max_advances
/// above that, divided by the tolerance; bounds of the rounding make advances a little shorter.
/// @param a, b at the start, of any kinds, with coordinates from 1e-150 to 1e150 in double
/// @param motion_a, motion_b in the step
/// @param tolerance m, greater than 0; in double at least 2^-40 of the coordinates and paths, else
/// rounding ends the advances earlier
/// @param max_advances at least 1
/// @return impact at 0 for bodies that touch or overlap at the start, also if they separate;
/// gave_up at 0 if a number is not finite, or a body has no points
/// @throws std::invalid_argument if tolerance or max_advances does not satisfy these conditions
///
/// Source: Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*, PhD thesis,
/// University of California, Berkeley (1996), section 2.3; the bound along the normal is that of
/// Zhang, Lee and Kim, *Interactive Continuous Collision Detection for Non-Convex Polyhedra*, The
/// Visual Computer 22 (2006), with a second-order term.
template <ConvexBody A, ConvexBody B>
requires std::same_as<ScalarOf<A>, ScalarOf<B>> TurningImpact<ScalarOf<A>> turning_impact(
    const A& a, const TurningMotion<ScalarOf<A>>& motion_a, const B& b,
    const TurningMotion<ScalarOf<B>>& motion_b, ScalarOf<A> tolerance, int max_advances = 256) {
  using S = ScalarOf<A>;
  detail::require_advances(tolerance, max_advances);
  const auto& first = detail::as_double(a);
  const auto& second = detail::as_double(b);
  const detail::TurningBody turning_a(first, detail::in_double(motion_a));
  const detail::TurningBody turning_b(second, detail::in_double(motion_b));
  if (!turning_a.usable() || !turning_b.usable()) return {};
  GjkStart<double> start;
  const auto measure = [&](double t, detail::GrowingHeight& front, detail::GrowingHeight& back) {
    const auto now_a = turning_a.at(t);
    const auto now_b = turning_b.at(t);
    Vector3<double> last = Vector3<double>::Zero();
    const auto separates_along = [&](const Vector3<double>& n) {
      if (n == Vector3<double>::Zero()) return false;
      last = n;
      detail::grow_along(turning_a, now_a, t, Vector3<double>(-n), front);
      detail::grow_along(turning_b, now_b, t, n, back);
      return -(front.support + back.support) > double(tolerance);
    };
    // The first direction with a proved separation is as good as the best one.
    if constexpr (std::same_as<decltype(now_a), decltype(now_b)> &&
                  std::same_as<decltype(now_a), const OrientedBox<double>>) {
      if (separates_along(detail::gap_direction(now_a, now_b))) return last;
    }
    const Vector3<double> n = detail::gjk_direction(now_a, now_b, double(tolerance), start);
    if (n == Vector3<double>::Zero() || separates_along(n)) return last;
    const SignedDistance<double> gap = signed_distance(now_a, now_b);
    if (gap.distance > double(tolerance)) separates_along(gap.normal);
    return last;
  };
  return detail::advance_turning<S>(measure, tolerance, max_advances);
}
// [/turning-bodies-impact]

// [turning-body-plane]
/// The same for a turning body and a half-space at rest: its boundary is the only plane that is
/// needed.
/// @param b with a unit normal
/// @return gave_up at 0 also if a number of b is not finite, or its normal is 0
template <ConvexBody A>
TurningImpact<ScalarOf<A>> turning_impact(const A& a, const TurningMotion<ScalarOf<A>>& motion_a,
                                          const HalfSpace<ScalarOf<A>>& b, ScalarOf<A> tolerance,
                                          int max_advances = 256) {
  using S = ScalarOf<A>;
  detail::require_advances(tolerance, max_advances);
  const auto& first = detail::as_double(a);
  const detail::TurningBody turning(first, detail::in_double(motion_a));
  const Vector3<double> n = b.boundary.normal.template cast<double>();
  if (!turning.usable() || !all_finite(n) || n == Vector3<double>::Zero() ||
      !std::isfinite(b.boundary.offset)) {
    return {};
  }
  const auto measure = [&](double t, detail::GrowingHeight& front, detail::GrowingHeight& back) {
    detail::grow_along(turning, turning.at(t), t, Vector3<double>(-n), front);
    back.support = double(b.boundary.offset);
    back.height = {back.support};
    back.rate = {0.0};
    return n;
  };
  return detail::advance_turning<S>(measure, tolerance, max_advances);
}
// [/turning-body-plane]

}  // namespace contact
