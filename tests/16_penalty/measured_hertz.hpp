/// @file
/// Methods for the duration of an impact on Hertz's contact, as the ladder measures them.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/double_double.hpp>
#include <contact/hertz.hpp>
#include <contact/penalty_step.hpp>

#include "support/ladder.hpp"

namespace measured_hertz {

using contact::DoubleDouble;

/// A ball that meets a surface.
struct Input {
  contact::HertzContact<double> contact;
  double mass = 1, speed = 1;  ///< kg, m/s
};

/// Duration of the contact, s.
using Answer = double;

/// x^(1/5) for x from 1 to 2^9, by Newton's method from the double.
inline DoubleDouble fifth_root(const DoubleDouble& x) {
  DoubleDouble s = contact::detail::root_of(x.high(), 5);
  for (int i = 0; i < 2; ++i) {
    const DoubleDouble square = s * s;
    s = s - (s - x / (square * square)) / DoubleDouble(5);
  }
  return s;
}

/// ∫ dx / √(1 − x^(5/2)) from 0 to 1 with 30 digits, by the two series of hertz_rise() and
/// hertz_slowing().
inline DoubleDouble wide_half_duration() {
  const DoubleDouble half = 0.5, one = 1, five = 5;
  DoubleDouble rise = 0, slowing = 0;
  for (int n = 110; n >= 1; --n) {
    const DoubleDouble k = n;
    rise = (k - half) / k * half * (one / (one + five * half * k) + rise);
    slowing = (k - DoubleDouble(2) / five) / k * half * (one / (k + k + one) + slowing);
  }
  // (1/2)^(1/5) is half of the fifth root of 16.
  const DoubleDouble root = fifth_root(16) * half;
  return root * root * (one + rise) + DoubleDouble(4) / five * sqrt(half) * (one + slowing);
}

// [wide]
/// 2 C d / v with d = (5/4 m v² / κ)^(2/5), in double-double arithmetic.
inline Answer wide(const Input& input) {
  static const DoubleDouble half_duration = wide_half_duration();
  int of_m = 0, of_v = 0, of_k = 0;
  const DoubleDouble m = std::frexp(input.mass, &of_m), v = std::frexp(input.speed, &of_v);
  const DoubleDouble k = std::frexp(input.contact.stiffness, &of_k);
  const DoubleDouble quotient = DoubleDouble(1.25) * m * v * v / k;  // from 5/32 to 5/2
  // It is 2^(5 q) times a number from 1 to 2^9.
  const int power = of_m + 2 * of_v - of_k - 3;
  const int q = power >= 0 ? power / 5 : -((4 - power) / 5);
  const DoubleDouble root = fifth_root(quotient * DoubleDouble(std::ldexp(1.0, power + 3 - 5 * q)));
  const DoubleDouble time = DoubleDouble(2) * half_duration * root * root / v;
  return std::ldexp(time.high(), 2 * q - of_v);
}
// [/wide]

/// Wrong is a duration that is off by more than 1,000 units roundoff of double.
inline ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.error = std::abs(got / right - 1);
  verdict.wrong = !(verdict.error <= 1000 * 0x1p-53);
  return verdict;
}

/// (5/4 m v² / κ)^(2/5) as it is written.
inline double plain_depth(const Input& input) {
  return std::pow(1.25 * input.mass * input.speed * input.speed / input.contact.stiffness, 0.4);
}

/// A spring that is as deep by the same energy takes π d / v.
inline Answer linear(const Input& input) {
  return contact::detail::pi * plain_depth(input) / input.speed;
}

/// The constant of textbooks, typed.
inline Answer typed(const Input& input) { return 2.94 * plain_depth(input) / input.speed; }

inline double integrand(double x) { return 1 / std::sqrt(1 - x * x * std::sqrt(x)); }

// [quadrature]
/// The integral by the midpoint rule. It has a pole at the greatest depth, so the error falls with
/// the root of the width only.
inline Answer midpoints(const Input& input, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += integrand((i + 0.5) / count);
  return 2 * sum / count * plain_depth(input) / input.speed;
}

/// The same after x = 1 − s², dx = −2 s ds, which takes the pole away.
inline Answer substituted(const Input& input, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double s = (i + 0.5) / count;
    sum += 2 * s * integrand((1 - s) * (1 + s));
  }
  return 2 * sum / count * plain_depth(input) / input.speed;
}
// [/quadrature]

/// Steps of velocity Verlet, about `count` in a contact; the last one is cut by its end.
inline Answer in_steps(const Input& input, int count) {
  const double h = 3 * plain_depth(input) / input.speed / count;
  const auto acceleration = [&input](double depth) {
    return -contact::hertz_force(input.contact, std::max(0.0, depth)) / input.mass;
  };
  double depth = 0, approach = input.speed, pull = 0;
  for (int i = 0; i < 2 * count; ++i) {
    const double middle = approach + pull * h / 2, next = depth + h * middle;
    if (next < 0) return (i + depth / (depth - next)) * h;
    depth = next;
    pull = acceleration(depth);
    approach = middle + pull * h / 2;
  }
  return std::nan("");
}

inline Answer book(const Input& input) {
  return contact::hertz_impact(input.contact, input.mass, input.speed).duration;
}

inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right) {
  ladder::Example example;
  example.facts = {
      ladder::number("κ, N/m^(3/2)", input.contact.stiffness),
      ladder::number("mass, kg", input.mass), ladder::number("speed, m/s", input.speed),
      ladder::number("duration by this method, s", got), ladder::number("duration, s", right)};
  example.note = "The figures have linear springs only.";
  return example;
}

inline ladder::Ladder<Input, Answer> experiment() {
  using generators::Random;
  ladder::Ladder<Input, Answer> ladder("How long is the contact of two elastic balls?", wide,
                                       judge);
  const auto family = [&ladder](const char* id, const char* title, int bits) {
    ladder.family(
        id, title,
        [bits](Random& random) {
          return Input{{1e9 * std::abs(random.magnitude(-bits, bits))},
                       std::abs(random.magnitude(-bits, bits)),
                       std::abs(random.magnitude(-bits, bits))};
        },
        true);
  };
  family("steel", "steel balls: κ near 10⁹, m near 1 kg, v near 1 m/s", 5);
  family("every-magnitude", "each from 2⁻²⁰⁰ to 2²⁰⁰", 200);
  family("extreme", "each from 2⁻⁶⁰⁰ to 2⁶⁰⁰", 600);
  ladder.at_most(2000);

  const auto rounded = [](const char* id, const char* title) {
    return ladder::Method{.id = id, .title = title, .scalar = "double", .exact = false};
  };
  ladder.method(rounded("linear", "a linear spring as deep: π d / v"), linear);
  ladder.method(rounded("typed", "2.94 d / v"), typed);
  const auto counted = [&](const char* id, const char* title, auto method, int count) {
    ladder.method(rounded(id, title), [=](const Input& input) { return method(input, count); });
  };
  counted("midpoints-100", "100 midpoints", midpoints, 100);
  counted("midpoints-10000", "10,000 midpoints", midpoints, 10000);
  counted("substituted-100", "100 midpoints, pole taken away", substituted, 100);
  counted("substituted-10000", "10,000 midpoints, pole taken away", substituted, 10000);
  counted("verlet-100-steps", "100 steps of velocity Verlet", in_steps, 100);
  counted("verlet-10000-steps", "10,000 steps of velocity Verlet", in_steps, 10000);
  ladder.method({.id = "hertz", .title = "the book's series", .scalar = "double", .exact = true},
                book);
  ladder.method(
      {.id = "hertz-wide", .title = "with 30 digits", .scalar = "double-double", .exact = true},
      wide);
  ladder.recommend("hertz");
  ladder.show([](const Input& input, const Answer& got, const Answer& right,
                 const ladder::Method&) { return shown(input, got, right); });
  return ladder;
}

}  // namespace measured_hertz
