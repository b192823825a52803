/// @file
/// The force of a contact, its greatest values, the damper and the stiffness that a design asks
/// for, and the energy after a bounce in steps: right answers, and methods as they are often
/// written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/bounce_energy.hpp>
#include <contact/collision_1d.hpp>
#include <contact/penalty_force.hpp>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <limits>
#include <optional>
#include <stdexcept>

#include "support/hard_cases.hpp"

namespace hard_contact {

using contact::ContactRelease;
using contact::PenaltyScheme;
using hard_cases::Case;
using hard_cases::Json;
using oracle::Interval;
using oracle::Rational;
using oracle::Surd;

inline constexpr double turn = 3.141592653589793;

inline contact::SpringDamper<double> spring(const Case& c) {
  return contact::spring_damper(c.number("stiffness"), c.number("damping"));
}
/// A field that is a flag: 0 or 1.
inline bool flag(const Case& c, const char* field) { return c.number(field) != 0; }
inline PenaltyScheme scheme(const Case& c) {
  return static_cast<PenaltyScheme>(static_cast<int>(c.number("scheme")));
}
inline ContactRelease rule(const Case& c) {
  return flag(c, "glued") ? ContactRelease::at_zero_penetration : ContactRelease::at_zero_force;
}

/// A number may be off by 2^-40 of itself; infinity must be infinity.
inline bool same(double got, const Json& answer, const char* field) {
  const double right = hard_cases::unhex(answer, field);
  if (std::isinf(right)) return got == right;
  return std::isfinite(got) && std::abs(got - right) <= std::ldexp(std::abs(right), -40);
}
inline Json nearest_text(const oracle::Expression& value) {
  const std::optional<double> nearest = oracle::nearest_value(value);
  return Json(nearest ? hard_cases::hex(*nearest) : std::string("undecided"));
}

/// θ / sin θ for cos θ = ζ.
inline Interval arc_over_sine(const Rational& ratio, unsigned bits) {
  const Interval z(ratio, bits);
  if (ratio == 1) return z;
  const Interval root = sqrt(Interval(Rational(abs(ratio * ratio - 1)), bits));
  return ratio < 1 ? acos(z) / root : log(z + root) / root;
}

/// An impact of the stored numbers by intervals. Without the damper ζ is 0, and at c² = 4 k m it is
/// 1: both are exact.
struct ExactImpact {
  Rational k, c, m;

  Rational rest() const { return c * c - 4 * k * m; }
  Interval ratio(unsigned bits) const { return sqrt(Interval(c * c / (4 * k * m), bits)); }
  /// θ / sin θ.
  Interval arc(unsigned bits) const {
    const Interval one(Rational(1), bits);
    if (rest() == 0) return one;
    const Interval z = ratio(bits);
    const Interval root = sqrt(Interval(Rational(abs(rest()) / (4 * k * m)), bits));
    return rest() < 0 ? acos(z) / root : log(z + root) / root;
  }
  Interval rate(unsigned bits) const { return sqrt(Interval(k / m, bits)); }
};
inline ExactImpact exact_impact(const Case& c) {
  return {oracle::exact(c.number("stiffness")), oracle::exact(c.number("damping")),
          oracle::exact(c.number("mass"))};
}

// ------------------------------------------------------------------------------- force of a state

/// The force of spring and damper at a penetration and a speed of approach. It may be off by 2^-40
/// of the larger of its two parts; a pull is wrong unless the contact is glued.
inline void add_force(hard_cases::Runner& runner) {
  runner.question("force", [](const Case& c) {
    const Rational d = oracle::exact(c.number("penetration"));
    Rational force = oracle::exact(c.number("stiffness")) * d +
                     oracle::exact(c.number("damping")) * oracle::exact(c.number("approach"));
    if (d < 0 || (force < 0 && !flag(c, "glued"))) force = 0;
    return Json{{"class", "a"}, {"force", hard_cases::hex(force)}};
  });
  const auto method = [&runner](const char* name, auto force) {
    runner.method("force", name, [force](const Case& c, const Json& answer) {
      const double k = c.number("stiffness"), b = c.number("damping");
      const double d = c.number("penetration"), v = c.number("approach");
      const double got = force(c, k, b, d, v);
      const double parts = d < 0 ? 0.0 : std::max(k * d, b * std::abs(v));
      const bool pulls = got < 0 && !flag(c, "glued");
      return std::isfinite(got) && !pulls &&
             std::abs(got - hard_cases::unhex(answer, "force")) <= std::ldexp(parts, -40);
    });
  };
  method("float", [](const Case& c, double k, double b, double d, double v) {
    return double(contact::contact_force<float>({float(k), float(b)}, float(d), float(v), rule(c)));
  });
  method("k d + c ḋ, without a rule", [](const Case&, double k, double b, double d, double v) {
    return d < 0 ? 0 : k * d + b * v;
  });
  method("only if d > 0", [](const Case&, double k, double b, double d, double v) {
    return d > 0 ? std::max(0.0, k * d + b * v) : 0.0;
  });
  method("damper of the approach only", [](const Case&, double k, double b, double d, double v) {
    return d < 0 ? 0.0 : k * d + b * std::max(0.0, v);
  });
  method("book", [](const Case& c, double, double, double d, double v) {
    return contact::contact_force(spring(c), d, v, rule(c));
  });
}

// ------------------------------------------------------------------- overlap of two balls

/// Class (b): r₁ + r₂ − |c₁ − c₂|. It may be off by 2^-40 of the sum of the radii.
inline void add_penetration(hard_cases::Runner& runner) {
  runner.question("penetration", [](const Case& c) {
    const auto a = oracle::exact(c.sphere("first"));
    const auto b = oracle::exact(c.sphere("second"));
    const oracle::Vector apart = a.centre - b.centre;
    const Surd depth{a.radius + b.radius, -1, apart.dot(apart)};
    if (oracle::sign(depth) < 0) return Json{{"class", "b"}, {"depth", "none"}};
    return Json{{"class", "b"}, {"depth", hard_cases::hex(oracle::nearest(depth))}};
  });
  using Ball = contact::Sphere<double>;
  const auto method = [&runner](const char* name, auto depth) {
    runner.method("penetration", name, [depth](const Case& c, const Json& answer) {
      const Ball a = c.sphere("first"), b = c.sphere("second");
      const std::optional<double> got = depth(a, b);
      if (answer.at("depth") == "none") return !got;
      return got && std::abs(*got - hard_cases::unhex(answer, "depth")) <=
                        std::ldexp(a.radius + b.radius, -40);
    });
  };
  const auto overlap = [](double depth) {
    return depth < 0 ? std::nullopt : std::optional<double>(depth);
  };
  method("float", [overlap](const Ball& a, const Ball& b) {
    const contact::Vector3<float> apart = a.centre.cast<float>() - b.centre.cast<float>();
    return overlap(float(a.radius) + float(b.radius) - apart.norm());
  });
  method("|a|² − 2 a·b + |b|²", [overlap](const Ball& a, const Ball& b) {
    const double square =
        a.centre.dot(a.centre) - 2 * a.centre.dot(b.centre) + b.centre.dot(b.centre);
    return overlap(a.radius + b.radius - std::sqrt(square));
  });
  method("along the unit normal", [overlap](const Ball& a, const Ball& b) {
    const contact::Vector3<double> apart = a.centre - b.centre;
    const contact::Vector3<double> normal = apart / std::sqrt(apart.dot(apart));
    return overlap(a.radius + b.radius - apart.dot(normal));
  });
  method("book", [](const Ball& a, const Ball& b) {
    const contact::Vector3<double> still(0, 0, 0);
    const auto found = contact::ball_ball_force<double>({a, still}, {b, still}, {1, 0});
    const bool pushes = found.force.allFinite();
    return found.touching && pushes ? std::optional<double>(found.penetration) : std::nullopt;
  });
}

// ---------------------------------------------------------------- greatest penetration and force

inline void add_depth(hard_cases::Runner& runner) {
  runner.question("greatest depth", [](const Case& c) {
    const ExactImpact x = exact_impact(c);
    const Rational v = oracle::exact(c.number("speed"));
    return Json{{"class", "c"}, {"depth", nearest_text([&](unsigned bits) {
                                   return Interval(v, bits) / x.rate(bits) *
                                          exp(-(x.ratio(bits) * x.arc(bits)));
                                 })}};
  });
  const auto method = [&runner](const char* name, auto depth) {
    runner.method("greatest depth", name, [depth](const Case& c, const Json& answer) {
      const double k = c.number("stiffness"), m = c.number("mass");
      const double ratio = c.number("damping") / (2 * std::sqrt(k * m));
      return same(depth(c.number("speed") * std::sqrt(m / k), ratio), answer, "depth");
    });
  };
  method("v/ω₀", [](double undamped, double) { return undamped; });
  method("after a quarter of a period", [](double undamped, double z) {
    const double s = std::sqrt(1 - z * z);
    return undamped / s * std::exp(-turn * z / (2 * s));
  });
  method("exp(−ζ arccos ζ/√(1−ζ²))", [](double undamped, double z) {
    return undamped * std::exp(-z * std::acos(z) / std::sqrt(1 - z * z));
  });
  runner.method("greatest depth", "book", [](const Case& c, const Json& answer) {
    return same(contact::spring_impact(spring(c), c.number("mass"), c.number("speed")).max_depth,
                answer, "depth");
  });
}

inline void add_greatest_force(hard_cases::Runner& runner) {
  runner.question("greatest force", [](const Case& c) {
    const ExactImpact x = exact_impact(c);
    const Rational v = oracle::exact(c.number("speed"));
    if (x.c * x.c >= x.k * x.m) return Json{{"class", "a"}, {"force", hard_cases::hex(x.c * v)}};
    return Json{{"class", "c"},
                {"force", nearest_text([&](unsigned bits) {
                   const Interval one(Rational(1), bits);
                   const Interval three(Rational(3), bits);
                   const Interval z = x.ratio(bits);
                   const Interval sine = sqrt(one - z * z);
                   const Interval later = (three * acos(z) - Interval::pi(bits)) / sine;
                   return Interval(Rational(x.m * v), bits) * x.rate(bits) * exp(-(z * later));
                 })}};
  });
  const auto method = [&runner](const char* name, auto force) {
    runner.method("greatest force", name, [force](const Case& c, const Json& answer) {
      return same(
          force(c.number("stiffness"), c.number("damping"), c.number("mass"), c.number("speed")),
          answer, "force");
    });
  };
  method("v √(k m)",
         [](double k, double, double m, double v) { return v * std::sqrt(k) * std::sqrt(m); });
  method("k times the greatest depth", [](double k, double b, double m, double v) {
    return k * contact::spring_impact(contact::spring_damper(k, b), m, v).max_depth;
  });
  method("the larger of that and c v", [](double k, double b, double m, double v) {
    return std::max(b * v,
                    k * contact::spring_impact(contact::spring_damper(k, b), m, v).max_depth);
  });
  method("book", [](double k, double b, double m, double v) {
    return contact::spring_impact(contact::spring_damper(k, b), m, v).max_force;
  });
}

// ------------------------------------------------------------------------------ two moving bodies

/// The time for which two balls touch: that of their reduced mass, at zero force.
inline void add_pair(hard_cases::Runner& runner) {
  runner.question("pair", [](const Case& c) {
    const Rational a = oracle::exact(c.number("mass_a"));
    const Rational b = oracle::exact(c.number("mass_b"));
    const ExactImpact x{oracle::exact(c.number("stiffness")), oracle::exact(c.number("damping")),
                        a * b / (a + b)};
    return Json{{"class", "c"}, {"t", nearest_text([&](unsigned bits) {
                                   return Interval(Rational(2), bits) * x.arc(bits) / x.rate(bits);
                                 })}};
  });
  const auto method = [&runner](const char* name, auto mass) {
    runner.method("pair", name, [mass](const Case& c, const Json& answer) {
      const double m = mass(c.number("mass_a"), c.number("mass_b"));
      return same(contact::spring_impact(spring(c), m, 1.0).duration, answer, "t");
    });
  };
  method("mass of the first", [](double a, double) { return a; });
  method("mean mass", [](double a, double b) { return a / 2 + b / 2; });
  method("m₁m₂/(m₁ + m₂)", [](double a, double b) { return a * b / (a + b); });
  method("1/(1/m₁ + 1/m₂) in float",
         [](double a, double b) { return double(1 / (1 / float(a) + 1 / float(b))); });
  method("book", [](double a, double b) { return contact::reduced_mass(a, b); });
}

// ---------------------------------------------------------------------- damper for a restitution

/// ζ with 2 ζ θ / sin θ = L, by bisection with certain signs.
inline Interval ratio_for(const Rational& e, unsigned bits) {
  const Interval wanted = -log(Interval(e, 4 * bits));
  const auto sign_at = [&](const Rational& z) {
    return (Interval(Rational(2 * z), 4 * bits) * arc_over_sine(z, 4 * bits) - wanted).sign();
  };
  Rational low(0), high(1);
  while (sign_at(high) == -1) {
    low = high;
    high *= 2;
  }
  for (unsigned i = 0; i < 2 * bits; ++i) {
    const Rational middle = (low + high) / 2;
    const auto sign = sign_at(middle);
    if (!sign) break;
    (*sign < 0 ? low : high) = middle;
  }
  return Interval(low, high, bits);
}

inline void add_damper(hard_cases::Runner& runner) {
  runner.question("damper", [](const Case& c) {
    const Rational e = oracle::exact(c.number("restitution"));
    const Rational four =
        4 * oracle::exact(c.number("stiffness")) * oracle::exact(c.number("mass"));
    if (e < 0 || e > 1 || (e == 0 && !flag(c, "glued"))) return Json{{"class", "c"}, {"c", "none"}};
    if (e == 1) return Json{{"class", "c"}, {"c", hard_cases::hex(0.0)}};
    return Json{{"class", "c"}, {"c", nearest_text([&](unsigned bits) {
                                   const Interval critical = sqrt(Interval(four, bits));
                                   if (e == 0) return critical;
                                   if (!flag(c, "glued")) return ratio_for(e, bits) * critical;
                                   const Interval l = -log(Interval(e, bits));
                                   const Interval pi = Interval::pi(bits);
                                   return l / sqrt(pi * pi + l * l) * critical;
                                 })}};
  });
  const auto method = [&runner](const char* name, auto ratio) {
    runner.method("damper", name, [ratio](const Case& c, const Json& answer) {
      const double e = c.number("restitution");
      const double critical = 2 * std::sqrt(c.number("stiffness")) * std::sqrt(c.number("mass"));
      const double got = ratio(e) * critical;
      if (answer.at("c") == "none") return !(got >= 0);
      return same(got, answer, "c");
    });
  };
  method("−ln e/π", [](double e) { return -std::log(e) / turn; });
  method("−ln e/√(π² + ln² e)", [](double e) {
    const double l = std::log(e);
    return -l / std::sqrt(turn * turn + l * l);
  });
  method("bisection of 2ζ arccos ζ/√(1−ζ²)", [](double e) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double z = (low + high) / 2;
      const double y = 2 * z * std::acos(z) / std::sqrt(1 - z * z);
      (std::exp(-y) > e ? low : high) = z;
    }
    return high;
  });
  runner.method("damper", "book", [](const Case& c, const Json& answer) {
    const auto got = [&]() -> std::optional<double> {
      try {
        return contact::spring_for_restitution(c.number("stiffness"), c.number("mass"),
                                               c.number("restitution"), rule(c))
            .damping;
      } catch (const std::invalid_argument&) {
        return std::nullopt;
      }
    }();
    if (answer.at("c") == "none") return !got;
    return got && same(*got, answer, "c");
  });
}

// ------------------------------------------------------------------------ stiffness for an overlap

/// A body dropped from a height onto an undamped spring may not overlap more than d:
/// k = 2 m g (h + d) / d², by energy.
inline void add_stiffness(hard_cases::Runner& runner) {
  runner.question("stiffness", [](const Case& c) {
    const Rational weight = oracle::exact(c.number("mass")) * oracle::exact(c.number("gravity"));
    const Rational d = oracle::exact(c.number("depth"));
    const Rational k = 2 * weight * (oracle::exact(c.number("height")) + d) / (d * d);
    return Json{{"class", "a"}, {"k", hard_cases::hex(k)}};
  });
  const auto method = [&runner](const char* name, auto stiffness) {
    runner.method("stiffness", name, [stiffness](const Case& c, const Json& answer) {
      return same(
          stiffness(c.number("mass"), c.number("gravity"), c.number("height"), c.number("depth")),
          answer, "k");
    });
  };
  method("m g/d", [](double m, double g, double, double d) { return m * g / d; });
  method("m v²/d²", [](double m, double g, double h, double d) { return 2 * m * g * h / d / d; });
  method("2 m g (h + d)/d²",
         [](double m, double g, double h, double d) { return 2 * m * g * (h + d) / (d * d); });
  method("book", [](double m, double g, double h, double d) {
    return contact::stiffness_for_depth(m, std::sqrt(2 * g) * std::sqrt(h), g, d);
  });
}

// ------------------------------------------------------------------------- a bounce in time steps

/// The kinetic energy after a bounce in steps over that before, from the stored numbers: the first
/// step starts with a penetration, and the last one ends in a gap.
template <class S>
S energy_after(PenaltyScheme scheme, ContactRelease rule, const contact::SpringDamper<S>& spring,
               const S& mass, const S& h, contact::PenaltyState<S> now) {
  const S before = now.approach * now.approach;
  for (int i = 0; i < 4000 && !(now.penetration < S(0) && now.approach < S(0)); ++i)
    now = contact::penalty_step<S>(scheme, now, spring, mass, h, S(0), rule);
  return now.approach * now.approach / before;
}

/// The same in fractions, written out for the four schemes without the book's steps: a = h² k / m
/// and b = h c / m.
inline Rational exact_energy_after(const Case& c) {
  const Rational h = oracle::exact(c.number("step"));
  const Rational b = h * oracle::exact(c.number("damping")) / oracle::exact(c.number("mass"));
  const Rational a = h * h * oracle::exact(c.number("stiffness")) / oracle::exact(c.number("mass"));
  Rational d = oracle::exact(c.number("penetration"));
  Rational moved = h * oracle::exact(c.number("approach"));  // h times the speed
  const Rational before = moved * moved;
  for (int i = 0; i < 4000 && !(d < 0 && moved < 0); ++i) {
    const Rational old = moved;
    if (d >= 0) {
      Rational next = moved - a * d - b * moved;
      if (scheme(c) == PenaltyScheme::implicit_damper) next = (moved - a * d) / (1 + b);
      if (scheme(c) == PenaltyScheme::implicit_euler) next = (moved - a * d) / (1 + a + b);
      if (flag(c, "glued") || next <= moved) moved = next;
    }
    d += scheme(c) == PenaltyScheme::explicit_euler ? old : moved;
  }
  return moved * moved / before;
}

inline void add_energy(hard_cases::Runner& runner) {
  runner.question("energy", [](const Case& c) {
    return Json{{"class", "a"}, {"factor", hard_cases::hex(exact_energy_after(c))}};
  });
  runner.method("energy", "closed form, e²", [](const Case& c, const Json& answer) {
    const double e =
        contact::spring_impact(spring(c), c.number("mass"), c.number("approach"), rule(c))
            .restitution;
    return same(e * e, answer, "factor");
  });
  runner.method("energy", "steps in float", [](const Case& c, const Json& answer) {
    const auto f = [&c](const char* field) { return float(c.number(field)); };
    const float factor =
        energy_after<float>(scheme(c), rule(c), {f("stiffness"), f("damping")}, f("mass"),
                            f("step"), {f("penetration"), f("approach")});
    return same(double(factor), answer, "factor");
  });
  runner.method("energy", "book", [](const Case& c, const Json& answer) {
    return same(
        energy_after<double>(scheme(c), rule(c), spring(c), c.number("mass"), c.number("step"),
                             {c.number("penetration"), c.number("approach")}),
        answer, "factor");
  });
  runner.method(
      "energy", "book: bounds",
      [](const Case& c) {
        return scheme(c) == PenaltyScheme::semi_implicit_euler && c.number("damping") == 0;
      },
      [](const Case& c, const Json& answer) {
        const auto bounds =
            contact::bounce_energy_factor(spring(c), c.number("mass"), c.number("step"));
        const double right = hard_cases::unhex(answer, "factor");
        return bounds.min * (1 - 1e-12) <= right && right <= bounds.max * (1 + 1e-12);
      });
}

inline void add(hard_cases::Runner& runner) {
  add_force(runner);
  add_penetration(runner);
  add_depth(runner);
  add_greatest_force(runner);
  add_pair(runner);
  add_damper(runner);
  add_stiffness(runner);
  add_energy(runner);
}

}  // namespace hard_contact
