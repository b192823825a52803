/// @file
/// What floating-point arithmetic proves of the first time at which a moving point is on a moving
/// triangle, or two moving segments meet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <contact/filter.hpp>
#include <contact/running_error.hpp>
#include <contact/separating_times.hpp>
#include <contact/support.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// Positions at t = 0 and t = 1, m.
using BothEnds = std::array<Vector3<double>, 2>;

/// The point of a segment closest to the origin.
inline Vector3<double> closest_to_origin(const Vector3<double>& a, const Vector3<double>& b) {
  const Vector3<double> d = b - a;
  const double along = -dot3(a, d), whole = dot3(d, d);
  if (!(along > 0)) return a;
  if (!(along < whole)) return b;
  return a + d * (along / whole);
}

/// The shorter vector.
inline const Vector3<double>& shorter(const Vector3<double>& a, const Vector3<double>& b) {
  return dot3(b, b) < dot3(a, a) ? b : a;
}

/// 1 if all are certainly positive, −1 if one is certainly negative, else 0.
template <std::size_t N>
int sign_of_all(const std::array<RunningError, N>& numbers) {
  int sign = 1;
  for (const RunningError& x : numbers) {
    if (x.certain_sign() < 0) return -1;
    if (x.certain_sign() == 0) sign = 0;
  }
  return sign;
}

/// A moving triangle as seen from a moving point.
struct SeenTriangle {
  MovingDifferences<3> x;  ///< vertices − point

  SeenTriangle(const BothEnds& point, const std::array<BothEnds, 3>& vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      x.start[i] = vertices[i][0] - point[0];
      x.end[i] = vertices[i][1] - point[1];
    }
    x.scale();
  }
  bool usable() const { return x.usable; }
  /// Three vectors that lie in a plane whenever the point is in that of the triangle.
  const MovingDifferences<3>& factors() const { return x; }
  /// The direction in which the triangle is closest: its normal if the foot of the perpendicular is
  /// inside, else the vector to the closest point of its edges.
  Vector3<double> direction(double t) const {
    const Vector3<double> a = x.at(0, t), b = x.at(1, t), c = x.at(2, t);
    const Vector3<double> n = (b - a).cross(Vector3<double>(c - a));
    if (dot3<double>(n, a.cross(b)) > 0 && dot3<double>(n, b.cross(c)) > 0 &&
        dot3<double>(n, c.cross(a)) > 0) {
      return dot3(n, a) < 0 ? Vector3<double>(-n) : n;
    }
    return shorter(shorter(closest_to_origin(a, b), closest_to_origin(b, c)),
                   closest_to_origin(c, a));
  }
  /// 1 if the point is certainly inside the triangle whenever it is in its plane from t − w to t +
  /// w, −1 if it is certainly not on it, else 0.
  int inside(double t, double w) const {
    const auto a = enclosed(x, 0, t, w), b = enclosed(x, 1, t, w), c = enclosed(x, 2, t, w);
    const Triple<RunningError> n = cross(minus(b, a), minus(c, a));
    return sign_of_all<3>({dot(n, cross(a, b)), dot(n, cross(b, c)), dot(n, cross(c, a))});
  }
};

/// Two moving segments pq and rs.
struct SeenSegments {
  MovingDifferences<4> x;  ///< p − r, p − s, q − r, q − s: the vertices of a parallelogram
  MovingDifferences<3> y;  ///< p − r, q − p, s − r

  SeenSegments(const BothEnds& p, const BothEnds& q, const BothEnds& r, const BothEnds& s) {
    x.start = {p[0] - r[0], p[0] - s[0], q[0] - r[0], q[0] - s[0]};
    x.end = {p[1] - r[1], p[1] - s[1], q[1] - r[1], q[1] - s[1]};
    y.start = {x.start[0], q[0] - p[0], s[0] - r[0]};
    y.end = {x.end[0], q[1] - p[1], s[1] - r[1]};
    x.scale();
    y.scale();
  }
  bool usable() const { return x.usable && y.usable; }
  /// Three vectors that lie in a plane whenever the four ends do.
  const MovingDifferences<3>& factors() const { return y; }
  /// The direction in which the segments are closest: perpendicular to both if the perpendicular
  /// meets both, else the shortest difference with an end.
  Vector3<double> direction(double t) const {
    const Vector3<double> w = y.at(0, t), u = y.at(1, t), v = y.at(2, t), m = u.cross(v);
    const double whole = dot3(m, m);
    const double s = -dot3<double>(m, w.cross(v)), r = -dot3<double>(m, w.cross(u));
    if (s > 0 && s < whole && r > 0 && r < whole) return dot3(m, w) < 0 ? Vector3<double>(-m) : m;
    const Vector3<double> pr = x.at(0, t), ps = x.at(1, t), qr = x.at(2, t), qs = x.at(3, t);
    return shorter(shorter(closest_to_origin(pr, ps), closest_to_origin(ps, qs)),
                   shorter(closest_to_origin(qs, qr), closest_to_origin(qr, pr)));
  }
  /// 1 if the lines certainly cross inside both segments whenever the ends are in a plane from t −
  /// w to t + w, −1 if the segments certainly do not meet, else 0.
  int inside(double t, double w) const {
    const auto a = enclosed(y, 0, t, w), u = enclosed(y, 1, t, w), v = enclosed(y, 2, t, w);
    const Triple<RunningError> m = cross(u, v);
    const RunningError whole = dot(m, m), s = -dot(m, cross(a, v)), r = -dot(m, cross(a, u));
    return sign_of_all<4>({s, whole - s, r, whole - r});
  }
};

// [volume-of-time]
/// The volume of three moving vectors as a cubic of the time from low to high, by its Bernstein
/// coefficients: it is between the least and the largest of them.
struct BernsteinCubic {
  double low = 0;
  double high = 1;
  std::array<double, 4> b{};
  double error = 0;  ///< each coefficient is off by at most this

  /// The sign that the cubic certainly has at all times from low to high, else 0.
  int sign() const {
    const auto [least, largest] = std::minmax({b[0], b[1], b[2], b[3]});
    return least > error ? 1 : (largest < -error ? -1 : 0);
  }
  /// Whether it certainly has opposite signs at both ends.
  bool changes_sign() const {
    return (b[0] > error && b[3] < -error) || (b[0] < -error && b[3] > error);
  }
  /// The lower and the upper half (de Casteljau). Halves of sums are rounded once; the bound of the
  /// error covers this for 64 halvings.
  std::array<BernsteinCubic, 2> halves() const {
    const double p = (b[0] + b[1]) / 2, q = (b[1] + b[2]) / 2, r = (b[2] + b[3]) / 2;
    const double pq = (p + q) / 2, qr = (q + r) / 2, pqr = (pq + qr) / 2;
    const double middle = (low + high) / 2;
    return {BernsteinCubic{low, middle, {b[0], p, pq, pqr}, error},
            BernsteinCubic{middle, high, {pqr, qr, r, b[3]}, error}};
  }
};

/// The coefficients from 0 to 1: means of the volumes with one or two vectors taken at the end.
///
/// Each volume has the bound of bounded_volume(), since each entry is a difference rounded once.
/// Two sums and a third add 3 u of values that are at most the magnitudes m, of which the bounds
/// are 9u: 12u m is below twice the bounds. A halving adds at most 3 u of the largest coefficient.
inline BernsteinCubic volume_of_time(const MovingDifferences<3>& x) {
  const auto mean = [&x](std::array<std::array<int, 3>, 3> which) {
    Bounded sum{0, 0};
    for (const auto& end : which) {
      const auto vector = [&](std::size_t i) -> const Vector3<double>& {
        return end[i] == 0 ? x.start[i] : x.end[i];
      };
      const Bounded volume = bounded_volume(vector(0), vector(1), vector(2));
      sum.value += volume.value;
      sum.bound += volume.bound;
    }
    return Bounded{sum.value / 3, sum.bound};
  };
  const Bounded first = bounded_volume(x.start[0], x.start[1], x.start[2]);
  const Bounded last = bounded_volume(x.end[0], x.end[1], x.end[2]);
  const std::array<Bounded, 4> means{first, mean({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}),
                                     mean({{{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}}), last};
  BernsteinCubic cubic;
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    cubic.b[k] = means[k].value;
    largest = std::max(largest, std::abs(means[k].value));
    cubic.error = std::max(cubic.error, 2 * means[k].bound);
  }
  cubic.error += 256 * tolerance::unit_roundoff<double> * largest;
  return cubic;
}
// [/volume-of-time]

/// What floating-point arithmetic proves of a first time.
struct FloatingTime {
  /// No common point from 0 to 1; a common point from t to t_high; or neither is proved.
  enum class State { clear, meets, doubt };
  State state = State::doubt;
  double t = 0;       ///< no common point before
  double t_high = 1;  ///< if it meets
};

// [narrow-root]
/// Narrows an interval in which the features certainly meet: to the upper half if the volume has no
/// root in the lower one, to the lower half if it certainly changes its sign there.
inline FloatingTime narrowed(BernsteinCubic cubic) {
  while (cubic.high - cubic.low > 0x1p-48) {
    const auto [lower, upper] = cubic.halves();
    if (lower.sign() != 0 && upper.changes_sign()) {
      cubic = upper;
    } else if (lower.changes_sign()) {
      cubic = lower;
    } else {
      break;
    }
  }
  return {FloatingTime::State::meets, cubic.low, cubic.high};
}
// [/narrow-root]

/// What a very short part proves together with one as long after it: that they meet, if the volume
/// is certainly of opposite signs at both ends and the point or the crossing certainly inside. A
/// root at a fraction with a power of two as denominator is at the end of each part, and needs
/// this.
template <class Pair>
FloatingTime meeting_beyond(const Pair& pair, const BernsteinCubic& part) {
  const double length = part.high - part.low, high = part.high + length;
  if (!(high <= 1) || pair.inside(part.high, length) <= 0) return {};
  const auto at_end = [&](std::size_t i) { return enclosed(pair.factors(), i, high, 0); };
  const int last = dot(at_end(0), cross(at_end(1), at_end(2))).certain_sign();
  if ((last > 0 && part.b[0] < -part.error) || (last < 0 && part.b[0] > part.error)) {
    return {FloatingTime::State::meets, part.low, high};
  }
  return {};
}

// [roots-of-volume]
/// Goes through the parts of the step in which the volume may be 0, in ascending order, each half
/// as long as the one it is from.
///
/// In a part without a root of the volume the features do not meet, since the points are not in a
/// plane; nor where the point or the crossing is certainly outside. Where it is certainly inside
/// and the volume changes its sign, they meet. A part shorter than 2^-40 that is none of these
/// leaves a doubt, as do more than 256 parts.
/// @param from before this time they certainly do not meet
template <class Pair>
FloatingTime search_volume(const Pair& pair, double from) {
  std::array<BernsteinCubic, 64> stack;
  std::size_t count = 0;
  stack[count++] = volume_of_time(pair.factors());
  if (!std::isfinite(stack[0].error)) return {};
  for (int parts = 0; count > 0; ++parts) {
    if (parts == 256) return {};
    const BernsteinCubic part = stack[--count];
    if (part.high < from || part.sign() != 0) continue;
    const double length = part.high - part.low;
    if (length == 0x1p-3 || length == 0x1p-7 || length == 0x1p-12 || length == 0x1p-20 ||
        length == 0x1p-40) {
      const int inside = pair.inside(part.low + length / 2, length / 2);
      if (inside < 0) continue;
      if (inside > 0 && part.changes_sign()) return narrowed(part);
    }
    if (length == 0x1p-40) return meeting_beyond(pair, part);
    const auto halves = part.halves();
    stack[count++] = halves[1];
    stack[count++] = halves[0];
  }
  return {FloatingTime::State::clear, 1, 1};
}
// [/roots-of-volume]

// [advance-planes]
/// The first time at which the features meet, as far as floating-point arithmetic can prove it.
///
/// Conservative advancement from plane to plane: at each time the plane perpendicular to the
/// shortest difference separates the features until the next time, which separating_time() proves.
/// Most features that do not meet need one or two planes. Where the advances become short, the
/// roots of the volume say more.
template <class Pair>
FloatingTime first_time_in_floating_point(const Pair& pair) {
  if (!pair.usable()) return {};
  double t = 0;
  for (int k = 0; k < 4; ++k) {
    const SeparatingTime next = separating_time(pair.x, pair.direction(t), t);
    if (next.always) return {FloatingTime::State::clear, 1, 1};
    const double advance = next.until - t;
    t = next.until;
    if (!(advance > 0x1p-4)) break;
  }
  return search_volume(pair, t);
}
// [/advance-planes]

}  // namespace contact::detail
