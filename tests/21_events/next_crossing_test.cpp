// Coordinates are multiples of 2^-40 m, velocities of 1/8 m/s, sizes of 1/4 m. So every time is a
// quotient of two whole numbers of 64 bits; these fractions are compared without rounding, and the
// right time is rounded once. Where two times are equal, the velocities are powers of two, so that
// any usual formula computes them exactly.
#include "next_crossing.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

namespace {

using namespace contact::testing;
using exercise::Ball;
using exercise::Crossing;

constexpr double kUnit = 0x1p-40;  // m
constexpr double kEighth = 0.125;  // m/s
constexpr double kUnitTime = kUnit / kEighth;

bool is_whole(double x) { return std::abs(x) < 0x1p50 && x == std::floor(x); }

std::int64_t whole(double x) { return static_cast<std::int64_t>(x); }

/// The time to the border on one axis as a fraction, in units of kUnitTime, not negative.
struct Fraction {
  std::int64_t over;
  std::int64_t under;  ///< greater than 0
};

bool less(const Fraction& a, const Fraction& b) { return a.over * b.under < b.over * a.under; }

std::optional<Fraction> time_along(const Ball& ball, double size, std::size_t axis) {
  const std::int64_t velocity = whole(ball.velocity[axis] / kEighth);
  if (velocity == 0) return std::nullopt;
  const std::int64_t border = (ball.cell[axis] + (velocity > 0)) * whole(size / kUnit);
  const std::int64_t distance = border - whole(ball.position[axis] / kUnit);
  return Fraction{std::max<std::int64_t>(0, velocity > 0 ? distance : -distance),
                  std::abs(velocity)};
}

Crossing along(const Ball& ball, std::size_t axis, double time) {
  const int towards = ball.velocity[axis] > 0 ? 1 : -1;
  std::array<int, 2> next_cell = ball.cell;
  next_cell[axis] += towards;
  return {time, static_cast<int>(axis), towards, next_cell};
}

std::optional<Crossing> right_crossing(const Ball& ball, double size) {
  const std::optional<Fraction> x = time_along(ball, size, 0), y = time_along(ball, size, 1);
  if (!x && !y) return std::nullopt;
  const std::size_t axis = !x || (y && less(*y, *x)) ? 1 : 0;
  const Fraction first = axis == 0 ? *x : *y;
  const double quotient = static_cast<double>(first.over) / static_cast<double>(first.under);
  return along(ball, axis, quotient * kUnitTime);
}

enum class Mistake {
  cell_from_position,
  two_cells_back,
  before_now,
  now_left_out,
  y_first,
  diagonal,
  larger_speed,
  without_velocity,
  compared_before_now
};

std::optional<Crossing> mistaken(Ball ball, double size, Mistake mistake) {
  std::optional<Crossing> first;
  std::array<double, 2> times{-1, -1};
  if (mistake == Mistake::cell_from_position) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      ball.cell[axis] = static_cast<int>(std::floor(ball.position[axis] / size));
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double velocity = ball.velocity[axis];
    if (velocity == 0 && mistake != Mistake::without_velocity) continue;
    const int back = mistake == Mistake::two_cells_back ? -1 : 0;
    const int border = ball.cell[axis] + (velocity > 0 ? 1 : back);
    double time = (border * size - ball.position[axis]) / velocity;
    const bool as_it_is = mistake == Mistake::before_now || mistake == Mistake::compared_before_now;
    if (mistake == Mistake::now_left_out && time <= 0) continue;
    if (!as_it_is) time = std::max(0.0, time);
    times[axis] = time;
    if (first) {
      const double other = std::abs(ball.velocity[0]);
      const bool later = mistake == Mistake::larger_speed ? std::abs(velocity) <= other
                         : mistake == Mistake::y_first    ? time > first->time
                                                          : !(time < first->time);
      if (later) continue;
    }
    first = along(ball, axis, time);
  }
  if (first && mistake == Mistake::compared_before_now) first->time = std::max(0.0, first->time);
  if (first && mistake == Mistake::diagonal && times[0] == times[1]) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      first->next_cell[axis] = ball.cell[axis] + (ball.velocity[axis] > 0 ? 1 : -1);
  }
  return first;
}

void check(const Ball& ball, double size) {
  const auto like = [&](Mistake mistake) {
    return [&ball, size, mistake] { return mistaken(ball, size, mistake); };
  };
  const std::optional<Crossing> right = right_crossing(ball, size);
  // Of the quotients of the formulas that are in use, none is off by more than a few units in the
  // last place of a coordinate; a time of 0 is exact.
  const double allowed = right && right->time > 0 ? 0x1p-44 * (1 + right->time) : 0;
  ask("How does the ball leave its cell, and when?")
      .given("ball", ball)
      .given("size", size)
      .suspect("crossing-cell-from-position", like(Mistake::cell_from_position))
      .suspect("crossing-two-cells-back", like(Mistake::two_cells_back))
      .suspect("crossing-before-now", like(Mistake::before_now))
      .suspect("crossing-now-left-out", like(Mistake::now_left_out))
      .suspect("crossing-y-first", like(Mistake::y_first))
      .suspect("crossing-into-the-diagonal-cell", like(Mistake::diagonal))
      .suspect("crossing-by-larger-speed", like(Mistake::larger_speed))
      .suspect("crossing-without-velocity", like(Mistake::without_velocity))
      .suspect("crossing-compared-before-now", like(Mistake::compared_before_now))
      .answer([&] { return exercise::next_crossing(ball, size); })
      .close_to(right, within(allowed));
}

bool is_power_of_two(double x) {
  int exponent = 0;
  return x == 0 || std::abs(std::frexp(x, &exponent)) == 0.5;
}

/// Whether the contract allows the input, and rounding cannot decide.
bool judged(const Ball& ball, double size) {
  if (!(size >= 0.25 && size <= 4) || !is_whole(size * 4)) return false;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double position = ball.position[axis], velocity = ball.velocity[axis];
    if (!is_whole(position / kUnit) || !is_whole(velocity / kEighth)) return false;
    if (std::abs(velocity) > 8 || std::abs(ball.cell[axis]) > 8) return false;
    const double lower = ball.cell[axis] * size;
    if (!(position >= lower - 4 * kUnit && position <= lower + size + 4 * kUnit)) return false;
  }
  const std::optional<Fraction> x = time_along(ball, size, 0), y = time_along(ball, size, 1);
  const bool tie = x && y && !less(*x, *y) && !less(*y, *x);
  return !tie || (is_power_of_two(ball.velocity[0]) && is_power_of_two(ball.velocity[1]) &&
                  is_power_of_two(size));
}

}  // namespace

TEST_CASE("a ball leaves through the border that it reaches first") {
  check({{2.25, 3.5}, {1, 0}, {2, 3}}, 1);
  check({{2.25, 3.5}, {-1, 0}, {2, 3}}, 1);
  check({{2.25, 3.875}, {2, 1}, {2, 3}}, 1);
  check({{2.75, 3.125}, {1, -1}, {2, 3}}, 1);
  check({{-3.5, -0.5}, {-1, -1}, {-2, -1}}, 2);
  check({{-3.5, -0.5}, {-0.25, 0.5}, {-2, -1}}, 2);
}

TEST_CASE("a ball without velocity along an axis crosses no border there") {
  check({{2.25, 3.5}, {0, 2}, {2, 3}}, 1);
  check({{2.25, 3.5}, {-0.0, -2}, {2, 3}}, 1);
  check({{2.25, 3.5}, {0, 0}, {2, 3}}, 1);
  check({{2, 4}, {-0.0, 0}, {2, 3}}, 1);
}

TEST_CASE("on a border the stored cell decides") {
  check({{3, 3.5}, {1, 0}, {2, 3}}, 1);
  check({{3, 3.5}, {1, 0}, {3, 3}}, 1);
  check({{3, 3.5}, {-1, 0}, {2, 3}}, 1);
  check({{3, 3.5}, {-1, 0}, {3, 3}}, 1);
  check({{3, 3.5}, {0, 2}, {2, 3}}, 1);
  check({{-4, -3}, {0.5, -2}, {-2, -2}}, 2);
  check({{-4, -4}, {-0.5, -2}, {-3, -2}}, 2);
}

TEST_CASE("at a corner the crossing in x comes first") {
  check({{2.5, 3.5}, {1, 1}, {2, 3}}, 1);
  check({{2.5, 3.5}, {-1, 1}, {2, 3}}, 1);
  check({{2.5, 3.75}, {0.5, 0.25}, {2, 3}}, 1);
  check({{3, 4}, {1, 4}, {2, 3}}, 1);
  // After the crossing in x, the one in y follows at once.
  check({{3, 4}, {1, 4}, {3, 3}}, 1);
  check({{-4, -4}, {-2, -0.125}, {-2, -2}}, 2);
}

TEST_CASE("a ball beyond its border crosses it now") {
  check({{3 + kUnit, 3.5}, {1, 0}, {2, 3}}, 1);
  check({{2 - kUnit, 3.5}, {-0.125, 2}, {2, 3}}, 1);
  check({{3 + kUnit, 3.5}, {-1, 0}, {2, 3}}, 1);
  // Both borders are behind the ball, so both crossings are now.
  check({{3 + kUnit, 4 + 3 * kUnit}, {1, 1}, {2, 3}}, 1);
  check({{3, 4 + kUnit}, {2, 2}, {2, 3}}, 1);
}

TEST_CASE("random balls agree with fractions") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 400; ++asked) {
    const double size =
        random.chance(0.5) ? std::ldexp(1.0, random.integer(-2, 2)) : 0.25 * random.integer(1, 16);
    Ball ball{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      ball.cell[axis] = random.integer(-5, 5);
      const double part = random.chance(0.3) ? random.integer(0, 1) : random.integer(0, 64) / 64.0;
      ball.position[axis] = (ball.cell[axis] + part) * size;
      if (random.chance(0.1)) ball.position[axis] += random.integer(-4, 4) * kUnit;
      if (random.chance(0.4)) {
        // In statements of their own: the order of the factors' draws would be the compiler's
        // choice.
        const int sign = random.chance(0.5) ? 1 : -1;
        ball.velocity[axis] = sign * std::ldexp(1.0, random.integer(-3, 2));
      } else {
        ball.velocity[axis] = kEighth * random.integer(-20, 20);
      }
    }
    if (judged(ball, size)) shrinkable(check, judged, ball, size);
  }
}
