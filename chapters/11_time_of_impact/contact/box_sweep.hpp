/// @file
/// Translating boxes: the time at which they first touch, by swept separating axes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

#include <contact/aabb.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/quick_sweep.hpp>
#include <contact/tolerance.hpp>
#include <contact/translating_boxes.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

// [swept-filter]
/// The result of the sweep in floating point.
struct RoundedSweep {
  enum class Answer { miss, hit, unsure } answer = Answer::unsure;
  double t = 0;                ///< if they hit
  double error = 0;            ///< upper bound of the error of t
  std::size_t axis = 0;        ///< on which the overlap begins last
  bool sure_of_start = false;  ///< whether it is certain that they meet at the start, or do not
};

/// The sweep in floating point, with the error bounds of bounded_times().
inline RoundedSweep rounded_sweep(const SweptPair<double>& pair) {
  constexpr double slack = tolerance::gamma<double>(20);
  RoundedSweep sweep;
  if (!in_filter_range(pair)) return sweep;

  const std::array<Vector3<double>, 15> axes = separating_axes(pair.u, pair.v);
  double begin_low = 0;  // the last beginning and the first end, each with two bounds
  double begin_high = 0;
  double end_low = 1;
  double end_high = 1;
  double begin = 0;
  bool unsure = false;
  for (std::size_t k = 0; k < 15; ++k) {
    if (k >= 6 && pair.parallel[k - 6]) continue;  // the axis is 0 and separates nothing
    const BoundedTimes on = bounded_times(pair, axes[k], k);
    const AxisTimes<double>& times = on.times;
    const double speed = std::abs(times.speed);
    const double nearest = std::abs(times.distance) - speed;
    const double farthest = std::abs(times.distance) + speed;
    const double doubt = 2 * (on.off + on.off_speed) + slack * (farthest + times.radius_sum);
    if (nearest > times.radius_sum + doubt) return {RoundedSweep::Answer::miss, 0, 0, k, true};
    if (farthest < times.radius_sum - doubt) continue;  // overlap on this axis at all times
    if (!(speed > 4 * on.off_speed)) {
      unsure = true;  // another axis may still prove that they are separated
      continue;
    }
    const double first = times.begins() / speed;
    const double last = times.ends() / speed;
    const double off_first = quotient_error(on, first);
    const double off_last = quotient_error(on, last);
    if (first > begin) {
      begin = first;
      sweep.axis = k;
      sweep.error = off_first;
    }
    begin_low = std::max(begin_low, first - off_first);
    begin_high = std::max(begin_high, first + off_first);
    end_low = std::min(end_low, last - off_last);
    end_high = std::min(end_high, last + off_last);
  }
  sweep.t = begin;
  sweep.error = std::max(begin_high - begin, begin - begin_low);
  sweep.sure_of_start = begin_low > 0 || begin_high == 0;
  if (begin_low > end_high) {
    sweep.answer = RoundedSweep::Answer::miss;
  } else if (!unsure && begin_high <= end_low) {
    sweep.answer = RoundedSweep::Answer::hit;
  }
  return sweep;
}
// [/swept-filter]

/// A fraction with a positive denominator, compared without a division.
struct SweepTime {
  Exact numerator;
  Exact denominator;
  bool before(const SweepTime& other) const {
    return numerator * other.denominator < other.numerator * denominator;
  }
};

/// The exact result: the time, and the index of the axis in separating_axes(); 15 for none.
struct ExactSweep {
  SweepTime t;
  std::size_t axis;
};

// [swept-exact]
/// The exact sweep: the boxes overlap from the last beginning to the first end, over the fifteen
/// axes and the step.
inline std::optional<ExactSweep> exact_sweep(const SweptPair<Exact>& pair) {
  ExactSweep begin{{Exact(), Exact(1.0)}, 15};
  SweepTime end{Exact(1.0), Exact(1.0)};
  const std::array<Vector3<Exact>, 15> axes = separating_axes(pair.u, pair.v);
  for (std::size_t k = 0; k < 15; ++k) {
    const AxisTimes<Exact> times = pair.times(axes[k]);
    const Exact speed = abs(times.speed);
    if (speed.sign() == 0) {
      if (times.radius_sum < abs(times.distance)) return std::nullopt;
      continue;
    }
    const SweepTime first{times.begins(), speed};
    const SweepTime last{times.ends(), speed};
    if (begin.t.before(first)) begin = {first, k};
    if (last.before(end)) end = last;
    if (end.before(begin.t)) return std::nullopt;
  }
  return begin;
}
// [/swept-exact]

}  // namespace detail

// [box-impact]
/// The time at which two translating boxes first touch in a step.
///
/// Only the relative motion matters. On each of the fifteen axes the projections overlap during an
/// interval; the boxes overlap when all projections do, so from the last beginning on, if no end
/// comes before it. Floating-point arithmetic with error bounds decides where it is certain, exact
/// arithmetic otherwise: no touch is missed, and none is invented.
/// @param a, b made by translating_box(); touching counts, also for an instant and along a face
/// @return the first touch, t = 0 if they meet at the start; nothing if they do not touch in the
/// step. The decision is right for every finite input; the error of t is at most 2^-42, and where
/// floating-point arithmetic was not certain, at most half an ulp. If the overlap begins on several
/// axes at times that differ by at most 2^-42, the normal is that of one of them
/// @see Gottschalk, Lin and Manocha, *OBBTree*, SIGGRAPH 1996, for the axes; Eberly, *Dynamic
/// Collision Detection Using Oriented Bounding Boxes*, 1999, for the sweep
inline std::optional<BoxImpact<double>> box_impact(const TranslatingBox<double>& a,
                                                   const TranslatingBox<double>& b) {
  const detail::QuickSweep quick = detail::quick_sweep(a, b);
  if (quick.end == detail::QuickSweep::End::apart) return std::nullopt;
  if (quick.end == detail::QuickSweep::End::meet) return quick.impact;
  const detail::SweptPair<double> rounded = detail::rounded_pair(a, b);
  const detail::RoundedSweep sweep = detail::rounded_sweep(rounded);
  if (sweep.answer == detail::RoundedSweep::Answer::miss) return std::nullopt;
  const auto axes = separating_axes(rounded.u, rounded.v);
  if (sweep.answer == detail::RoundedSweep::Answer::hit && sweep.sure_of_start &&
      sweep.error <= 0x1p-43) {
    if (!(sweep.t > 0)) return BoxImpact<double>{};
    const auto times = rounded.times(axes[sweep.axis]);
    return BoxImpact<double>{
        std::min(1.0, sweep.t),
        detail::impact_normal(axes[sweep.axis], times.distance, times.speed, sweep.t)};
  }
  const detail::SweptPair<Exact> exact = detail::exact_pair(a, b);
  const auto touch = detail::exact_sweep(exact);
  if (!touch) return std::nullopt;
  if (touch->axis == 15) return BoxImpact<double>{};
  // The axis with its largest entry scaled to 1; then its sign, by the position of b.
  const Vector3<Exact> axis = separating_axes(exact.u, exact.v)[touch->axis];
  const Exact largest = std::max({abs(axis.x()), abs(axis.y()), abs(axis.z())});
  const Vector3<double> direction(quotient<double>(axis.x(), largest),
                                  quotient<double>(axis.y(), largest),
                                  quotient<double>(axis.z(), largest));
  // At the touch b is on the side from which it comes, against its relative velocity.
  const int side = -axis.dot(exact.w).sign();
  return BoxImpact<double>{quotient<double>(touch->t.numerator, touch->t.denominator),
                           detail::impact_normal(direction, double(side), 0, 0)};
}
// [/box-impact]

// [aabb-impact]
/// The time at which two translating axis-aligned boxes first touch in a step: three axes in place
/// of fifteen.
/// @param a, b at the start, made by the functions of contact/aabb.hpp; a may be flat or a point
/// @param displacement_a, displacement_b in the step, m, finite
/// @return t from 0 to 1, 0 if they meet at the start; nothing if they do not touch in the step.
/// The decision is right for every finite input; t is rounded once
template <std::floating_point S>
std::optional<S> aabb_impact(const Aabb<S>& a, const Vector3<S>& displacement_a, const Aabb<S>& b,
                             const Vector3<S>& displacement_b) {
  detail::SweepTime begin{Exact(), Exact(1.0)};
  detail::SweepTime end{Exact(1.0), Exact(1.0)};
  for (int k = 0; k < 3; ++k) {
    const auto exact = [](S x) { return Exact(double(x)); };
    // The displacement for which the low face of b is at the high face of a, and the reverse.
    const Exact forth = exact(a.low(k)) - exact(b.high(k));
    const Exact back = exact(a.high(k)) - exact(b.low(k));
    const Exact displacement = exact(displacement_b(k)) - exact(displacement_a(k));
    if (displacement.sign() == 0) {
      if (forth.sign() > 0 || back.sign() < 0) return std::nullopt;
      continue;
    }
    const bool up = displacement.sign() > 0;
    const detail::SweepTime first{up ? forth : -back, abs(displacement)};
    const detail::SweepTime last{up ? back : -forth, abs(displacement)};
    if (begin.before(first)) begin = first;
    if (last.before(end)) end = last;
    if (end.before(begin)) return std::nullopt;
  }
  return quotient<S>(begin.numerator, begin.denominator);
}
// [/aabb-impact]

}  // namespace contact
