/// @file
/// The smallest ball of at most five points, decided without error: the step from which the
/// smallest sphere of any number of points is made.
#pragma once

#include <array>
#include <cassert>
#include <contact/bounded_double_double.hpp>
#include <contact/exact.hpp>
#include <contact/running_error.hpp>
#include <cstddef>

namespace contact::sphere_detail {

// [ball-terms]
/// A ball with a point p on its surface, without division: its centre is p + n/(2 d), with d > 0.
///
/// |x − n/(2d)|² − |n/(2d)|² = |x|² − x·n/d, so a point p + x is outside if d |x|² − x·n > 0.
template <class T>
struct BallTerms {
  T d;                  ///< of degree 0, 4 or 3 in the coordinates, for 2, 3 or 4 points
  detail::Triple<T> n;  ///< of degree 1, 5 or 4
  /// Whether d is certain to be positive; if not, d and n may have the other sign.
  bool sure = true;
};

/// d |x|² − x·n: positive outside the ball, 0 on its surface.
template <class T>
T ball_excess(const BallTerms<T>& ball, const detail::Triple<T>& x) {
  return ball.d * detail::dot(x, x) - detail::dot(x, ball.n);
}
// [/ball-terms]

/// Sums of triples and their multiples.
template <class T>
detail::Triple<T> plus(const detail::Triple<T>& x, const detail::Triple<T>& y) {
  return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}
template <class T>
detail::Triple<T> times(const T& s, const detail::Triple<T>& x) {
  return {s * x[0], s * x[1], s * x[2]};
}

/// Which of up to four points belong to a set: bit i for point i.
using Subset = unsigned;
/// All sets of one, two or three of four points, small ones first: they cost less to decide.
inline constexpr std::array<Subset, 14> small_subsets{1, 2,  4,  8, 3,  5,  6,
                                                      9, 10, 12, 7, 11, 13, 14};

/// A base point p and up to four others p + v₀, p + v₁, …, in a number type.
template <class T>
class PointsFromBase {
 public:
  /// @param v the differences of the others from the base point
  /// @param count of them
  PointsFromBase(const std::array<detail::Triple<T>, 4>& v, int count)
      : v_(v), count_(static_cast<std::size_t>(count)) {
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j <= i; ++j) dots_[i][j] = dots_[j][i] = detail::dot(v[i], v[j]);
    }
  }

  /// The smallest ball that has the base point and the members of a set on its surface.
  BallTerms<T> ball(Subset set) const {
    const Members m(set);
    if (m.count == 0) return {T(1.0), {T(0.0), T(0.0), T(0.0)}};
    if (m.count == 1) return {T(1.0), v_[m.at[0]]};
    if (m.count == 2) {
      const Weights w = weights_of_two(m);
      return {w.d, plus(times(w.i, v_[m.at[0]]), times(w.j, v_[m.at[1]]))};
    }
    const auto crosses = crosses_of(m);
    const BallTerms<T> through = through_four(m, crosses);
    bool sure = true;
    const int sign = detail::sign_of(through.d, sure);
    if (sign >= 0) return {through.d, through.n, sure};
    return {-through.d, {-through.n[0], -through.n[1], -through.n[2]}};
  }

  // [decide-subset]
  /// Whether the base point and the members of a set, not empty, are a support of all points: the
  /// smallest ball with them on its surface contains the others, and its centre is inside their
  /// convex hull, which is why no smaller ball contains them. 1 or −1 if that is certain, else 0.
  ///
  /// Inside means: of two points always, of three if the triangle is acute, of four if each weight
  /// is positive with which they give the centre.
  int decide(Subset set) const {
    const Members m(set);
    bool sure = true;
    if (!centre_is_inside(m, sure)) return -1;
    const BallTerms<T> terms = ball(set);
    if (!terms.sure) return 0;
    for (std::size_t j = 0; j < count_; ++j) {
      if ((set >> j & 1U) != 0) continue;
      const T outside = terms.d * dots_[j][j] - detail::dot(v_[j], terms.n);
      if (detail::sign_of(outside, sure) > 0) return -1;
    }
    return sure ? 1 : 0;
  }
  // [/decide-subset]

 private:
  std::array<detail::Triple<T>, 4> v_;
  std::array<std::array<T, 4>, 4> dots_{};
  std::size_t count_;

  /// The members of a set, in order.
  struct Members {
    std::array<std::size_t, 4> at{};
    std::size_t count = 0;
    explicit Members(Subset set) {
      for (std::size_t i = 0; i < 4; ++i) {
        if ((set >> i & 1U) != 0) at[count++] = i;
      }
    }
  };
  /// d = |a × b|² and the weights with which a and b give n, for the circle through p, p + a, p +
  /// b.
  struct Weights {
    T d, i, j;
  };
  Weights weights_of_two(const Members& m) const {
    const T &aa = dots_[m.at[0]][m.at[0]], &bb = dots_[m.at[1]][m.at[1]],
            &ab = dots_[m.at[0]][m.at[1]];
    return {aa * bb - ab * ab, bb * (aa - ab), aa * (bb - ab)};
  }
  /// b × c, c × a and a × b of three members.
  std::array<detail::Triple<T>, 3> crosses_of(const Members& m) const {
    const auto &a = v_[m.at[0]], &b = v_[m.at[1]], &c = v_[m.at[2]];
    return {detail::cross(b, c), detail::cross(c, a), detail::cross(a, b)};
  }
  /// The terms of the sphere through four points; d = a · (b × c) may be negative.
  BallTerms<T> through_four(const Members& m,
                            const std::array<detail::Triple<T>, 3>& crosses) const {
    BallTerms<T> terms{detail::dot(v_[m.at[0]], crosses[0]), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      terms.n[k] = dots_[m.at[0]][m.at[0]] * crosses[0][k] +
                   dots_[m.at[1]][m.at[1]] * crosses[1][k] +
                   dots_[m.at[2]][m.at[2]] * crosses[2][k];
    }
    return terms;
  }
  /// Whether the centre may be inside the hull; sets `sure` to false if it may also not be.
  bool centre_is_inside(const Members& m, bool& sure) const {
    const auto may_be_positive = [&sure](const T& x) {
      bool certain = true;
      const int sign = detail::sign_of(x, certain);
      sure = sure && certain;
      return sign > 0 || !certain;
    };
    if (m.count == 1) return true;
    if (m.count == 2) {
      const T &aa = dots_[m.at[0]][m.at[0]], &bb = dots_[m.at[1]][m.at[1]],
              &ab = dots_[m.at[0]][m.at[1]];
      return may_be_positive(ab) && may_be_positive(aa - ab) && may_be_positive(bb - ab);
    }
    // The weight of p + a is n · (b × c)/(2 d²), and so on; that of p is what remains to 1. Where d
    // is 0, what remains is minus the sum of the others, so not all are positive.
    const auto crosses = crosses_of(m);
    const BallTerms<T> terms = through_four(m, crosses);
    T rest = terms.d * terms.d;
    rest = rest + rest;
    for (std::size_t k = 0; k < 3; ++k) {
      const T weight = detail::dot(terms.n, crosses[k]);
      if (!may_be_positive(weight)) return false;
      rest = rest - weight;
    }
    return may_be_positive(rest);
  }
};

}  // namespace contact::sphere_detail
