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
#include <contact/frame.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plane.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A box with any orientation that translates.
///
/// Its edges are the columns of `frame.axes` times twice the half lengths, as stored. If the stored
/// axes are not exactly orthogonal, it is the slightly oblique parallelepiped that they span.
/// translating_box() checks its arguments.
template <Ring S>
struct TranslatingBox {
  CoordinateFrame<S> frame;                      ///< centre at the start, m, and axes
  Vector3<S> half_lengths = Vector3<S>::Zero();  ///< m, each greater than 0
  Vector3<S> displacement = Vector3<S>::Zero();  ///< in the step, m
};

/// Checks a translating box.
/// @param frame centre and axes; the axes must be orthonormal to 2^-20
/// @param half_lengths m, finite, each greater than 0
/// @param displacement m, finite
/// @throws std::invalid_argument if an argument does not satisfy these conditions
template <std::floating_point S>
TranslatingBox<S> translating_box(const CoordinateFrame<S>& frame, const Vector3<S>& half_lengths,
                                  const Vector3<S>& displacement) {
  require_finite("frame.origin", frame.origin);
  require_finite("half_lengths", half_lengths);
  require_finite("displacement", displacement);
  const Matrix3<S> product = frame.axes.transpose() * frame.axes;
  for (int k = 0; k < 3; ++k) {
    if (!(half_lengths(k) > S(0))) {
      throw_invalid_argument("half_lengths", vector_text(half_lengths),
                             "each must be greater than 0");
    }
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(product(k, j) - (k == j ? S(1) : S(0))) <= S(0x1p-20))) {
        const Vector3<S> axis = frame.axes.col(k);
        throw_invalid_argument("frame.axes", vector_text(axis),
                               "the axes must have length 1 and be orthogonal");
      }
    }
  }
  return {frame, half_lengths, displacement};
}

/// The first touch of two translating boxes.
template <Ring S>
struct BoxImpact {
  S t = S(0);  ///< fraction of the step, from 0 to 1
  /// Unit vector from b to a, normal to the plane that separates them until then. 0 if they meet at
  /// the start.
  Vector3<S> normal = Vector3<S>::Zero();
};

// [axis-times]
/// The interval in which the projections of two bodies on an axis overlap: |distance + speed t| ≤
/// reach.
///
/// Its ends are fractions with a common positive denominator, so they are compared without a
/// division. If the speed is 0, the projections overlap always or never.
template <Ring T>
struct AxisTimes {
  T distance;    ///< axis · d
  T speed;       ///< axis · w
  T radius_sum;  ///< half the sum of both extents, times the length of the axis

  /// Numerator of the time at which the overlap begins; |speed| is the denominator.
  T begins() const { return (speed < T(0) ? distance : T(-distance)) - radius_sum; }
  /// Numerator of the time at which it ends.
  T ends() const { return (speed < T(0) ? distance : T(-distance)) + radius_sum; }
};

/// The fifteen axes of two boxes with the half edges u and v: three face normals of each, and nine
/// cross products of an edge of one and an edge of the other. Two boxes are disjoint if and only if
/// one of these axes separates them. Parallel edges give 0, which separates nothing.
template <Ring T>
std::array<Vector3<T>, 15> separating_axes(const std::array<Vector3<T>, 3>& u,
                                           const std::array<Vector3<T>, 3>& v) {
  std::array<Vector3<T>, 15> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k] = u[(k + 1) % 3].cross(u[(k + 2) % 3]);
    axes[3 + k] = v[(k + 1) % 3].cross(v[(k + 2) % 3]);
    for (std::size_t j = 0; j < 3; ++j) axes[6 + 3 * k + j] = u[k].cross(v[j]);
  }
  return axes;
}
// [/axis-times]

namespace detail {

/// The half edges of two boxes, and the position and displacement of b relative to a.
template <Ring T>
struct SweptPair {
  std::array<Vector3<T>, 3> u;
  std::array<Vector3<T>, 3> v;
  Vector3<T> d;
  Vector3<T> w;

  AxisTimes<T> times(const Vector3<T>& axis) const {
    const auto magnitude = [](const T& x) { return x < T(0) ? T(-x) : x; };
    T radius_sum(0);
    for (std::size_t k = 0; k < 3; ++k)
      radius_sum = radius_sum + magnitude(axis.dot(u[k])) + magnitude(axis.dot(v[k]));
    return {axis.dot(d), axis.dot(w), radius_sum};
  }
};

inline SweptPair<Exact> exact_pair(const TranslatingBox<double>& a,
                                   const TranslatingBox<double>& b) {
  SweptPair<Exact> pair;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Vector3<double> edge_a = a.frame.axes.col(k);
    const Vector3<double> edge_b = b.frame.axes.col(k);
    pair.u[at] = exact_vector(edge_a) * Exact(a.half_lengths(k));
    pair.v[at] = exact_vector(edge_b) * Exact(b.half_lengths(k));
  }
  pair.d = exact_vector(b.frame.origin) - exact_vector(a.frame.origin);
  pair.w = exact_vector(b.displacement) - exact_vector(a.displacement);
  return pair;
}

inline SweptPair<double> rounded_pair(const TranslatingBox<double>& a,
                                      const TranslatingBox<double>& b) {
  SweptPair<double> pair;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    pair.u[at] = a.frame.axes.col(k) * a.half_lengths(k);
    pair.v[at] = b.frame.axes.col(k) * b.half_lengths(k);
  }
  pair.d = b.frame.origin - a.frame.origin;
  pair.w = b.displacement - a.displacement;
  return pair;
}

// [swept-filter]
/// The result of the sweep in floating point.
struct RoundedSweep {
  enum class Answer { miss, hit, unsure } answer = Answer::unsure;
  double t = 0;                ///< if they hit
  double error = 0;            ///< upper bound of the error of t
  std::size_t axis = 0;        ///< on which the overlap begins last
  bool sure_of_start = false;  ///< whether it is certain that they meet at the start, or do not
};

/// The sweep in floating point, with error bounds.
///
/// Let M be the sum of the absolute values of the two products in an axis. A number like axis · d
/// has at most nine roundings (edge, cross product, difference of centres, dot product), the
/// sum of the projected half edges fifteen. γ(20) of M · |d|, and the same for speed and sum,
/// includes the rounding of the bound itself. Coordinates are between 2^-100 m and 2^100 m, so no
/// underflow matters and nothing overflows.
inline RoundedSweep rounded_sweep(const SweptPair<double>& pair) {
  constexpr double slack = tolerance::gamma<double>(20);
  double largest = std::max(pair.d.cwiseAbs().maxCoeff(), pair.w.cwiseAbs().maxCoeff());
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    for (const auto& edge : {pair.u[k], pair.v[k]}) {
      largest = std::max(largest, edge.cwiseAbs().maxCoeff());
      smallest = std::min(smallest, edge.cwiseAbs().maxCoeff());
    }
  }
  RoundedSweep sweep;
  if (!(largest <= 0x1p100 && smallest >= 0x1p-100)) return sweep;

  const std::array<Vector3<double>, 15> axes = separating_axes(pair.u, pair.v);
  double begin_low = 0;  // the last beginning and the first end, each with two bounds
  double begin_high = 0;
  double end_low = 1;
  double end_high = 1;
  double begin = 0;
  bool unsure = false;
  for (std::size_t k = 0; k < 15; ++k) {
    const auto& [x, y] = k < 3   ? std::pair(pair.u[(k + 1) % 3], pair.u[(k + 2) % 3])
                         : k < 6 ? std::pair(pair.v[(k + 1) % 3], pair.v[(k + 2) % 3])
                                 : std::pair(pair.u[(k - 6) / 3], pair.v[(k - 6) % 3]);
    const Vector3<double> p = x.cwiseAbs();
    const Vector3<double> q = y.cwiseAbs();
    const Vector3<double> m(p.y() * q.z() + p.z() * q.y(), p.z() * q.x() + p.x() * q.z(),
                            p.x() * q.y() + p.y() * q.x());
    const AxisTimes<double> times = pair.times(axes[k]);
    double edges = 0;
    for (std::size_t j = 0; j < 3; ++j)
      edges += m.dot(pair.u[j].cwiseAbs()) + m.dot(pair.v[j].cwiseAbs());
    const double off = slack * (m.dot(pair.d.cwiseAbs()) + edges) + 0x1p-900;
    const double off_speed = slack * m.dot(pair.w.cwiseAbs()) + 0x1p-900;
    const double speed = std::abs(times.speed);
    const double nearest = std::abs(times.distance) - speed;
    const double farthest = std::abs(times.distance) + speed;
    const double doubt = 2 * (off + off_speed) + slack * (farthest + times.radius_sum);
    if (nearest > times.radius_sum + doubt) return {RoundedSweep::Answer::miss, 0, 0, k, true};
    if (farthest < times.radius_sum - doubt) continue;  // overlap on this axis at all times
    if (!(speed > 4 * off_speed)) {
      unsure = true;  // another axis may still prove that they are separated
      continue;
    }
    // A quotient of numbers with errors e and f has an error of at most (e + |t| f) / (speed − f).
    const double first = times.begins() / speed;
    const double last = times.ends() / speed;
    const double share = 2 * slack;
    const double off_first = (2 * off + std::abs(first) * off_speed) / (speed - off_speed) * 1.01 +
                             share * std::abs(first);
    const double off_last = (2 * off + std::abs(last) * off_speed) / (speed - off_speed) * 1.01 +
                            share * std::abs(last);
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

/// The axis as a unit vector from b to a: opposite to the distance at the time of the touch.
inline Vector3<double> impact_normal(const Vector3<double>& axis, double distance, double speed,
                                     double t) {
  if (axis == Vector3<double>::Zero()) return axis;
  const Vector3<double> unit = normalised(axis);
  return distance + speed * t > 0 ? Vector3<double>(-unit) : unit;
}

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
/// floating-point arithmetic was not certain, at most half an ulp. If several axes tie, the normal
/// is that of one of them
/// @see Gottschalk, Lin and Manocha, *OBBTree*, SIGGRAPH 1996, for the axes; Eberly, *Dynamic
/// Collision Detection Using Oriented Bounding Boxes*, 1999, for the sweep
inline std::optional<BoxImpact<double>> box_impact(const TranslatingBox<double>& a,
                                                   const TranslatingBox<double>& b) {
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

/// The former name of box_impact().
inline std::optional<BoxImpact<double>> box_sweep(const TranslatingBox<double>& a,
                                                  const TranslatingBox<double>& b) {
  return box_impact(a, b);
}
/// The former name of aabb_impact().
template <std::floating_point S>
std::optional<S> aabb_sweep(const Aabb<S>& a, const Vector3<S>& displacement_a, const Aabb<S>& b,
                            const Vector3<S>& displacement_b) {
  return aabb_impact(a, displacement_a, b, displacement_b);
}

}  // namespace contact
