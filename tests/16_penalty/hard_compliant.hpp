/// @file
/// Hertz's contact, Hunt and Crossley's damper and stacks on springs: right answers, and methods as
/// they are often written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/hertz.hpp>
#include <contact/hunt_crossley.hpp>
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_stack.hpp>
#include <limits>
#include <vector>

#include "hard_contact.hpp"

namespace hard_compliant {

using hard_cases::Case;
using hard_cases::Json;
using hard_contact::nearest_text;
using hard_contact::same;
using hard_contact::turn;
using oracle::Interval;
using oracle::Rational;

// ------------------------------------------------------------------------------- Hertz's impact

inline Interval fraction(int numerator, int denominator, unsigned bits) {
  return Interval(Rational(numerator, denominator), bits);
}
/// x^(p/q) for x > 0.
inline Interval power(const Interval& x, int p, int q) {
  return exp(fraction(p, q, x.bits()) * log(x));
}
/// Σ (a)ₙ / n! 2^-n / (1 + b n): the terms are positive and each is less than half of the one
/// before it, so that all that are left out are less than the last one.
inline Interval half_series(const Rational& a, const Rational& b, unsigned bits) {
  Rational sum(0), term(1), last(0);
  for (unsigned n = 0; n <= bits + 8; ++n) {
    last = term / (1 + b * n);
    sum += last;
    term = term * (a + n) / (2 * (n + 1));
  }
  return Interval(sum, sum + last, bits);
}
/// 4/5 B(2/5, 1/2), the duration over depth and speed: the integral 2 ∫ dx / √(1 − x^(5/2)) from 0
/// to 1, split where x^(5/2) = 1/2.
inline Interval duration_factor(unsigned bits) {
  const Interval half = fraction(1, 2, bits);
  const Interval rise = power(half, 2, 5) * half_series(Rational(1, 2), Rational(5, 2), bits);
  const Interval rest =
      fraction(4, 5, bits) * sqrt(half) * half_series(Rational(3, 5), Rational(2), bits);
  return fraction(2, 1, bits) * (rise + rest);
}
/// (5/4 m v² / κ)^(2/5).
inline Interval hertz_depth(const Case& c, unsigned bits) {
  const Rational v = oracle::exact(c.number("speed"));
  const Rational energy = oracle::exact(c.number("mass")) * v * v * 5 / 4;
  return power(Interval(Rational(energy / oracle::exact(c.number("stiffness"))), bits), 2, 5);
}

/// Depth and duration, both of which must be right.
inline void add_hertz(hard_cases::Runner& runner) {
  runner.question("Hertz", [](const Case& c) {
    return Json{{"class", "c"},
                {"depth", nearest_text([&](unsigned bits) { return hertz_depth(c, bits); })},
                {"t", nearest_text([&](unsigned bits) {
                   return duration_factor(bits) * hertz_depth(c, bits) /
                          Interval(oracle::exact(c.number("speed")), bits);
                 })}};
  });
  struct Result {
    double depth, t;
  };
  const auto method = [&runner](const char* name, auto impact) {
    runner.method("Hertz", name, [impact](const Case& c, const Json& answer) {
      const Result got = impact(c.number("stiffness"), c.number("mass"), c.number("speed"));
      return same(got.depth, answer, "depth") && same(got.t, answer, "t");
    });
  };
  method("a linear spring", [](double k, double m, double v) {
    return Result{v * std::sqrt(m / k), turn * std::sqrt(m / k)};
  });
  method("2.94 d/v", [](double k, double m, double v) {
    const double d = std::pow(1.25 * m * v * v / k, 0.4);
    return Result{d, 2.94 * d / v};
  });
  method("pow and tgamma", [](double k, double m, double v) {
    const double d = std::pow(1.25 * m * v * v / k, 0.4);
    return Result{d, 0.8 * std::tgamma(0.4) * std::sqrt(turn) / std::tgamma(0.9) * d / v};
  });
  method("book", [](double k, double m, double v) {
    const auto impact = contact::hertz_impact(contact::hertz_contact(k), m, v);
    return Result{impact.max_depth, impact.duration};
  });
}

// ------------------------------------------------------------------------ Hunt and Crossley's e

/// The root q of −q − ln(1 − q) = p − ln(1 + p) over p, by bisection with certain signs.
inline Interval restitution(const Rational& p, unsigned bits) {
  const unsigned more = 8 * bits;
  const auto sign_at = [&](const Rational& e) {
    const Rational q = p * e;
    return (log(Interval(Rational(1 + p), more)) - log(Interval(Rational(1 - q), more)) -
            Interval(Rational(p + q), more))
        .sign();
  };
  Rational low(0), high = p < 1 ? Rational(1) : Rational(1 / p);
  for (unsigned i = 0; i < 2 * bits; ++i) {
    const Rational middle = (low + high) / 2;
    const auto sign = sign_at(middle);
    if (!sign) break;
    (*sign < 0 ? low : high) = middle;
  }
  return Interval(low, high, bits);
}

inline void add_hunt_crossley(hard_cases::Runner& runner) {
  runner.question("Hunt-Crossley", [](const Case& c) {
    const Rational p = oracle::exact(c.number("dissipation")) * oracle::exact(c.number("speed"));
    if (p == 0) return Json{{"class", "a"}, {"e", hard_cases::hex(1.0)}};
    return Json{{"class", "c"},
                {"e", nearest_text([&](unsigned bits) { return restitution(p, bits); })}};
  });
  const auto method = [&runner](const char* name, auto e) {
    runner.method("Hunt-Crossley", name, [e](const Case& c, const Json& answer) {
      return same(e(c.number("dissipation"), c.number("speed")), answer, "e");
    });
  };
  method("1 − 2λv/3", [](double l, double v) { return 1 - 2 * l * v / 3; });
  method("1/(1 + 2λv/3)", [](double l, double v) { return 1 / (1 + 2 * l * v / 3); });
  method("bisection with std::log", [](double l, double v) {
    const double p = l * v;
    const double target = p - std::log(1 + p);
    double low = 0, high = 1;
    for (int i = 0; i < 80; ++i) {
      const double q = (low + high) / 2;
      (-q - std::log(1 - q) < target ? low : high) = q;
    }
    return p > 0 ? high / p : 1.0;
  });
  method("book", [](double l, double v) {
    return contact::hunt_crossley_restitution(contact::hunt_crossley(1.0, l), v);
  });
}

/// Whether 1 + λ δ̇ is negative at an overlap: where only another force brings a body.
inline void add_pull(hard_cases::Runner& runner) {
  runner.question("pull", [](const Case& c) {
    const Rational product =
        oracle::exact(c.number("dissipation")) * oracle::exact(c.number("approach"));
    return Json{{"class", "a"}, {"pulls", product < -1}};
  });
  const auto method = [&runner](const char* name, auto pulls) {
    runner.method("pull", name, [pulls](const Case& c, const Json& answer) {
      return pulls(c.number("dissipation"), c.number("approach")) == answer.at("pulls").get<bool>();
    });
  };
  method("it never pulls", [](double, double) { return false; });
  method("1 + λ δ̇ < 0", [](double l, double v) { return 1 + l * v < 0; });
  method("δ̇ < −1/λ", [](double l, double v) { return v < -1 / l; });
  method("book",
         [](double l, double v) { return contact::would_pull(contact::hunt_crossley(1.0, l), v); });
}

// --------------------------------------------------------------------------------------- stacks

/// How far the top of a stack sinks: each contact carries all above it.
inline void add_sag(hard_cases::Runner& runner) {
  runner.question("sag", [](const Case& c) {
    const auto masses = c.numbers("masses");
    const auto stiffness = c.numbers("stiffness");
    Rational sag(0), above(0);
    for (std::size_t i = masses.size(); i-- > 0;) {
      above += oracle::exact(masses[i]);
      sag += above * oracle::exact(c.number("gravity")) / oracle::exact(stiffness[i]);
    }
    return Json{{"class", "a"}, {"sag", hard_cases::hex(sag)}};
  });
  const auto method = [&runner](const char* name, auto sag) {
    runner.method("sag", name, [sag](const Case& c, const Json& answer) {
      return same(sag(c.numbers("masses"), c.numbers("stiffness"), c.number("gravity")), answer,
                  "sag");
    });
  };
  using Numbers = std::vector<double>;
  method("each contact its own body", [](const Numbers& m, const Numbers& k, double g) {
    double sum = 0;
    for (std::size_t i = 0; i < m.size(); ++i) sum += m[i] * g / k[i];
    return sum;
  });
  method("springs in series under all", [](const Numbers& m, const Numbers& k, double g) {
    double mass = 0, compliance = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      mass += m[i];
      compliance += 1 / k[i];
    }
    return mass * g * compliance;
  });
  method("float", [](const Numbers& m, const Numbers& k, double g) {
    float sum = 0, above = 0;
    for (std::size_t i = m.size(); i-- > 0;) {
      above += float(m[i]);
      sum += above * float(g) / float(k[i]);
    }
    return double(sum);
  });
  method("book", [](const Numbers& m, const Numbers& k, double g) {
    return contact::stack_at_rest(contact::spring_stack(m, k), g).displacement.back();
  });
}

/// The longest stable step of semi-implicit Euler for n equal bodies: √(m / k) / cos(π / (2 n +
/// 1)), or for two bodies: 2 / ω with ω² the larger root of a quadratic.
inline void add_stack_step(hard_cases::Runner& runner) {
  runner.question("stack step", [](const Case& c) {
    const auto masses = c.numbers("masses");
    const auto stiffness = c.numbers("stiffness");
    const auto at = [](const std::vector<double>& all, std::size_t i) {
      return oracle::exact(all[i]);
    };
    const bool equal = masses == std::vector<double>(masses.size(), masses[0]) &&
                       stiffness == std::vector<double>(masses.size(), stiffness[0]);
    const auto value = [&](unsigned bits) {
      if (equal) {
        const auto n = static_cast<int>(masses.size());
        return sqrt(Interval(Rational(at(masses, 0) / at(stiffness, 0)), bits)) /
               cos(Interval::pi(bits) / fraction(2 * n + 1, 1, bits));
      }
      const Rational p =
          (at(stiffness, 0) + at(stiffness, 1)) / at(masses, 0) + at(stiffness, 1) / at(masses, 1);
      const Rational q = at(stiffness, 0) * at(stiffness, 1) / (at(masses, 0) * at(masses, 1));
      const Interval square =
          (Interval(p, bits) + sqrt(Interval(p * p - 4 * q, bits))) * fraction(1, 2, bits);
      return fraction(2, 1, bits) / sqrt(square);
    };
    return Json{{"class", "c"}, {"h", nearest_text(value)}};
  });
  const auto method = [&runner](const char* name, auto step) {
    runner.method("stack step", name, [step](const Case& c, const Json& answer) {
      return same(step(c.numbers("masses"), c.numbers("stiffness")), answer, "h");
    });
  };
  using Numbers = std::vector<double>;
  method("each body alone", [](const Numbers& m, const Numbers& k) {
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m.size(); ++i) step = std::min(step, 2 * std::sqrt(m[i] / k[i]));
    return step;
  });
  method("half of that", [](const Numbers& m, const Numbers& k) {
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m.size(); ++i) step = std::min(step, std::sqrt(m[i] / k[i]));
    return step;
  });
  method("all as one body", [](const Numbers& m, const Numbers& k) {
    double mass = 0;
    for (const double x : m) mass += x;
    return 2 * std::sqrt(mass / k[0]);
  });
  method("book", [](const Numbers& m, const Numbers& k) {
    return contact::stack_step_limit(contact::spring_stack(m, k));
  });
}

/// A step of a chain that starts unloaded, all bodies with one speed downwards: the velocities
/// after it solve (M + h² K) v' = M (v + h g), here by elimination in the number type.
template <class S>
std::vector<S> chain_step(const std::vector<S>& m, const std::vector<S>& k, const S& h, const S& v,
                          const S& g) {
  const std::size_t n = m.size();
  std::vector<S> diagonal(n), right(n);
  for (std::size_t i = 0; i < n; ++i) {
    diagonal[i] = m[i] + h * h * (i + 1 < n ? S(k[i] + k[i + 1]) : k[i]);
    right[i] = m[i] * (v + h * g);
    if (i == 0) continue;
    const S beside = h * h * k[i];
    diagonal[i] = diagonal[i] - beside * beside / diagonal[i - 1];
    right[i] = right[i] + beside * right[i - 1] / diagonal[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) right[i] = right[i] + h * h * k[i + 1] * right[i + 1];
    right[i] = right[i] / diagonal[i];
  }
  return right;
}

inline void add_implicit_chain(hard_cases::Runner& runner) {
  runner.question("implicit chain", [](const Case& c) {
    const auto exact = [](const std::vector<double>& all) {
      std::vector<Rational> made;
      for (const double x : all) made.push_back(oracle::exact(x));
      return made;
    };
    const auto v = chain_step<Rational>(
        exact(c.numbers("masses")), exact(c.numbers("stiffness")), oracle::exact(c.number("step")),
        oracle::exact(c.number("speed")), oracle::exact(c.number("gravity")));
    return Json{
        {"class", "a"}, {"bottom", hard_cases::hex(v.front())}, {"top", hard_cases::hex(v.back())}};
  });
  const auto method = [&runner](const char* name, auto step) {
    runner.method("implicit chain", name, [step](const Case& c, const Json& answer) {
      const std::vector<double> got = step(c);
      return same(got.front(), answer, "bottom") && same(got.back(), answer, "top");
    });
  };
  method("elimination in float", [](const Case& c) {
    const auto floats = [](const std::vector<double>& all) {
      return std::vector<float>(all.begin(), all.end());
    };
    const auto v = chain_step<float>(floats(c.numbers("masses")), floats(c.numbers("stiffness")),
                                     float(c.number("step")), float(c.number("speed")),
                                     float(c.number("gravity")));
    return std::vector<double>(v.begin(), v.end());
  });
  method("elimination as it stands", [](const Case& c) {
    return chain_step<double>(c.numbers("masses"), c.numbers("stiffness"), c.number("step"),
                              c.number("speed"), c.number("gravity"));
  });
  method("book", [](const Case& c) {
    const auto stack = contact::spring_stack(c.numbers("masses"), c.numbers("stiffness"));
    auto now = contact::unloaded(stack);
    for (double& v : now.velocity) v = c.number("speed");
    return contact::implicit_stack_step(stack, now, c.number("step"), c.number("gravity")).velocity;
  });
}

// ---------------------------------------------------------------------------- under gravity

/// How long an undamped contact lasts under gravity, 2 (π − β) / ω₀ with tan β = ω₀ v / g.
inline void add_delay(hard_cases::Runner& runner) {
  runner.question("delay", [](const Case& c) {
    const Rational square = oracle::exact(c.number("stiffness")) / oracle::exact(c.number("mass"));
    const Rational v = oracle::exact(c.number("speed"));
    const Rational g = oracle::exact(c.number("gravity"));
    return Json{{"class", "c"}, {"t", nearest_text([&](unsigned bits) {
                                   const Interval rate = sqrt(Interval(square, bits));
                                   const Interval pi = Interval::pi(bits);
                                   if (g == 0) return pi / rate;
                                   const Interval beta =
                                       atan(rate * Interval(Rational(v / g), bits));
                                   return fraction(2, 1, bits) * (pi - beta) / rate;
                                 })}};
  });
  const auto method = [&runner](const char* name, auto delay) {
    runner.method("delay", name, [delay](const Case& c, const Json& answer) {
      return same(
          delay(c.number("stiffness"), c.number("mass"), c.number("speed"), c.number("gravity")),
          answer, "t");
    });
  };
  method("π/ω₀",
         [](double k, double m, double, double) { return turn * std::sqrt(m) / std::sqrt(k); });
  method("π/ω₀, and the fall through the sag", [](double k, double m, double v, double g) {
    return turn * std::sqrt(m / k) + 2 * m * g / k / v;
  });
  method("2 (π − atan(ω₀v/g))/ω₀", [](double k, double m, double v, double g) {
    const double rate = std::sqrt(k / m);
    return 2 * (turn - std::atan(rate * v / g)) / rate;
  });
  method("book", [](double k, double m, double v, double g) {
    return contact::jump_difference(k, m, v, g).delay;
  });
}

inline void add(hard_cases::Runner& runner) {
  add_hertz(runner);
  add_hunt_crossley(runner);
  add_pull(runner);
  add_sag(runner);
  add_stack_step(runner);
  add_implicit_chain(runner);
  add_delay(runner);
}

}  // namespace hard_compliant
