// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// The stability of steps, the damping regime, the force of a state, the stiffness for an overlap,
// the energy after a bounce in steps, the sag and an implicit step of a stack, and whether bodies
// touch are rational in the stored numbers (class (a)). A longest step, a depth under gravity and
// the overlap of two balls are roots of polynomials (class (b)). Restitution, duration, depth and
// force of an impact, also of Hertz's, of Hunt and Crossley's and under gravity, the damper for a
// restitution and the longest step of a stack are transcendental (class (c)). Decisions must be
// right. A number may have a relative error of 2^-40, a force and an overlap that of the terms of
// which they are the difference.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/penalty_force.hpp>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <contact/trampoline.hpp>
#include <limits>
#include <string>

#include "hard_compliant.hpp"
#include "hard_contact.hpp"

using contact::PenaltyScheme;
using contact::StepBehaviour;
using hard_cases::Case;
using hard_cases::Json;
using hard_contact::exact_impact;
using hard_contact::ExactImpact;
using hard_contact::flag;
using hard_contact::nearest_text;
using hard_contact::rule;
using hard_contact::same;
using hard_contact::scheme;
using hard_contact::spring;
using hard_contact::turn;
using oracle::Interval;
using oracle::Rational;
using oracle::Surd;

namespace {

std::string text(StepBehaviour behaviour) {
  switch (behaviour) {
    case StepBehaviour::decays:
      return "decays";
    case StepBehaviour::bounded:
      return "bounded";
    default:
      return "grows";
  }
}

/// From the roots of x² − T x + D, the characteristic polynomial of the step's matrix.
std::string exact_behaviour(PenaltyScheme scheme, const contact::SpringDamper<Rational>& spring,
                            const Rational& m, const Rational& h) {
  const auto first = contact::spring_step<Rational>(scheme, {1, 0}, spring, m, h, 0);
  const auto second = contact::spring_step<Rational>(scheme, {0, 1}, spring, m, h, 0);
  const Rational trace = first.penetration + second.approach;
  const Rational product =
      first.penetration * second.approach - first.approach * second.penetration;
  const Rational discriminant = trace * trace - 4 * product;
  if (discriminant < 0) {
    return product == 1 ? "bounded" : (product < 1 ? "decays" : "grows");
  }
  const int top = oracle::compare(Surd{trace / 2, Rational(1, 2), discriminant}, {1, 0, 0});
  const int bottom = oracle::compare(Surd{trace / 2, Rational(-1, 2), discriminant}, {-1, 0, 0});
  if (top > 0 || bottom < 0) return "grows";
  if (top < 0 && bottom > 0) return "decays";
  return discriminant == 0 ? "grows" : "bounded";
}
contact::SpringDamper<Rational> exact_spring(const Case& c) {
  return {oracle::exact(c.number("stiffness")), oracle::exact(c.number("damping"))};
}

/// The smallest step that grows, of a scheme with several forces: found among 400 steps, then
/// bisected to 120 bits.
Rational first_growing_step(const Case& c) {
  const auto grows = [&](const Rational& h) {
    return exact_behaviour(scheme(c), exact_spring(c), oracle::exact(c.number("mass")), h) ==
           "grows";
  };
  const Rational unit = oracle::exact(1 / (std::sqrt(c.number("stiffness") / c.number("mass")) +
                                           c.number("damping") / c.number("mass")));
  Rational low(0), high = unit / 50;
  while (!grows(high)) {
    low = high;
    high += unit / 50;
  }
  for (int i = 0; i < 120; ++i) {
    const Rational middle = (low + high) / 2;
    (grows(middle) ? high : low) = middle;
  }
  return high;
}

void add_steps(hard_cases::Runner& runner) {
  runner.question("steps", [](const Case& c) {
    return Json{
        {"class", "a"},
        {"steps", exact_behaviour(scheme(c), exact_spring(c), oracle::exact(c.number("mass")),
                                  oracle::exact(c.number("step")))}};
  });
  const auto method = [&runner](const char* name, auto behaviour) {
    runner.method("steps", name, [behaviour](const Case& c, const Json& answer) {
      return behaviour(c) == answer.at("steps").get<std::string>();
    });
  };
  method("h < 2/ω₀", [](const Case& c) {
    const double a = c.number("step") * c.number("step") * c.number("stiffness") / c.number("mass");
    return std::string(a < 4 ? "decays" : "grows");
  });
  const auto of_one_force = [](const Case& c) {
    return scheme(c) <= PenaltyScheme::implicit_euler;
  };
  const auto rounded = [](const Case& c) {
    const double h = c.number("step");
    const double a = h * h * c.number("stiffness") / c.number("mass");
    const double b = h * c.number("damping") / c.number("mass");
    double p = b;
    double r = 4 - a - 2 * b;
    if (scheme(c) == PenaltyScheme::explicit_euler) {
      p = b - a;
      r = 4 + a - 2 * b;
    } else if (scheme(c) == PenaltyScheme::implicit_damper) {
      r = 4 + 2 * b - a;
    } else if (scheme(c) == PenaltyScheme::implicit_euler) {
      p = 1;
      r = 1;
    }
    if (p < 0 || r < 0 || (p == 0 && r == 0)) return std::string("grows");
    return std::string(p > 0 && r > 0 ? "decays" : "bounded");
  };
  runner.method("steps", "a and b rounded", of_one_force,
                [rounded](const Case& c, const Json& answer) {
                  return rounded(c) == answer.at("steps").get<std::string>();
                });
  method("spectral radius, rounded", [](const Case& c) {
    const auto first = contact::spring_step<double>(scheme(c), {1, 0}, spring(c), c.number("mass"),
                                                    c.number("step"), 0);
    const auto second = contact::spring_step<double>(scheme(c), {0, 1}, spring(c), c.number("mass"),
                                                     c.number("step"), 0);
    const double t = first.penetration + second.approach;
    const double d = first.penetration * second.approach - first.approach * second.penetration;
    const double discriminant = t * t - 4 * d;
    const double radius =
        discriminant < 0 ? std::sqrt(std::abs(d)) : (std::abs(t) + std::sqrt(discriminant)) / 2;
    return std::string(radius < 1 ? "decays" : (radius == 1 ? "bounded" : "grows"));
  });
  method("book", [](const Case& c) {
    return text(contact::step_behaviour(scheme(c), spring(c), c.number("mass"), c.number("step")));
  });
}

void add_regime(hard_cases::Runner& runner) {
  runner.question("regime", [](const Case& c) {
    const Rational d = oracle::exact(c.number("damping"));
    const Rational rest =
        d * d - 4 * oracle::exact(c.number("stiffness")) * oracle::exact(c.number("mass"));
    return Json{{"class", "a"}, {"regime", rest < 0 ? "under" : (rest > 0 ? "over" : "critical")}};
  });
  const auto method = [&runner](const char* name, auto excess) {
    runner.method("regime", name, [excess](const Case& c, const Json& answer) {
      const double x = excess(c.number("stiffness"), c.number("damping"), c.number("mass"));
      const std::string got = x < 0 ? "under" : (x > 0 ? "over" : "critical");
      return got == answer.at("regime").get<std::string>();
    });
  };
  method("ζ − 1", [](double k, double c, double m) { return c / (2 * std::sqrt(k * m)) - 1; });
  method("c² − 4km", [](double k, double c, double m) { return c * c - 4 * k * m; });
  method("c² − 4km, within 1e-15", [](double k, double c, double m) {
    const double excess = c * c - 4 * k * m;
    return std::abs(excess) <= 1e-15 ? 0.0 : excess;
  });
  runner.method("regime", "book", [](const Case& c, const Json& answer) {
    switch (contact::damping_regime(spring(c), c.number("mass"))) {
      case contact::DampingRegime::underdamped:
        return answer.at("regime") == "under";
      case contact::DampingRegime::critical:
        return answer.at("regime") == "critical";
      default:
        return answer.at("regime") == "over";
    }
  });
}

void add_limit(hard_cases::Runner& runner) {
  runner.question("longest step", [](const Case& c) {
    if (scheme(c) >= PenaltyScheme::velocity_verlet)
      return Json{{"class", "b"}, {"h", hard_cases::hex(first_growing_step(c))}};
    const Rational k = oracle::exact(c.number("stiffness"));
    const Rational d = oracle::exact(c.number("damping"));
    const Rational m = oracle::exact(c.number("mass"));
    Surd limit{-d / k, 1 / k, d * d + 4 * k * m};
    if (scheme(c) == PenaltyScheme::explicit_euler) {
      const Rational rest = d * d - 4 * k * m;
      limit = rest > 0 ? Surd{d / k, -1 / k, rest} : Surd{d / k, 0, 0};
    } else if (scheme(c) == PenaltyScheme::implicit_damper) {
      limit.a = d / k;
    }
    return Json{{"class", "b"}, {"h", hard_cases::hex(oracle::nearest(limit))}};
  });
  const auto method = [&runner](const char* name, auto limit) {
    runner.method("longest step", name, [limit](const Case& c, const Json& answer) {
      return same(limit(c), answer, "h");
    });
  };
  method("2/ω₀",
         [](const Case& c) { return 2 * std::sqrt(c.number("mass") / c.number("stiffness")); });
  method("the root as it stands", [](const Case& c) {
    const double k = c.number("stiffness");
    const double d = c.number("damping");
    const double m = c.number("mass");
    if (scheme(c) == PenaltyScheme::implicit_damper) return (d + std::sqrt(d * d + 4 * k * m)) / k;
    if (scheme(c) == PenaltyScheme::runge_kutta_4) return 2 * std::sqrt(2 * m / k);
    if (scheme(c) != PenaltyScheme::explicit_euler) return (-d + std::sqrt(d * d + 4 * k * m)) / k;
    const double rest = d * d - 4 * k * m;
    return rest > 0 ? (d - std::sqrt(rest)) / k : d / k;
  });
  method("book",
         [](const Case& c) { return contact::step_limit(scheme(c), spring(c), c.number("mass")); });
}

void add_restitution(hard_cases::Runner& runner) {
  runner.question("restitution", [](const Case& c) {
    const ExactImpact x = exact_impact(c);
    if (flag(c, "glued")) {
      if (x.rest() >= 0) return Json{{"class", "c"}, {"e", hard_cases::hex(0.0)}};
      if (x.c == 0) return Json{{"class", "c"}, {"e", hard_cases::hex(1.0)}};
      return Json{{"class", "c"},
                  {"e", nearest_text([&x](unsigned bits) {
                     return exp(-(Interval::pi(bits) *
                                  sqrt(Interval(Rational(x.c * x.c / -x.rest()), bits))));
                   })}};
    }
    if (x.c == 0) return Json{{"class", "c"}, {"e", hard_cases::hex(1.0)}};
    return Json{{"class", "c"},
                {"e", nearest_text([&x](unsigned bits) {
                   return exp(-(Interval(Rational(2), bits) * x.ratio(bits) * x.arc(bits)));
                 })}};
  });
  const auto method = [&runner](const char* name, auto restitution) {
    runner.method("restitution", name, [restitution](const Case& c, const Json& answer) {
      return same(restitution(c), answer, "e");
    });
  };
  const auto ratio = [](const Case& c) {
    return c.number("damping") / (2 * std::sqrt(c.number("stiffness") * c.number("mass")));
  };
  method("exp(−πζ)", [ratio](const Case& c) { return std::exp(-turn * ratio(c)); });
  method("exp(−πζ/√(1−ζ²))", [ratio](const Case& c) {
    const double z = ratio(c);
    return z < 1 ? std::exp(-turn * z / std::sqrt(1 - z * z)) : 0.0;
  });
  method("exp(−2ζ arccos ζ/√(1−ζ²))", [ratio](const Case& c) {
    const double z = ratio(c);
    return std::exp(-2 * z * std::acos(z) / std::sqrt(1 - z * z));
  });
  method("book", [](const Case& c) {
    return contact::spring_impact(spring(c), c.number("mass"), 1.0, rule(c)).restitution;
  });
}

void add_duration(hard_cases::Runner& runner) {
  runner.question("duration", [](const Case& c) {
    const ExactImpact x = exact_impact(c);
    if (flag(c, "glued")) {
      if (x.rest() >= 0) return Json{{"class", "c"}, {"t", "inf"}};
      return Json{{"class", "c"}, {"t", nearest_text([&x](unsigned bits) {
                                     return Interval::pi(bits) * Interval(Rational(2 * x.m), bits) /
                                            sqrt(Interval(-x.rest(), bits));
                                   })}};
    }
    return Json{{"class", "c"}, {"t", nearest_text([&x](unsigned bits) {
                                   return Interval(Rational(2), bits) * x.arc(bits) / x.rate(bits);
                                 })}};
  });
  const auto method = [&runner](const char* name, auto duration) {
    runner.method("duration", name, [duration](const Case& c, const Json& answer) {
      return same(duration(c), answer, "t");
    });
  };
  method("π/ω₀",
         [](const Case& c) { return turn * std::sqrt(c.number("mass") / c.number("stiffness")); });
  method("π/√(k/m − c²/4m²)", [](const Case& c) {
    const double half = c.number("damping") / (2 * c.number("mass"));
    const double square = c.number("stiffness") / c.number("mass") - half * half;
    return square > 0 ? turn / std::sqrt(square) : std::numeric_limits<double>::infinity();
  });
  method("book", [](const Case& c) {
    return contact::spring_impact(spring(c), c.number("mass"), 1.0, rule(c)).duration;
  });
}

void add_touch(hard_cases::Runner& runner) {
  runner.question("touch", [](const Case& c) {
    const auto a = oracle::exact(c.sphere("first"));
    const auto b = oracle::exact(c.sphere("second"));
    const oracle::Vector apart = a.centre - b.centre;
    const Rational reach = a.radius + b.radius;
    return Json{{"class", "a"}, {"touching", reach * reach >= apart.dot(apart)}};
  });
  const auto method = [&runner](const char* name, auto touching) {
    runner.method("touch", name, [touching](const Case& c, const Json& answer) {
      return touching(c.sphere("first"), c.sphere("second")) == answer.at("touching").get<bool>();
    });
  };
  using Ball = contact::Sphere<double>;
  method("float", [](const Ball& a, const Ball& b) {
    const contact::Vector3<float> apart = (a.centre - b.centre).cast<float>();
    return apart.norm() <= static_cast<float>(a.radius + b.radius);
  });
  method("|x| ≤ r₁ + r₂", [](const Ball& a, const Ball& b) {
    return (a.centre - b.centre).norm() <= a.radius + b.radius;
  });
  method("|x| < r₁ + r₂", [](const Ball& a, const Ball& b) {
    return (a.centre - b.centre).norm() < a.radius + b.radius;
  });
  method("book", [](const Ball& a, const Ball& b) {
    const auto still = contact::Vector3<double>(0, 0, 0);
    return contact::ball_ball_force<double>({a, still}, {b, still}, {1, 0}).touching;
  });
}

void add_half_space(hard_cases::Runner& runner) {
  runner.question("half-space", [](const Case& c) {
    const auto ball = oracle::exact(c.sphere("ball"));
    const auto plane = oracle::exact(c.plane("plane"));
    const Rational depth = ball.radius - (plane.normal.dot(ball.centre) - plane.offset);
    return Json{{"class", "a"}, {"touching", depth >= 0}};
  });
  using Ball = contact::Sphere<double>;
  using Plane = contact::Plane<double>;
  const auto method = [&runner](const char* name, auto touching) {
    runner.method("half-space", name, [touching](const Case& c, const Json& answer) {
      return touching(c.sphere("ball"), c.plane("plane")) == answer.at("touching").get<bool>();
    });
  };
  method("float", [](const Ball& ball, const Plane& plane) {
    const contact::Vector3<float> normal = plane.normal.cast<float>();
    const contact::Vector3<float> centre = ball.centre.cast<float>();
    return float(ball.radius) - (normal.dot(centre) - float(plane.offset)) >= 0;
  });
  method("r − (n·c − k) ≥ 0", [](const Ball& ball, const Plane& plane) {
    return ball.radius - (plane.normal.dot(ball.centre) - plane.offset) >= 0;
  });
  method("r − (n·c − k) > 0", [](const Ball& ball, const Plane& plane) {
    return ball.radius - (plane.normal.dot(ball.centre) - plane.offset) > 0;
  });
  method("book", [](const Ball& ball, const Plane& plane) {
    return contact::half_space_force<double>({ball, contact::Vector3<double>(0, 0, 0)}, plane,
                                             {1, 0})
        .touching;
  });
}

void add_jump(hard_cases::Runner& runner) {
  runner.question("jump", [](const Case& c) {
    const Rational sag = oracle::exact(c.number("mass")) * oracle::exact(c.number("gravity")) /
                         oracle::exact(c.number("stiffness"));
    const Rational h = oracle::exact(c.number("height"));
    return Json{{"class", "b"},
                {"depth", hard_cases::hex(oracle::nearest(Surd{sag, 1, sag * sag + 2 * sag * h}))}};
  });
  const auto method = [&runner](const char* name, auto depth) {
    runner.method("jump", name, [depth](const Case& c, const Json& answer) {
      return same(
          depth(c.number("mass"), c.number("stiffness"), c.number("gravity"), c.number("height")),
          answer, "depth");
    });
  };
  method("without weight on the mat",
         [](double m, double k, double g, double h) { return std::sqrt(2 * m * g * h / k); });
  method("as one writes it first", [](double m, double k, double g, double h) {
    return (m * g + std::sqrt(m * g * m * g + 2 * k * m * g * h)) / k;
  });
  method("book", [](double m, double k, double g, double h) {
    return contact::trampoline_jump(contact::trampoline(m, k, g, h)).max_depth;
  });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("16_penalty");
  add_steps(runner);
  add_regime(runner);
  add_limit(runner);
  add_restitution(runner);
  add_duration(runner);
  add_touch(runner);
  add_half_space(runner);
  add_jump(runner);
  hard_contact::add(runner);
  hard_compliant::add(runner);
  return runner.run(argc, argv);
}
