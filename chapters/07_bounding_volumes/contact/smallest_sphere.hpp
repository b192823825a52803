/// @file
/// The smallest sphere that encloses points: by pivoting on the farthest point, decided without
/// error.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <contact/bounded_double_double.hpp>
#include <contact/enclosing_radius.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/local_points.hpp>
#include <contact/outward.hpp>
#include <contact/running_error.hpp>
#include <contact/shapes.hpp>
#include <contact/support_ball.hpp>
#include <contact/vector.hpp>
#include <contact/welzl_sphere.hpp>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace contact {

/// The smallest sphere that encloses points, and points that determine it.
template <FloatOrDouble S>
struct SmallestSphere {
  /// Its centre, each coordinate the number of S nearest to the exact one, and the smallest radius
  /// about this centre that encloses all points, m.
  Sphere<S> sphere;
  /// Indices of points on its surface, in increasing order, whose own smallest sphere is this one;
  /// −1 beyond support_count.
  std::array<int, 4> support{-1, -1, -1, -1};
  /// How many: from 1 to 4. None of them can be left out.
  int support_count = 0;
  /// The square of the exact radius, rounded to the nearest double, m²; 0 or infinite beyond the
  /// range of double.
  double radius_squared = 0;
};

namespace sphere_detail {

/// The S nearest to the exact number that x stands for, if its bound leaves no doubt. Rounding is
/// monotonic: what both ends of an interval round to, all numbers in it round to.
template <FloatOrDouble S>
std::optional<S> certain_nearest(const BoundedDoubleDouble& x) {
  const double off = BoundedDoubleDouble::up(x.bound) + 4 * RunningError::u * std::abs(x.low);
  const double below = x.low - (x.bound == 0 ? 0 : off), above = x.low + (x.bound == 0 ? 0 : off);
  if constexpr (std::same_as<S, double>) {
    if (x.high + below == x.high + above) return x.high + below;
  } else {
    const float from = static_cast<float>(sum_down(x.high, below));
    if (from == static_cast<float>(sum_up(x.high, above))) return from;
  }
  return std::nullopt;
}

/// The smallest ball of points, of a support that determines it.
template <FloatOrDouble S>
class SupportBall {
 public:
  /// The ball of one point, of radius 0.
  /// @param points must stay where they are
  SupportBall(const LocalPoints<S>& points, int index) : points_(points), base_(index) {
    measure();
  }

  /// The base point and the others, in increasing order.
  std::array<int, 4> support() const {
    std::array<int, 4> all{base_, -1, -1, -1};
    std::copy_n(others_.begin(), count_, all.begin() + 1);
    // All four, with −1 last: GCC 12 warns of a sort of the first few.
    std::sort(all.begin(), all.end(),
              [](int i, int j) { return static_cast<unsigned>(i) < static_cast<unsigned>(j); });
    return all;
  }
  int support_count() const { return 1 + count_; }

  // [outside]
  /// A point that is certainly outside the ball, or −1 if there is none.
  ///
  /// With the centre as rounded, c, and all rounding of local coordinates, a distance is off by
  /// less than `off`, and the computed square by less than 6u of itself. So a square above `high`
  /// is outside, one below `low` is inside, and only those between are decided one by one.
  int outside() const {
    const Farthest farthest = points_.farthest(centre_);
    if (farthest.distance_squared > high_) return farthest.index;
    if (farthest.distance_squared < low_) return -1;
    return outside_in_doubt();
  }
  // [/outside]

  // [pivot]
  /// Changes to the smallest ball of the support and a point q that is outside.
  ///
  /// That ball has q on its surface, because otherwise it would be the smallest ball of other
  /// points of the support, which would then not be smaller than the old one. So one of the sets of
  /// q and one, two or three of them is a support, and each question is a sign of a polynomial.
  void pivot(int q) {
    std::array<int, 4> old = others_;
    old[static_cast<std::size_t>(count_)] = base_;
    const int count = count_ + 1;
    Subset found = decide<RunningError>(q, old, count);
    if (found == 0) found = decide<BoundedDoubleDouble>(q, old, count);
    if (found == 0) found = decide<Exact>(q, old, count);
    assert(found != 0);
    base_ = q;
    count_ = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if ((found >> i & 1U) != 0) others_[static_cast<std::size_t>(count_++)] = old[i];
    }
    measure();
  }
  // [/pivot]

  /// Each coordinate of the centre, rounded to nearest.
  Vector3<S> nearest_centre() const {
    Vector3<S> nearest;
    const double after = points_.scaling().after;
    const bool scalable = points_.scaling().is_moderate();
    const auto h = from_base<BoundedDoubleDouble>(terms<BoundedDoubleDouble>());
    for (std::size_t k = 0; k < 3; ++k) {
      std::optional<S> certain;
      if (scalable) {
        const BoundedDoubleDouble unscaled{h[k].high / after, h[k].low / after,
                                           2 * h[k].bound / after};
        certain = certain_nearest<S>(BoundedDoubleDouble(points_.coordinate(base_, k)) + unscaled);
      }
      if (!certain) {
        const BallTerms<Exact>& exact = exact_terms();
        const Exact twice = exact.d + exact.d;
        certain = quotient<S>(twice * Exact(points_.coordinate(base_, k)) + exact.n[k], twice);
      }
      nearest(static_cast<int>(k)) = *certain;
    }
    return nearest;
  }
  /// The square of the radius, rounded to nearest.
  double nearest_radius_squared() const {
    const double after = points_.scaling().after;
    if (points_.scaling().is_moderate()) {
      const auto h = from_base<BoundedDoubleDouble>(terms<BoundedDoubleDouble>());
      BoundedDoubleDouble square = detail::dot(h, h);
      square = {square.high / after / after, square.low / after / after,
                2 * square.bound / after / after};
      if (const auto certain = certain_nearest<double>(square)) return *certain;
    }
    const BallTerms<Exact>& exact = exact_terms();
    const Exact twice = exact.d + exact.d;
    return quotient<double>(detail::dot(exact.n, exact.n), twice * twice);
  }

 private:
  const LocalPoints<S>& points_;
  int base_;
  std::array<int, 4> others_{};
  int count_ = 0;              // of others
  Vector3<double> centre_;     // local, rounded
  double low_ = 0, high_ = 0;  // see outside()
  mutable std::optional<BallTerms<Exact>> exact_;

  /// The differences of some points from a base point.
  template <class T>
  PointsFromBase<T> points_from(int base, const std::array<int, 4>& others, int count) const {
    std::array<detail::Triple<T>, 4> v;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      v[i] = points_.template difference<T>(others[i], base);
    }
    return {v, count};
  }
  /// The set of points that is with q a support of them all, or the empty one if that is in doubt.
  template <class T>
  Subset decide(int q, const std::array<int, 4>& others, int count) const {
    const PointsFromBase<T> from_q = points_from<T>(q, others, count);
    for (const Subset set : small_subsets) {
      if (set < (1U << count) && from_q.decide(set) == 1) return set;
    }
    return 0;
  }
  template <class T>
  BallTerms<T> terms() const {
    return points_from<T>(base_, others_, count_).ball((1U << count_) - 1);
  }
  const BallTerms<Exact>& exact_terms() const {
    if (!exact_) exact_ = terms<Exact>();
    return *exact_;
  }
  /// n/(2 d): the centre from the base point.
  template <class T>
  static detail::Triple<T> from_base(const BallTerms<T>& ball) {
    const T twice = ball.d + ball.d;
    return {ball.n[0] / twice, ball.n[1] / twice, ball.n[2] / twice};
  }

  /// Sets the rounded centre and the limits of outside().
  void measure() {
    exact_.reset();
    Vector3<double> h;
    double error = 0;
    const auto take = [&](const auto& ball) {
      const auto exact_h = from_base(ball);
      error = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        h(static_cast<int>(k)) = value_of(exact_h[k]);
        error += exact_h[k].bound + 2 * RunningError::u * std::abs(value_of(exact_h[k]));
      }
      return error <= 0x1p-44 * points_.extent();
    };
    if (!take(terms<RunningError>()) && !take(terms<BoundedDoubleDouble>())) {
      const BallTerms<Exact>& exact = exact_terms();
      const Exact scale = Exact(points_.scaling().before) * Exact(points_.scaling().after);
      error = 4 * RunningError::floor;
      for (std::size_t k = 0; k < 3; ++k) {
        h(static_cast<int>(k)) = quotient<double>(exact.n[k] * scale, exact.d + exact.d);
        error += 2 * RunningError::u * std::abs(h(static_cast<int>(k)));
      }
    }
    // Of the local coordinates of this point, the base point and the centre: each is rounded once,
    // relative to the extent of the points or twice it.
    constexpr double u = RunningError::u;
    const double off = (error + 16 * u * points_.extent()) * (1 + 16 * u) + 8 * RunningError::floor;
    const double radius = std::sqrt(h.dot(h));
    const double least = radius * (1 - 8 * u) - 2 * off, most = radius * (1 + 8 * u) + 2 * off;
    centre_ = points_[base_] + h;
    low_ = least > 0 ? least * least * (1 - 12 * u) - RunningError::floor : -1;
    high_ = most * most * (1 + 12 * u) + RunningError::floor;
  }
  static double value_of(const RunningError& x) { return x.value; }
  static double value_of(const BoundedDoubleDouble& x) { return x.high; }

  /// Of the points that are neither certainly inside nor outside by their squares, the one that is
  /// certainly outside by most, or else the first that is outside exactly.
  int outside_in_doubt() const {
    const BallTerms<BoundedDoubleDouble> ball = terms<BoundedDoubleDouble>();
    int farthest = -1;
    double largest = 0;
    std::vector<int> doubtful;
    for (int i = 0; i < points_.size(); ++i) {
      if (points_.distance_squared(i, centre_) < low_ || is_in_support(i)) continue;
      const BoundedDoubleDouble excess =
          ball_excess(ball, points_.template difference<BoundedDoubleDouble>(i, base_));
      const int sign = ball.sure ? excess.certain_sign() : 0;
      if (sign == 0 && !(ball.sure && excess.is_zero()) && farthest < 0) doubtful.push_back(i);
      if (sign > 0 && excess.high > largest) {
        largest = excess.high;
        farthest = i;
      }
    }
    if (farthest >= 0) return farthest;
    for (const int i : doubtful) {
      const auto x = points_.template difference<Exact>(i, base_);
      if (ball_excess(exact_terms(), x).sign() > 0) return i;
    }
    return -1;
  }
  /// Whether a point is one of the support, or equal to one.
  bool is_in_support(int i) const {
    const auto same = [&](int j) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (points_.coordinate(i, k) != points_.coordinate(j, k)) return false;
      }
      return true;
    };
    return same(base_) || std::any_of(others_.begin(), others_.begin() + count_, same);
  }
};

}  // namespace sphere_detail

/// The smallest sphere that encloses all points, decided without error.
///
/// Pivoting on the farthest point: a ball that is the smallest one of at most four points, its
/// support, is replaced by the smallest one of these and a point outside, the farthest, until none
/// is outside.
///
/// It ends: the new ball contains the support, so it is not smaller than the smallest ball of the
/// support, and not equal, because that does not contain the new point; so the radius grows, no
/// support comes twice, and there are finitely many. It is right: the last ball contains all
/// points, and any ball that does contains the support, so it is not smaller.
///
/// What is stored is rounded: the centre by at most half an ulp in each coordinate, and the radius
/// makes up for that.
/// @param points n ≥ 1 points, m, finite, of any magnitude, in any order; equal points, points on a
/// line, a circle or a sphere are no exceptions
/// @throws std::invalid_argument if there is no point, a coordinate is not finite, or the radius
/// overflows
///
/// Source: Gärtner, *Fast and robust smallest enclosing balls*, ESA 1999, for the pivot rule.
// [smallest-sphere]
template <FloatOrDouble S>
SmallestSphere<S> smallest_sphere(std::span<const Vector3<S>> points) {
  sphere_detail::require_points(points);
  const sphere_detail::LocalPoints<S> local(points);
  sphere_detail::SupportBall<S> ball(local, 0);
  for (int q = ball.outside(); q >= 0; q = ball.outside()) ball.pivot(q);
  SmallestSphere<S> result;
  result.sphere.centre = ball.nearest_centre();
  result.sphere.radius = enclosing_radius(result.sphere.centre, points);
  result.support = ball.support();
  result.support_count = ball.support_count();
  result.radius_squared = ball.nearest_radius_squared();
  return result;
}
// [/smallest-sphere]

}  // namespace contact
