/// @file
/// A grid of cells, each at least as wide as two balls: who touches a ball is in its cell or a
/// neighbouring one, so what a ball asks does not grow with the number of balls.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <contact/hard_sphere_times.hpp>

namespace contact {

/// When a ball leaves its cell, and through which face.
struct Crossing {
  double time = never;      ///< s
  std::int8_t axis = 0;     ///< along which it leaves
  std::int8_t towards = 0;  ///< +1 or −1
};

/// Balls in cells. The outermost cells reach to infinity, so a ball that leaves the grid is still
/// in one; there it is only more work.
///
/// A cell is a little wider than two balls (by a part in 2^16), so that a crossing whose time is
/// rounded is still long before a contact beyond it.
template <int Dimension>
class HardSphereCells {
 public:
  using Point = Column<Dimension>;  ///< m

  HardSphereCells() = default;

  /// @param low, high corners of where balls are expected, m
  /// @param widest diameter of the largest ball, m, greater than 0
  /// @param balls how many
  HardSphereCells(const Point& low, const Point& high, double widest, std::size_t balls)
      : origin_(low), next_(balls, none), previous_(balls, none), cell_(balls), list_(balls + 1) {
    width_ = widest * (1 + 0x1p-16);
    // Not many more cells than balls: memory is for what is there.
    while (!fits(high, 4 * balls + 64)) width_ *= 1.125;
    head_.assign(count_[0] * count_[1] * count_[2], none);
  }

  /// Puts a ball into the cell in which it is.
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
  /// @param ball which; its cell may be one that it reached later than `time`
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

  /// Every ball in the cells round a ball's, itself included. Overwritten by the next call.
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

  /// Bytes that it holds.
  std::size_t bytes() const {
    const std::size_t numbers =
        head_.capacity() + next_.capacity() + previous_.capacity() + list_.capacity();
    return numbers * sizeof(std::int32_t) + cell_.capacity() * sizeof(cell_[0]);
  }

 private:
  static constexpr std::int32_t none = -1;

  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

  bool fits(const Point& high, std::size_t most) {
    double all = 1;
    for (int k = 0; k < Dimension; ++k) {
      const double cells = std::max(1.0, std::ceil((high(k) - origin_(k)) / width_));
      all *= cells;
      if (!(all <= static_cast<double>(most))) return false;
      count_[at(k)] = static_cast<std::size_t>(cells);
    }
    return true;
  }

  /// Offers the times at which a flight leaves a cell along an axis on which it is pulled back by
  /// `pull`: through the face ahead while it rises, else through the one behind. Both faces are
  /// given by their distance at the flight's begin.
  template <class Offer>
  static void across(double ahead, double behind, double v, double pull, double flown,
                     bool has_ahead, bool has_behind, const Offer& offer) {
    // Rounding is monotone: a flight that fell through a face has `flown` at least as long as its
    // rise, so it is never asked for a face ahead again.
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

  /// Who is in all neighbouring cells, or of an axis only in those on one side.
  ///
  /// A cell has no ball, or one, or two: a loop over each would end when no processor expects it.
  /// So each cell's first ball is written down, and then whoever comes after one that is written,
  /// and what is nobody is overwritten.
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
  // Each cell's balls are a list: its first ball, and after each ball the next.
  std::vector<std::int32_t> next_;
  std::vector<std::int32_t> previous_;
  std::vector<std::array<std::int32_t, Dimension>> cell_;
  std::vector<std::int32_t> list_;  // who is near the one who was asked for last, and one more
};

}  // namespace contact
