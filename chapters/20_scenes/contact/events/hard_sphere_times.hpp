/// @file
/// When a hard ball touches another or a wall: roots of polynomials, without cancellation and with
/// an answer in every case.
///
/// A contact is an instant at which the distance is zero and does not increase: bodies that touch
/// and separate are not in contact, bodies that touch and approach are.
/// And a grid of cells, each at least as wide as two balls: every ball that touches a ball is in
/// its cell or a neighbouring one, so the number of tests does not grow with the number of balls.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace contact {

/// A column of as many coordinates as a motion has: one on a line, two in a plane, three.
template <int Dimension>
using Column = Eigen::Matrix<double, Dimension, 1>;

/// The time of an event that never happens, s.
inline constexpr double never = std::numeric_limits<double>::infinity();

/// When something is reached, and the speed of approach then.
struct Arrival {
  double after = never;  ///< s, not negative
  double speed = 0;      ///< along the normal, m/s, not negative
};

namespace detail {

// What follows is written out, and not left to Eigen or to a loop, since it is asked for more often

// than anything else: at -O2 compilers call Eigen's functions for columns of three, and count to

// three.

/// x + v t.
template <int Dimension>
[[gnu::always_inline]] inline Column<Dimension> along(const Column<Dimension>& x,
                                                      const Column<Dimension>& v, double t) {
  Column<Dimension> to;
  to(0) = x(0) + v(0) * t;
  if constexpr (Dimension > 1) to(1) = x(1) + v(1) * t;
  if constexpr (Dimension > 2) to(2) = x(2) + v(2) * t;
  return to;
}

/// x + (v t + a s).
template <int Dimension>
[[gnu::always_inline]] inline Column<Dimension> along(const Column<Dimension>& x,
                                                      const Column<Dimension>& v, double t,
                                                      const Column<Dimension>& a, double s) {
  Column<Dimension> to;
  to(0) = x(0) + (v(0) * t + a(0) * s);
  if constexpr (Dimension > 1) to(1) = x(1) + (v(1) * t + a(1) * s);
  if constexpr (Dimension > 2) to(2) = x(2) + (v(2) * t + a(2) * s);
  return to;
}

/// The displacement from x to y.
template <int Dimension>
[[gnu::always_inline]] inline Column<Dimension> between(const Column<Dimension>& x,
                                                        const Column<Dimension>& y) {
  Column<Dimension> way;
  way(0) = y(0) - x(0);
  if constexpr (Dimension > 1) way(1) = y(1) - x(1);
  if constexpr (Dimension > 2) way(2) = y(2) - x(2);
  return way;
}

/// d · w, summed in the order in which Eigen adds.
template <int Dimension>
[[gnu::always_inline]] inline double dot(const Column<Dimension>& d, const Column<Dimension>& w) {
  if constexpr (Dimension == 1) return d(0) * w(0);
  if constexpr (Dimension == 2) return d(0) * w(0) + d(1) * w(1);
  if constexpr (Dimension == 3) return d(0) * w(0) + (d(1) * w(1) + d(2) * w(2));
}

///
/// d × w
/// ², in the dimension at hand: R² w² −
/// d × w
/// ² is the discriminant of an impact, without a difference of two large squares of distances.
template <int Dimension>
[[gnu::always_inline]] inline double cross_squared(const Column<Dimension>& d,
                                                   const Column<Dimension>& w) {
  if constexpr (Dimension == 1) return 0;
  const double first = d(0) * w(1) - d(1) * w(0);
  if constexpr (Dimension == 2) return first * first;
  const double second = d(0) * w(2) - d(2) * w(0);
  const double third = d(1) * w(2) - d(2) * w(1);
  return first * first + second * second + third * third;
}

}  // namespace detail

// [meeting]
/// Whether and when two balls with a constant relative velocity touch: a root is taken only where
/// they do. Under a common gravity the relative velocity is constant.
struct Encounter {
  double approach = 0;  ///< d · w: negative while they approach, m²/s
  double gap = 0;       ///< d² − R², m²
  double depth = 0;     ///< R² w² − |d × w|²: negative if they miss each other, m⁴/s²

  /// Whether they touch, now or later. One branch, mostly not taken, instead of three that a
  /// processor cannot predict.
  bool meets() const { return (approach < 0) & ((depth >= 0) | (gap <= 0)); }
  /// How long until they touch, if they do: the first t ≥ 0 with
  /// d + w t
  /// = R, s.
  double after() const { return gap <= 0 ? 0 : gap / (std::sqrt(depth) - approach); }
};

/// @param d from one centre to the other, m
/// @param w relative velocity, the rate of d, m/s
/// @param radius_sum R, the sum of the radii, m
template <int Dimension>
[[gnu::always_inline]] inline Encounter encounter(const Column<Dimension>& d,
                                                  const Column<Dimension>& w, double radius_sum) {
  return {detail::dot<Dimension>(d, w), detail::dot<Dimension>(d, d) - radius_sum * radius_sum,
          radius_sum * radius_sum * detail::dot<Dimension>(w, w) -
              detail::cross_squared<Dimension>(d, w)};
}

/// How long until two balls touch.
/// @return s; 0 if they touch or overlap and approach; `never` if they separate, or miss each
/// other. Off by a few u of itself, times R² w² / (R² w² −
/// d × w
/// ²) at most: close to grazing, rounding decides whether they touch, and then the impulse is small
/// too
/// @note Fourth powers of lengths and of √(length × speed) must neither overflow nor underflow:
/// sizes from 1e-70 to 1e70.
template <int Dimension>
double meeting(const Column<Dimension>& d, const Column<Dimension>& w, double radius_sum) {
  const Encounter met = encounter<Dimension>(d, w, radius_sum);
  return met.meets() ? met.after() : never;
}
// [/meeting]

/// When a point at a distance from a plane arrives there, and how fast.
///
/// The speed is a root of the energy, √(v² + 2 p · gap), not a velocity that was advanced in time:
/// so a ball that leaves a floor comes back exactly as fast, however often it bounces.
/// @param gap to the plane, m; negative inside
/// @param velocity of the gap, m/s
/// @param acceleration of the gap, m/s²; negative pulls towards the plane
/// @return `never` if the plane is not reached. If it is touched or passed already: now if the gap
/// decreases, otherwise the next time at which it begins to decrease while the plane is touched
Arrival arrival_at_plane(double gap, double velocity, double acceleration);

namespace detail {

/// A polynomial of the fourth degree, the constant first.
using Quartic = std::array<double, 5>;

inline double value_at(const Quartic& p, double t) {
  return (((p[4] * t + p[3]) * t + p[2]) * t + p[1]) * t + p[0];
}

/// The last number of [low, high] for which a monotone polynomial has the sign that it has at low,
/// by bisection down to adjacent numbers.
double sign_change(const Quartic& p, double low, double high);

/// Ends of the pieces of [0, end] on which a polynomial is monotone: 0, its extrema in order, end.
struct Pieces {
  std::array<double, 6> ends{};  ///< s
  std::size_t count = 0;         ///< number of ends
};

/// Between the extrema of the derivative there is at most one root of it, so a polynomial's pieces
/// follow from those of its derivative; a constant has one piece.
Pieces monotone_pieces(const Quartic& p, double end, int degree);

}  // namespace detail

// [bent]
/// How long until two balls touch of which gravity accelerates only one, as when the other lies on
/// a floor or is fixed: the first t ≥ 0 at which f(t) =
/// d + w t + a t²/2
/// ² − R² is not positive and decreases.
///
/// The interval is divided at the extrema of f; on a decreasing piece its zero is found by
/// bisection, down to the last bit.
/// @param d from one centre to the other, m
/// @param w rate of d, m/s
/// @param a rate of w, m/s², not 0
/// @param radius_sum R, the sum of the radii, m
/// @param separating whether the two have just hit each other, so that they do not approach now,
/// whatever rounding says
/// @return s, or `never`
template <int Dimension>
double accelerated_meeting(const Column<Dimension>& d, const Column<Dimension>& w,
                           const Column<Dimension>& a, double radius_sum, bool separating) {
  const double pull = a.norm();
  const double speed = w.norm();
  // From here on they are separated by the curvature of the path alone.
  const double end =
      2 * (speed + std::sqrt(speed * speed + 2 * pull * (d.norm() + radius_sum))) / pull;
  detail::Quartic f{d.dot(d) - radius_sum * radius_sum, 2 * d.dot(w), w.dot(w) + d.dot(a), w.dot(a),
                    a.dot(a) / 4};
  if (separating) f[1] = std::max(f[1], 0.0);
  const detail::Pieces pieces = detail::monotone_pieces(f, end, 4);
  for (std::size_t i = 0; i + 1 < pieces.count; ++i) {
    const double low = pieces.ends[i];
    const double high = pieces.ends[i + 1];
    const double at_low = detail::value_at(f, low);
    const double at_high = detail::value_at(f, high);
    if (!(at_high < at_low) || at_high > 0) continue;
    return at_low <= 0 ? low : detail::sign_change(f, low, high);
  }
  return never;
}
// [/bent]

/// When a ball leaves its cell, and through which face.
struct Crossing {
  double time = never;      ///< s
  std::int8_t axis = 0;     ///< of the face
  std::int8_t towards = 0;  ///< +1 or −1
};

/// Balls in cells. The outermost cells extend to infinity, so a ball that leaves the grid is still
/// in one; there it only costs more tests.
///
/// A cell is a little wider than two balls (by a part in 2^16), so that a crossing whose time is
/// rounded is still long before a contact beyond it.
template <int Dimension>
class HardSphereCells {
 public:
  using Point = Column<Dimension>;  ///< m

  HardSphereCells() = default;

  /// @param low, high opposite corners of the box where balls are expected, m
  /// @param widest diameter of the largest ball, m, greater than 0
  /// @param balls their number
  HardSphereCells(const Point& low, const Point& high, double widest, std::size_t balls)
      : origin_(low), next_(balls, none), previous_(balls, none), cell_(balls), list_(balls + 1) {
    width_ = widest * (1 + 0x1p-16);
    // Not many more cells than balls, to save memory.
    while (!fits(high, 4 * balls + 64)) width_ *= 1.125;
    head_.assign(count_[0] * count_[1] * count_[2], none);
  }

  /// Inserts a ball into its cell.
  void insert(std::size_t ball, const Point& position) {
    for (int k = 0; k < Dimension; ++k) {
      const double cell = std::floor((position(k) - origin_(k)) / width_);
      const auto last = static_cast<double>(count_[at(k)] - 1);
      cell_[ball][at(k)] = static_cast<std::int32_t>(std::clamp(cell, 0.0, last));
    }
    enter(ball);
  }

  // [crossing]
  /// When a ball next leaves its cell.
  /// @param ball index; its cell may be one that it reached later than `time`
  /// @param position, velocity, acceleration its flight since `time`, m, m/s, m/s²
  /// @param now s, not before `time`
  Crossing next_crossing(std::size_t ball, const Point& position, const Point& velocity,
                         const Point& acceleration, double time, double now) const {
    Crossing first;
    for (int k = 0; k < Dimension; ++k) {
      const auto offer = [&](double after, int towards) {
        const double when = std::max(now, time + after);
        if (when < first.time)
          first = {when, static_cast<std::int8_t>(k), static_cast<std::int8_t>(towards)};
      };
      const std::int32_t cell = cell_[ball][at(k)];
      const double below = position(k) - (origin_(k) + cell * width_);
      const double above = (origin_(k) + (cell + 1) * width_) - position(k);
      const bool has_lower = cell > 0;
      const bool has_upper = at(cell) + 1 < count_[at(k)];
      const double v = velocity(k);
      const double a = acceleration(k);
      if (a == 0) {
        if (v > 0 && has_upper) offer(above / v, 1);
        if (v < 0 && has_lower) offer(below / -v, -1);
      } else if (a < 0) {
        across(above, below, v, -a, now - time, has_upper, has_lower,
               [&](double after, int towards) { offer(after, towards); });
      } else {
        across(below, above, -v, a, now - time, has_lower, has_upper,
               [&](double after, int towards) { offer(after, -towards); });
      }
    }
    return first;
  }
  // [/crossing]

  /// Moves a ball into the next cell.
  void cross(std::size_t ball, const Crossing& crossing) {
    leave(ball);
    cell_[ball][at(crossing.axis)] += crossing.towards;
    enter(ball);
  }

  /// Every ball in the cells around a ball's, itself included. Overwritten by the next call.
  /// @param f called for each
  template <class F>
  std::span<const std::int32_t> near(std::size_t ball, const F& f) {
    return listed(cell_[ball], -1, 0, f);
  }

  /// Every ball in the cells that became neighbours with a crossing, in the same way.
  template <class F>
  std::span<const std::int32_t> newly_near(std::size_t ball, const Crossing& crossing, const F& f) {
    return listed(cell_[ball], crossing.axis, crossing.towards, f);
  }

  /// The cell in which a ball is listed, counted from the box's lower corner. It changes with
  /// cross() alone, and not by more than the box has: a ball outside is in the nearest cell.
  const std::array<std::int32_t, Dimension>& cell(std::size_t ball) const { return cell_[ball]; }
  /// Edge of a cell, m.
  double width() const { return width_; }
  /// Lower corner of the first cell, m.
  const Point& origin() const { return origin_; }
  /// Number of cells along an axis.
  std::size_t count(int axis) const { return count_[at(axis)]; }

  /// Bytes that it holds.
  std::size_t bytes() const {
    const std::size_t numbers =
        head_.capacity() + next_.capacity() + previous_.capacity() + list_.capacity();
    return numbers * sizeof(std::int32_t) + cell_.capacity() * sizeof(cell_[0]);
  }

 private:
  static constexpr std::int32_t none = -1;

  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

  bool fits(const Point& high, std::size_t max_cells) {
    double all = 1;
    for (int k = 0; k < Dimension; ++k) {
      const double cells = std::max(1.0, std::ceil((high(k) - origin_(k)) / width_));
      all *= cells;
      if (!(all <= static_cast<double>(max_cells))) return false;
      count_[at(k)] = static_cast<std::size_t>(cells);
    }
    return true;
  }

  /// Offers the times at which a flight leaves a cell along an axis on which `pull` pulls it back:
  /// through the face ahead while it rises, otherwise through the one behind. Both faces are given
  /// by their distance at the start of the flight.
  template <class Offer>
  static void across(double ahead, double behind, double v, double pull, double flown,
                     bool has_ahead, bool has_behind, const Offer& offer) {
    // Rounding is monotone: a flight that fell through a face has `flown` at least as long as its
    // rise, so the face ahead is never tested again.
    if (has_ahead && v > 0 && flown < v / pull) {
      const double rest = v * v - 2 * pull * ahead;
      if (rest >= 0) {
        offer(2 * ahead / (v + std::sqrt(rest)), 1);
        return;
      }
    }
    if (!has_behind) return;
    const double speed = std::sqrt(std::max(0.0, v * v + 2 * pull * behind));
    offer(v < 0 ? 2 * behind / (speed - v) : (speed + v) / pull, -1);
  }

  std::size_t index(const std::array<std::int32_t, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2]) * count_[1] + static_cast<std::size_t>(cell[1])) *
               count_[0] +
           static_cast<std::size_t>(cell[0]);
  }

  std::int32_t& head_of(std::size_t ball) {
    std::array<std::int32_t, 3> cell{};
    for (int k = 0; k < Dimension; ++k) cell[at(k)] = cell_[ball][at(k)];
    return head_[index(cell)];
  }

  void enter(std::size_t ball) {
    std::int32_t& head = head_of(ball);
    previous_[ball] = none;
    next_[ball] = head;
    if (head != none) previous_[static_cast<std::size_t>(head)] = static_cast<std::int32_t>(ball);
    head = static_cast<std::int32_t>(ball);
  }

  void leave(std::size_t ball) {
    const std::int32_t next = next_[ball];
    const std::int32_t previous = previous_[ball];
    (previous == none ? head_of(ball) : next_[static_cast<std::size_t>(previous)]) = next;
    if (next != none) previous_[static_cast<std::size_t>(next)] = previous;
  }

  /// The balls in all neighbouring cells, or only in those on one side of an axis.
  ///
  /// A cell has no ball, or one, or two, and a loop over each would end unpredictably for the
  /// processor. So each cell's first ball is written down, then the ball after each that is
  /// written, and empty entries are overwritten.
  template <class F>
  std::span<const std::int32_t> listed(const std::array<std::int32_t, Dimension>& cell, int axis,
                                       int towards, const F& f) {
    std::array<std::int32_t, 3> low{};
    std::array<std::int32_t, 3> high{};
    for (int k = 0; k < Dimension; ++k) {
      const auto last = static_cast<std::int32_t>(count_[at(k)]) - 1;
      low[at(k)] = std::max(cell[at(k)] + (k == axis ? towards : -1), 0);
      high[at(k)] = std::min(cell[at(k)] + (k == axis ? towards : 1), last);
    }
    std::int32_t* const begin = list_.data();
    std::int32_t* end = begin;
    const auto write = [&end](std::int32_t ball) {
      *end = ball;
      end += ball != none;
    };
    std::array<std::int32_t, 3> c{};
    for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) {
      for (c[1] = low[1]; c[1] <= high[1]; ++c[1]) {
        c[0] = low[0];
        const std::int32_t* head = head_.data() + index(c);
        for (; c[0] <= high[0]; ++c[0], ++head) write(*head);
      }
    }
    for (const std::int32_t* ball = begin; ball != end; ++ball) {
      f(static_cast<std::size_t>(*ball));
      write(next_[static_cast<std::size_t>(*ball)]);
    }
    return {begin, end};
  }

  Point origin_ = Point::Zero();
  double width_ = 1;
  std::array<std::size_t, 3> count_{1, 1, 1};
  std::vector<std::int32_t> head_;
  // Each cell's balls are a linked list: its first ball, and after each ball the next.
  std::vector<std::int32_t> next_;
  std::vector<std::int32_t> previous_;
  std::vector<std::array<std::int32_t, Dimension>> cell_;
  std::vector<std::int32_t> list_;  // balls near the one of the last call, and one spare entry
};

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_times.cpp"
#endif
