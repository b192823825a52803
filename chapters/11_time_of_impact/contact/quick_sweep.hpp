/// @file
/// Translating boxes: a quick decision of most pairs, from axes that are taken as orthonormal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <contact/plane.hpp>
#include <contact/tolerance.hpp>
#include <contact/translating_boxes.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// The projections on an axis in floating point, with bounds of their errors.
struct BoundedTimes {
  AxisTimes<double> times;
  double off;        ///< bound on the error of distance and sum
  double off_speed;  ///< bound on the error of the speed
};

// [bounded-times]
/// The projections on axis k of separating_axes().
///
/// Let M be the sum of the absolute values of the two products in an axis. A number like axis · d
/// has at most nine roundings (edge, cross product, difference of centres, dot product), the sum of
/// the projected half edges fifteen. γ(20) of M · |d|, and the same for speed and sum, includes the
/// rounding of the bound itself. Coordinates are between 2^-100 m and 2^100 m, so no underflow
/// matters and nothing overflows.
inline BoundedTimes bounded_times(const SweptPair<double>& pair, const Vector3<double>& axis,
                                  std::size_t k) {
  constexpr double slack = tolerance::gamma<double>(20);
  const auto& [x, y] = k < 3   ? std::pair(pair.u[(k + 1) % 3], pair.u[(k + 2) % 3])
                       : k < 6 ? std::pair(pair.v[(k + 1) % 3], pair.v[(k + 2) % 3])
                               : std::pair(pair.u[(k - 6) / 3], pair.v[(k - 6) % 3]);
  const Vector3<double> p = x.cwiseAbs();
  const Vector3<double> q = y.cwiseAbs();
  const Vector3<double> m(p.y() * q.z() + p.z() * q.y(), p.z() * q.x() + p.x() * q.z(),
                          p.x() * q.y() + p.y() * q.x());
  double edges = 0;
  for (std::size_t j = 0; j < 3; ++j)
    edges += m.dot(pair.u[j].cwiseAbs()) + m.dot(pair.v[j].cwiseAbs());
  return {pair.times(axis), slack * (m.dot(pair.d.cwiseAbs()) + edges) + 0x1p-900,
          slack * m.dot(pair.w.cwiseAbs()) + 0x1p-900};
}

/// Whether sizes are in the range in which the bounds hold.
inline bool in_filter_range(const SweptPair<double>& pair) {
  double largest = std::max(pair.d.cwiseAbs().maxCoeff(), pair.w.cwiseAbs().maxCoeff());
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    for (const auto& edge : {pair.u[k], pair.v[k]}) {
      largest = std::max(largest, edge.cwiseAbs().maxCoeff());
      smallest = std::min(smallest, edge.cwiseAbs().maxCoeff());
    }
  }
  return largest <= 0x1p100 && smallest >= 0x1p-100;
}

/// The error of a quotient of numbers with errors e and f: at most (e + |t| f) / (speed − f).
inline double quotient_error(const BoundedTimes& on, double t) {
  const double speed = std::abs(on.times.speed);
  return (2 * on.off + std::abs(t) * on.off_speed) / (speed - on.off_speed) * 1.01 +
         2 * tolerance::gamma<double>(20) * std::abs(t);
}
// [/bounded-times]

/// The axis as a unit vector from b to a: opposite to the distance at the time of the touch.
inline Vector3<double> impact_normal(const Vector3<double>& axis, double distance, double speed,
                                     double t) {
  const double square = axis.dot(axis);
  if (square == 0 && axis == Vector3<double>::Zero()) return axis;
  // Where no square underflows or overflows, no scaling by a power of two changes a bit.
  const bool in_range = square > 0x1p-900 && square < 0x1p900;
  const Vector3<double> unit =
      in_range ? Vector3<double>(axis / std::sqrt(square)) : normalised(axis);
  const Vector3<double> zero = Vector3<double>::Zero();
  return distance + speed * t > 0 ? Vector3<double>(zero - unit) : Vector3<double>(unit + zero);
}

/// What the quick sweep knows.
struct QuickSweep {
  enum class End { unsure, apart, meet } end = End::unsure;
  BoxImpact<double> impact;  ///< if they meet
};

/// The intervals of overlap on all axes so far, each end with its two bounds, in fractions of the
/// step.
class QuickIntervals {
 public:
  /// @param error of each distance together with the sum of extents; error_of_speed of each speed
  QuickIntervals(double error, double error_of_speed)
      : error_(error), error_of_speed_(error_of_speed), doubt_(error + error_of_speed) {}

  // [quick-axis]
  /// Adds axis k. Only the interval that is left by the axes before it matters: where the
  /// projections overlap at both its ends, they overlap in between, and axis k changes nothing.
  /// @return whether it proves that the boxes are apart throughout
  bool add(std::size_t k, double distance, double speed, double extents) {
    const double at_begin = distance + speed * begin_low_, at_end = distance + speed * end_high_;
    const double outside = extents + doubt_, inside = extents - doubt_;
    if (std::min(at_begin, at_end) > outside || std::max(at_begin, at_end) < -outside) return true;
    const bool begins = !(std::abs(at_begin) < inside), ends = !(std::abs(at_end) < inside);
    if (!begins && !ends) return false;
    const double by = std::abs(speed);
    if (!(by > 4 * error_of_speed_)) {
      unsure_ = true;  // another axis may still separate them
      return false;
    }
    // A quotient of numbers with errors e and f is off by at most (e + |t| f) / (speed − f).
    const double toward = speed < 0 ? distance : -distance;
    const double share = 1 / by, room = 1.5 * share;
    if (begins) {
      const double first = (toward - extents) * share;
      const double off = room * (error_ + std::abs(first) * error_of_speed_);
      highest_[k] = first + off;
      begin_low_ = std::max(begin_low_, first - off);
      begin_high_ = std::max(begin_high_, highest_[k]);
    }
    if (ends) {
      const double last = (toward + extents) * share;
      const double off = room * (error_ + std::abs(last) * error_of_speed_);
      end_low_ = std::min(end_low_, last - off);
      end_high_ = std::min(end_high_, last + off);
    }
    return begin_low_ > end_high_;
  }
  // [/quick-axis]
  /// Whether it is certain that the boxes meet, and whether they do at the start.
  bool certain() const {
    return !unsure_ && begin_high_ <= end_low_ && (begin_low_ > 0 || begin_high_ <= 0);
  }
  bool at_start() const { return begin_high_ <= 0; }
  /// Whether the overlap on axis k may be the last to begin.
  bool may_be_last(std::size_t k) const { return highest_[k] >= begin_low_; }

 private:
  double error_, error_of_speed_, doubt_;
  double begin_low_ = 0, begin_high_ = 0, end_low_ = 1, end_high_ = 1;
  bool unsure_ = false;
  std::array<double, 15> highest_{-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
};

/// The time on each axis that may be the last to begin, with a bound of its error: the largest is
/// the time of impact.
///
/// The bound is that of bounded_times() with longer terms, which cost less. An entry of M is at
/// most 2 h h', with the two half lengths in the axis, and the absolute entries of an edge have a
/// sum of at most √3 times its half length; 2^-10 more covers that axes are unit vectors to 2^-20
/// only.
/// @param distance, displacement sums of the absolute entries
inline QuickSweep last_to_begin(const TranslatingBox<double>& a, const TranslatingBox<double>& b,
                                const QuickIntervals& intervals, double distance,
                                double displacement) {
  constexpr double slack = tolerance::gamma<double>(20) * (1 + 0x1p-10);
  QuickSweep quick;
  const SweptPair<double> pair = rounded_edges(a, b);
  const auto half = [&](std::size_t k) {
    return k < 3 ? a.half_lengths(int(k)) : b.half_lengths(int(k - 3));
  };
  const double edges = 1.75 * (half(0) + half(1) + half(2) + half(3) + half(4) + half(5));
  double error = 0, offset = 0, speed = 1;
  Vector3<double> axis;
  for (std::size_t k = 0; k < 15; ++k) {
    if (!intervals.may_be_last(k)) continue;
    const Vector3<double> normal = separating_axis(pair.u, pair.v, k);
    const AxisTimes<double> times = pair.times(normal);
    const double of_axis = 2 * slack *
                           (k < 3   ? half((k + 1) % 3) * half((k + 2) % 3)
                            : k < 6 ? half(3 + (k + 1) % 3) * half(3 + (k + 2) % 3)
                                    : half((k - 6) / 3) * half(3 + (k - 6) % 3));
    const BoundedTimes on{times, of_axis * (distance + edges) + 0x1p-900,
                          of_axis * displacement + 0x1p-900};
    const double by = std::abs(times.speed);
    if (!(by > 4 * on.off_speed)) return quick;
    const double first = times.begins() / by;
    error = std::max(error, quotient_error(on, first));
    if (first > quick.impact.t) {
      quick.impact.t = first;
      axis = normal;
      offset = times.distance;
      speed = times.speed;
    }
  }
  if (!(error <= 0x1p-43 && quick.impact.t > 0)) return quick;
  quick.end = QuickSweep::End::meet;
  quick.impact.normal = impact_normal(axis, offset, speed, quick.impact.t);
  quick.impact.t = std::min(1.0, quick.impact.t);
  return quick;
}

/// The sweep with axes that are taken as orthonormal, in the coordinates of a.
///
/// Let the stored axes be orthonormal to 2^-20, as translating_box() requires. Then they are within
/// 2^-19.4 of orthonormal ones (their polar factor), and the stored boxes' fifteen axes, divided by
/// the half lengths in them, within 2^-18.4 of those of the orthonormal boxes. A product a_i · b_j
/// is within 2^-18.4 of that of these, a_k · d within 2^-19.4 |d|, so a sum of two products of both
/// within 2^-16.8 |d|. With the axis that is 2^-16.4 |d|, and with the rounding less than 2^-16 |d|
/// for distances, 2^-16 |w| for speeds and 2^-16 of the sum of half lengths for extents. So a pair
/// that is certain with these errors is certain. If they meet, last_to_begin() gives the time.
/// @return unsure also if a size is out of range
inline QuickSweep quick_sweep(const TranslatingBox<double>& a, const TranslatingBox<double>& b) {
  const auto dot = [](const auto& x, const Vector3<double>& y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  };
  const Vector3<double> d = b.frame.origin - a.frame.origin, w = b.displacement - a.displacement;
  const Vector3<double>&of_a = a.half_lengths, &of_b = b.half_lengths;
  const auto sum = [](const Vector3<double>& x) {
    return std::abs(x[0]) + std::abs(x[1]) + std::abs(x[2]);
  };
  const double distance = sum(d) + sum(of_a) + sum(of_b), displacement = sum(w);
  const double least =
      std::min(std::min({of_a[0], of_a[1], of_a[2]}), std::min({of_b[0], of_b[1], of_b[2]}));
  QuickSweep quick;
  if (!(distance + displacement < 0x1p98 && least > 0x1p-98)) return quick;
  QuickIntervals intervals(0x1p-16 * distance, 0x1p-16 * displacement);
  quick.end = QuickSweep::End::apart;
  double c[3][3], absolute[3][3], da[3], wa[3];  // c: a_i · b_j
  for (int i = 0; i < 3; ++i) {
    const auto axis = a.frame.axes.col(i);
    for (int j = 0; j < 3; ++j) {
      c[i][j] = axis[0] * b.frame.axes(0, j) + axis[1] * b.frame.axes(1, j) +
                axis[2] * b.frame.axes(2, j);
      absolute[i][j] = std::abs(c[i][j]);
    }
    da[i] = dot(axis, d);
    wa[i] = dot(axis, w);
    const double extents = of_a[i] + dot(absolute[i], of_b);
    if (intervals.add(std::size_t(i), da[i], wa[i], extents)) return quick;
  }
  for (int j = 0; j < 3; ++j) {
    const auto axis = b.frame.axes.col(j);
    const double extents =
        of_b[j] + absolute[0][j] * of_a[0] + absolute[1][j] * of_a[1] + absolute[2][j] * of_a[2];
    if (intervals.add(std::size_t(3) + std::size_t(j), dot(axis, d), dot(axis, w), extents))
      return quick;
  }
  for (int i = 0; i < 3; ++i) {
    const int p = (i + 1) % 3, q = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int r = (j + 1) % 3, s = (j + 2) % 3;
      if (absolute[i][j] > 1 - 0x1p-10 &&
          certainly_parallel(a.frame.axes.col(i), b.frame.axes.col(j))) {
        continue;
      }
      const double extents = absolute[q][j] * of_a[p] + absolute[p][j] * of_a[q] +
                             absolute[i][s] * of_b[r] + absolute[i][r] * of_b[s];
      if (intervals.add(std::size_t(6) + std::size_t(3) * std::size_t(i) + std::size_t(j),
                        c[p][j] * da[q] - c[q][j] * da[p], c[p][j] * wa[q] - c[q][j] * wa[p],
                        extents)) {
        return quick;
      }
    }
  }
  quick.end = QuickSweep::End::unsure;
  if (!intervals.certain()) return quick;
  if (intervals.at_start()) {
    quick.end = QuickSweep::End::meet;
    return quick;
  }
  return last_to_begin(a, b, intervals, sum(d), displacement);
}

}  // namespace contact::detail
