/// @file
/// The number of collisions of two blocks and a wall: by simulation, by a formula, and certain.
///
/// A block of mass M slides towards one of mass m that rests in front of a wall. Everything is
/// elastic, without friction. The number of collisions, of the blocks with each other and of the
/// small one with the wall, is ⌈π/θ⌉ − 1 with θ = arctan √(m/M): for M = 100^k m it is the first k
/// + 1 digits of π.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>

#include <contact/collision_1d.hpp>
#include <contact/double_double.hpp>
#include <contact/exact.hpp>
#include <contact/vector.hpp>

namespace contact {

// [count-by-colliding]
namespace detail {

/// The count by simulation: the blocks collide until none approaches. `blocks` returns the
/// velocities of two bodies after a collision.
template <Scalar S, class Blocks>
std::int64_t count_by(const S& ratio, std::int64_t limit, const Blocks& blocks) {
  LineBody<S> large{ratio, S(1)};
  LineBody<S> small{S(1), S(0)};
  std::int64_t count = 0;
  for (; count < limit; ++count) {
    if (approaching(large, small)) {
      const LineCollision<S> after = blocks(large, small);
      large.velocity = after.first;
      small.velocity = after.second;
    } else if (small.velocity > S(0)) {
      small.velocity = -small.velocity;  // the wall
    } else {
      break;
    }
  }
  return count;
}

}  // namespace detail

/// The count by simulation with collide().
///
/// Each collision rounds, and the last one depends on the sign of a velocity that may be nearly
/// zero. So if π/θ is nearly an integer the count may be wrong.
/// @param ratio M/m, greater than 0
/// @param limit on the count
template <Scalar S>
std::int64_t count_by_colliding(const S& ratio, std::int64_t limit = 1000000) {
  return detail::count_by(ratio, limit, [](const LineBody<S>& large, const LineBody<S>& small) {
    return collide(large, small, S(1));
  });
}

/// The same with the textbook formulas, ((m₁ − m₂) v₁ + 2 m₂ v₂)/(m₁ + m₂), and as uncertain.
template <Scalar S>
std::int64_t count_by_textbook(const S& ratio, std::int64_t limit = 1000000) {
  return detail::count_by(ratio, limit, [](const LineBody<S>& large, const LineBody<S>& small) {
    const S& m1 = large.mass;
    const S& m2 = small.mass;
    const S& v1 = large.velocity;
    const S& v2 = small.velocity;
    return LineCollision<S>{true, ((m1 - m2) * v1 + S(2) * m2 * v2) / (m1 + m2),
                            ((m2 - m1) * v2 + S(2) * m1 * v1) / (m1 + m2)};
  });
}
// [/count-by-colliding]

// [arctan]
/// arctan x for 0 ≤ x ≤ 1, with the same bits on every machine: halved angles, then the series.
/// @return rad, with an error of a few u of itself
template <Scalar S>
S arctan(const S& x) {
  using std::sqrt;
  S t = x;
  int halvings = 0;
  while (t > S(0.125)) {
    t = t / (S(1) + sqrt(S(S(1) + t * t)));  // the tangent of half the angle
    ++halvings;
  }
  // x − x³/3 + x⁵/5 − …: with x ≤ 1/8 the next term is less than 2^-112 of the first.
  constexpr int terms = std::floating_point<S> ? 10 : 19;
  S sum(0);
  for (int k = terms; k >= 1; --k) sum = S(1) / S(2 * k - 1) - t * t * sum;
  S angle = t * sum;
  for (; halvings > 0; --halvings) angle = angle + angle;
  return angle;
}
// [/arctan]

// [close-call]
/// The ratio M/m for which n θ = π: cot²(π/n), by the series of the sine, with the same bits on
/// every machine.
/// @param n at least 3
/// @return with an error of at most 2^-96 of itself, for n up to 5001
inline DoubleDouble tie_ratio(int n) {
  const DoubleDouble x = DoubleDouble(4.0) * arctan(DoubleDouble(1.0)) / DoubleDouble(n);
  const DoubleDouble square = x * x;
  DoubleDouble sine(0.0);  // x − x³/3! + x⁵/5! − …
  for (int k = 27; k >= 1; k -= 2) {
    sine = DoubleDouble(1.0) - square / DoubleDouble((k + 1.0) * (k + 2.0)) * sine;
  }
  sine = x * sine;
  return DoubleDouble(1.0) / (sine * sine) - DoubleDouble(1.0);
}

/// The double nearest to tie_ratio(n), moved by some ulps. The same bits on every machine.
/// @param n at least 3
/// @param ulps number of steps to the next larger double, or smaller if negative
inline double close_call(int n, int ulps) {
  double ratio = tie_ratio(n).high();
  for (; ulps > 0; --ulps) ratio = std::nextafter(ratio, 2 * ratio);
  for (; ulps < 0; ++ulps) ratio = std::nextafter(ratio, 0.0);
  return ratio;
}
// [/close-call]

// [count-by-formula]
/// The count ⌈π/θ⌉ − 1, by the formula in S. If π/θ is nearly an integer, an error of an ulp
/// changes the count by one.
/// @param ratio M/m, at least 1
template <Scalar S>
std::int64_t count_by_formula(const S& ratio) {
  using std::sqrt;
  const S pi = S(4) * arctan(S(1));
  const S quotient = pi / arctan(S(S(1) / sqrt(ratio)));
  std::int64_t count = 0;
  if constexpr (std::floating_point<S>) {
    count = static_cast<std::int64_t>(std::ceil(quotient)) - 1;
  } else {
    count = static_cast<std::int64_t>(std::floor(quotient.high()));
    while (S(static_cast<double>(count)) >= quotient) --count;
    while (S(static_cast<double>(count + 1)) < quotient) ++count;
  }
  return count;
}
// [/count-by-formula]

namespace detail {

// [sine-sign]
/// The sign of sin(n θ) for cot θ = √R, without rounding: zⁿ for z = √R + i, as a polynomial in R.
inline int exact_sine_sign(const Exact& ratio, std::int64_t n) {
  Exact a(1.0);  // zᵏ is a√R + i b for odd k, a + i b√R for even k
  Exact b(1.0);
  for (std::int64_t k = 1; k < n; ++k) {
    const bool odd = k % 2 != 0;
    const Exact next_a = odd ? a * ratio - b : a - b;
    b = odd ? a + b : a + b * ratio;
    a = next_a;
  }
  return b.sign();
}

/// The same by repeated squaring in double-double, or nothing if the bound on its error does not
/// exclude the other sign. A product of complex numbers has an error of at most 2^-102 of itself,
/// so the error of zⁿ is less than n 2^-101; the test uses four times that bound.
inline std::optional<int> sine_sign(double ratio, std::int64_t n) {
  using Complex = std::array<DoubleDouble, 2>;
  const auto times = [](const Complex& x, const Complex& y) {
    return Complex{x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]};
  };
  const auto scaled = [](Complex x) {
    int power = 0;
    std::frexp(std::abs(x[0].high()) + std::abs(x[1].high()), &power);
    const DoubleDouble factor(std::ldexp(1.0, -power));
    return Complex{x[0] * factor, x[1] * factor};
  };
  const Complex z = scaled({sqrt(DoubleDouble(ratio)), DoubleDouble(1.0)});
  Complex whole{DoubleDouble(1.0), DoubleDouble(0.0)};
  for (int bit = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(n))) - 1; bit >= 0;
       --bit) {
    whole = scaled(times(whole, whole));
    if ((n >> bit & 1) != 0) whole = scaled(times(whole, z));
  }
  const double size = std::abs(whole[0].high()) + std::abs(whole[1].high());
  const double sine = whole[1].high();
  if (!(std::abs(sine) > static_cast<double>(n) * 0x1p-99 * size)) return std::nullopt;
  return sine > 0 ? 1 : -1;
}
// [/sine-sign]

}  // namespace detail

// [count-collisions]
/// The certain count: the largest n with n θ < π, decided by the sign of sin(n θ).
///
/// Up to a positive factor sin(n θ) is the imaginary part of (√R + i)ⁿ with R = M/m. For n ≤ 8 its
/// sign is computed without rounding; above that in double-double with a bound on its error, and if
/// the bound does not decide, nothing is returned. (Exact ties, n θ = π, occur only for R = 1 and
/// R = 3: no other cot²(π/n) is a dyadic number above 0.)
/// @param ratio M/m, as stored; finite, at least 2^-60
/// @return nothing if ratio is below 2^-60, above 1e24 or NaN, or if the bound does not decide:
/// that is not known to happen, and would need n θ within 1e-29 n of π
/// @see Galperin, *Playing pool with π*, Regular and Chaotic Dynamics 8 (2003)
inline std::optional<std::int64_t> count_collisions(double ratio) {
  if (!(ratio >= 0x1p-60 && ratio <= 1e24)) return std::nullopt;
  const auto before_turning = [ratio](std::int64_t n) -> std::optional<bool> {
    if (n <= 8) return detail::exact_sine_sign(Exact(ratio), n) > 0;
    const std::optional<int> sign = detail::sine_sign(ratio, n);
    if (!sign) return std::nullopt;
    return *sign > 0;
  };
  // Any arctan will do for the first guess, since every step from there is certain.
  const double guess = std::floor(3.141592653589793 / std::atan(1 / std::sqrt(ratio)));
  auto n = static_cast<std::int64_t>(guess < 2 ? 2 : guess);
  for (;;) {
    const std::optional<bool> here = before_turning(n);
    const std::optional<bool> next = before_turning(n + 1);
    if (!here || !next) return std::nullopt;
    if (*here && !*next) return n;
    n += *here ? 1 : -1;
  }
}
// [/count-collisions]

}  // namespace contact
