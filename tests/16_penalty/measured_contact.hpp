/// @file
/// Methods for the duration and the depth of a contact, as the ladder measures them.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/double_double.hpp>
#include <contact/spring_impact.hpp>

#include "support/ladder.hpp"

namespace measured_contact {

using contact::DoubleDouble;
using contact::SpringDamper;

template <std::floating_point S>
struct Impact {
  SpringDamper<S> spring;
  S mass = 1, speed = 1;  ///< kg, m/s
};

/// The same impact in double and in float; the conversion is not timed.
struct Input {
  Impact<double> in_double;
  Impact<float> in_float;  ///< each number rounded to the nearest
};

/// Until the force is 0, and greatest penetration.
template <std::floating_point S>
struct Size {
  S duration = 0;  ///< s
  S depth = 0;     ///< m
};

/// The truth says both of the floats and of the doubles, in double.
struct Answer {
  bool of_floats = false;
  Size<float> told_in_float;  ///< by a method
  Size<double> in_float, in_double;

  /// What a method answered, or what is right for the same numbers.
  Size<double> told(bool floats) const {
    if (!floats) return in_double;
    return {double(told_in_float.duration), double(told_in_float.depth)};
  }
  Size<double> right(bool floats) const { return floats ? in_float : in_double; }
};

inline Input made(double k, double c, double mass, double speed) {
  const auto narrow = [](double x) { return static_cast<float>(x); };
  return {{{k, c}, mass, speed}, {{narrow(k), narrow(c)}, narrow(mass), narrow(speed)}};
}

/// e^(−y) for y ≥ 0 with a relative error of about 1e-29 while it is a normal number.
inline DoubleDouble wide_decay(const DoubleDouble& y) {
  const DoubleDouble log_two =
      DoubleDouble(0.6931471805599453) + DoubleDouble(2.3190468138462996e-17);
  if (!(y.high() < 700)) return 0;
  const double n = std::nearbyint(y.high() / log_two.high());
  const DoubleDouble r = y - DoubleDouble(n) * log_two;
  DoubleDouble sum = 1;
  for (int k = 28; k >= 1; --k) sum = DoubleDouble(1) - r * sum / DoubleDouble(k);
  const double scale = std::ldexp(1.0, -static_cast<int>(n));
  return sum * DoubleDouble(scale);
}

// [wide]
/// The book's formulas in double-double arithmetic: about 30 digits.
template <std::floating_point S>
Size<double> wide(const Impact<S>& impact) {
  const DoubleDouble k = static_cast<double>(impact.spring.stiffness);
  const DoubleDouble c = static_cast<double>(impact.spring.damping);
  const DoubleDouble m = static_cast<double>(impact.mass), v = static_cast<double>(impact.speed);
  const DoubleDouble one = 1, two = 2;
  const DoubleDouble rate = sqrt(k / m), ratio = c / (two * sqrt(k * m));
  DoubleDouble w = two / (one + ratio), quotient = w;
  while (std::abs(1 - w.high()) > 0.0625) {
    const DoubleDouble root = sqrt(w);
    quotient = quotient * two / (one + root);
    w = two * root / (one + root);
  }
  DoubleDouble sum = 0;
  for (int i = 30; i >= 0; --i) sum = sum * (one - w) + one / DoubleDouble(2 * i + 1);
  quotient = quotient * sum;
  const DoubleDouble depth = v / rate * wide_decay(ratio * quotient);
  return {(two * quotient / rate).high(), depth.high()};
}
// [/wide]

// [textbook]
/// The underdamped formulas of textbooks: arccos, and divisions by √(1 − ζ²).
template <std::floating_point S>
Size<S> textbook(const Impact<S>& impact) {
  const S rate = std::sqrt(impact.spring.stiffness / impact.mass);
  const S ratio = impact.spring.damping / (2 * std::sqrt(impact.spring.stiffness * impact.mass));
  const S sine = std::sqrt(1 - ratio * ratio);
  const S angle = std::acos(ratio);
  return {2 * angle / (rate * sine), impact.speed / rate * std::exp(-ratio * angle / sine)};
}
// [/textbook]

/// The three cases of textbooks, by the rounded damping ratio.
template <std::floating_point S>
Size<S> three_cases(const Impact<S>& impact) {
  const S rate = std::sqrt(impact.spring.stiffness / impact.mass);
  const S ratio = impact.spring.damping / (2 * std::sqrt(impact.spring.stiffness * impact.mass));
  if (ratio < 1) return textbook(impact);
  S quotient = 1;
  if (ratio > 1) quotient = std::acosh(ratio) / std::sqrt(ratio * ratio - 1);
  return {2 * quotient / rate, impact.speed / rate * std::exp(-ratio * quotient)};
}

/// The duration without a damper, π √(m / k), and the depth by energy.
template <std::floating_point S>
Size<S> undamped(const Impact<S>& impact) {
  const S root = std::sqrt(impact.mass / impact.spring.stiffness);
  return {S(contact::detail::pi) * root, impact.speed * root};
}

template <std::floating_point S>
Size<S> book(const Impact<S>& impact) {
  const auto result = contact::spring_impact(impact.spring, impact.mass, impact.speed);
  return {result.duration, result.max_depth};
}

inline Answer truth(const Input& input) {
  return {false, {}, wide(input.in_float), wide(input.in_double)};
}

/// Wrong is a duration or a depth that is off by more than 1,000 units roundoff of its type: the
/// book's formulas have a proven bound below it for the families' damping ratios.
inline ladder::Verdict judge(const Answer& got, const Answer& right) {
  const Size<double> told = got.told(got.of_floats), exact = right.right(got.of_floats);
  ladder::Verdict verdict;
  const double late = std::abs(told.duration / exact.duration - 1);
  const double deep = std::abs(told.depth / exact.depth - 1);
  const double unit = got.of_floats ? 0x1p-24 : 0x1p-53;
  verdict.wrong = !(late <= 1000 * unit && deep <= 1000 * unit);
  verdict.error = std::isnan(late + deep) ? std::nan("") : std::max(late, deep);
  return verdict;
}

/// k, m and v of every kind, with a damper for ζ.
inline Input with_ratio(generators::Random& random, double ratio) {
  const double k = std::abs(random.magnitude(4, 20)), mass = std::abs(random.magnitude(-6, 6));
  const double speed = std::abs(random.magnitude(-6, 4));
  return made(k, 2 * ratio * std::sqrt(k) * std::sqrt(mass), mass, speed);
}

inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right) {
  const auto& impact = input.in_double;
  const Size<double> told = got.told(got.of_floats), exact = right.right(got.of_floats);
  const double ratio = contact::damping_ratio(impact.spring, impact.mass);
  ladder::Example example;
  example.facts = {ladder::number("k, N/m", impact.spring.stiffness),
                   ladder::number("c, N s/m", impact.spring.damping),
                   ladder::number("mass, kg", impact.mass),
                   ladder::number("speed, m/s", impact.speed),
                   ladder::number("damping ratio, rounded", ratio),
                   ladder::number("duration by this method, s", told.duration),
                   ladder::number("depth by this method, m", told.depth),
                   ladder::number("duration, s", exact.duration),
                   ladder::number("depth, m", exact.depth)};
  if (ratio > 1.5) {
    example.note = "The figure shows damping ratios up to 1.5.";
    return example;
  }
  example.figure = "soft_to_rigid";
  example.fields = {{"hardness", {0.2}}, {"ratio", {ratio}}, {"time", {0.05}}, {"release", {0}}};
  example.note =
      "The figure shows a contact with this damping ratio, by the book's formulas; its stiffness, "
      "mass and speed are others.";
  return example;
}

inline ladder::Ladder<Input, Answer> experiment() {
  using generators::Random;
  ladder::Ladder<Input, Answer> ladder("How long is a contact, and how deep?", truth, judge);
  ladder.family("underdamped", "ζ from 0.01 to 0.9",
                [](Random& random) { return with_ratio(random, random.uniform(0.01, 0.9)); });
  ladder.family("weak", "ζ below a millionth", [](Random& random) {
    return with_ratio(random, std::abs(random.magnitude(-60, -20)));
  });
  ladder.family("nearly-critical", "ζ within 2⁻²⁰ to 2⁻⁵⁰ of 1",
                [](Random& random) { return with_ratio(random, 1 + random.magnitude(-50, -20)); });
  ladder.family("critical", "c² = 4 k m exactly", [](Random& random) {
    const int root_k = random.integer(1, 4000), root_m = random.integer(1, 4000);
    const double k = double(root_k) * root_k, mass = double(root_m) * root_m;
    return made(k, 2.0 * root_k * root_m, mass, random.uniform(0.1, 10));
  });
  ladder.family("overdamped", "ζ from 1.1 to 20",
                [](Random& random) { return with_ratio(random, random.uniform(1.1, 20)); });

  const auto in_double = [&ladder](const char* id, const char* title, bool exact, auto method) {
    ladder.method({.id = id, .title = title, .scalar = "double", .exact = exact},
                  [method](const Input& input) {
                    return Answer{false, {}, {}, method(input.in_double)};
                  });
  };
  const auto in_float = [&ladder](const char* id, const char* title, bool exact, auto method) {
    ladder.method({.id = id, .title = title, .scalar = "float", .exact = exact},
                  [method](const Input& input) {
                    return Answer{true, method(input.in_float), {}, {}};
                  });
  };
  in_double("undamped", "the damper left out", false, undamped<double>);
  in_float("textbook-float", "arccos, divided by √(1 − ζ²)", false, textbook<float>);
  in_double("textbook-double", "arccos, divided by √(1 − ζ²)", false, textbook<double>);
  in_float("cases-float", "three cases by ζ", false, three_cases<float>);
  in_double("cases-double", "three cases by ζ", false, three_cases<double>);
  in_float("book-float", "the book's θ / sin θ", true, book<float>);
  in_double("book-double", "the book's θ / sin θ", true, book<double>);
  ladder.method(
      {.id = "wide", .title = "the same with 30 digits", .scalar = "double-double", .exact = true},
      [](const Input& input) {
        return Answer{false, {}, {}, wide(input.in_double)};
      });
  ladder.recommend("book-double");
  ladder.show([](const Input& input, const Answer& got, const Answer& right,
                 const ladder::Method&) { return shown(input, got, right); });
  return ladder;
}

}  // namespace measured_contact
