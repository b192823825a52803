// Recomputes the answers of hard_cases.json and says which method gets which case right.
//
// What is rational in the stored numbers is computed in fractions (class (a)); the time at which a
// gap closes has one square root (b); a position on a spring is a cosine, enclosed by intervals
// (c). Whether a gap closes, the number of impacts and whether it is finite must be right. A time
// may have a relative error of 2^-40, a position in a fall an error of 2^-40 of |x| + |v t| + |a
// t²/2|, on a spring of 2^-10 of |x| + |v|/ω, between walls of 2^-40 of the path plus the start's
// distance from the origin.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/advance.hpp>
#include <contact/ballistic.hpp>
#include <contact/integrators.hpp>
#include <contact/spring_motion.hpp>
#include <contact/two_balls_wall.hpp>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

using contact::Integrator;
using contact::MotionState;
using hard_cases::Case;
using hard_cases::close;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;
using oracle::Surd;
using Vector = contact::Vector3<double>;

namespace {

// ---------------------------------------------------------------- when a gap closes

std::optional<Surd> closing(const Rational& gap, const Rational& rate, const Rational& a) {
  const bool shrinks = rate < 0 || (rate == 0 && a < 0);
  if (gap <= 0 && shrinks) return Surd{0, 0, 0};
  if (gap <= 0 && a >= 0) return std::nullopt;
  if (a == 0) return rate < 0 ? std::optional<Surd>(Surd{-gap / rate, 0, 0}) : std::nullopt;
  const Rational square = rate * rate - 2 * a * gap;
  if (square < 0) return gap <= 0 ? std::optional<Surd>(Surd{-rate / a, 0, 0}) : std::nullopt;
  if (gap > 0 && a > 0 && rate >= 0) return std::nullopt;
  return Surd{-rate / a, -1 / a, square};
}

void add_closing(hard_cases::Runner& runner) {
  runner.question("closing", [](const Case& c) {
    const auto t = closing(oracle::exact(c.number("gap")), oracle::exact(c.number("rate")),
                           oracle::exact(c.number("acceleration")));
    return Json{{"class", "b"}, {"t", t ? hard_cases::hex(oracle::nearest(*t)) : "never"}};
  });
  const auto method = [&runner](const char* name, auto time) {
    runner.method("closing", name, [time](const Case& c, const Json& answer) {
      const std::optional<double> got =
          time(c.number("gap"), c.number("rate"), c.number("acceleration"));
      if (answer.at("t") == "never") return !got;
      const double right = unhex(answer, "t");
      return got && close(*got, right, std::ldexp(std::abs(right), -40));
    });
  };
  const auto by_formula = [](auto gap, auto rate, auto a) -> std::optional<double> {
    const auto square = rate * rate - 2 * a * gap;
    if (!(square >= 0)) return std::nullopt;
    const double t = static_cast<double>((-rate - std::sqrt(square)) / a);
    return t >= 0 ? std::optional(t) : std::nullopt;
  };
  method("float, (−v − √D)/a", [by_formula](double gap, double rate, double a) {
    return by_formula(static_cast<float>(gap), static_cast<float>(rate), static_cast<float>(a));
  });
  method("(−v − √D)/a",
         [by_formula](double gap, double rate, double a) { return by_formula(gap, rate, a); });
  method("2h/(√D − v)", [](double gap, double rate, double a) -> std::optional<double> {
    const double square = rate * rate - 2 * a * gap;
    if (!(square >= 0)) return std::nullopt;
    const double t = 2 * gap / (std::sqrt(square) - rate);
    return t >= 0 ? std::optional(t) : std::nullopt;
  });
  method("without acceleration",
         [](double gap, double rate, double) { return contact::straight_closing_time(gap, rate); });
  method("book",
         [](double gap, double rate, double a) { return contact::closing_time(gap, rate, a); });
}

// ---------------------------------------------------------------- falling

void add_fall(hard_cases::Runner& runner) {
  runner.question("fall", [](const Case& c) {
    const Rational t =
        oracle::exact(c.number("step")) * Rational(static_cast<long>(c.number("steps")));
    const Rational right = oracle::exact(c.number("position")) +
                           oracle::exact(c.number("velocity")) * t +
                           oracle::exact(c.number("acceleration")) * t * t / 2;
    return Json{{"class", "a"}, {"position", hard_cases::hex(oracle::nearest(right))}};
  });
  const auto method = [&runner](const char* name, auto position) {
    runner.method("fall", name, [position](const Case& c, const Json& answer) {
      const double t = c.number("step") * c.number("steps");
      const double size = std::abs(c.number("position")) + std::abs(c.number("velocity") * t) +
                          std::abs(c.number("acceleration") * t * t / 2);
      return close(position(c), unhex(answer, "position"), std::ldexp(size, -40));
    });
  };
  const auto by = [](Integrator integrator) {
    return [integrator](const Case& c) {
      const double a = c.number("acceleration");
      return contact::integrate(integrator,
                                MotionState<double>{c.number("position"), c.number("velocity")},
                                c.number("step"), static_cast<long long>(c.number("steps")),
                                [a](double) { return a; })
          .position;
    };
  };
  method("explicit Euler", by(Integrator::explicit_euler));
  method("symplectic Euler", by(Integrator::semi_implicit_euler));
  method("Verlet", by(Integrator::velocity_verlet));
  method("Runge–Kutta", by(Integrator::runge_kutta_4));
  method("book", [](const Case& c) {
    return contact::ballistic_motion(
               MotionState<double>{c.number("position"), c.number("velocity")},
               c.number("acceleration"), c.number("step") * c.number("steps"))
        .position;
  });
}

// ---------------------------------------------------------------- a spring

void add_spring(hard_cases::Runner& runner) {
  runner.question("spring", [](const Case& c) {
    const Rational t =
        oracle::exact(c.number("step")) * Rational(static_cast<long>(c.number("steps")));
    const Rational w = oracle::exact(c.number("angular_frequency"));
    const auto right = oracle::nearest_value([&](unsigned bits) {
      const oracle::Interval angle(Rational(w * t), bits);
      return oracle::Interval(oracle::exact(c.number("position")), bits) * cos(angle) +
             oracle::Interval(Rational(oracle::exact(c.number("velocity")) / w), bits) * sin(angle);
    });
    return Json{{"class", "c"}, {"position", hard_cases::hex(right.value())}};
  });
  const auto method = [&runner](const char* name, auto position) {
    runner.method("spring", name, [position](const Case& c, const Json& answer) {
      const double size = std::abs(c.number("position")) +
                          std::abs(c.number("velocity")) / c.number("angular_frequency");
      return close(position(c), unhex(answer, "position"), std::ldexp(size, -10));
    });
  };
  const auto by = [](Integrator integrator) {
    return [integrator](const Case& c) {
      return contact::integrate(integrator,
                                MotionState<double>{c.number("position"), c.number("velocity")},
                                c.number("step"), static_cast<long long>(c.number("steps")),
                                contact::linear_spring(c.number("angular_frequency")))
          .position;
    };
  };
  method("explicit Euler", by(Integrator::explicit_euler));
  method("symplectic Euler", by(Integrator::semi_implicit_euler));
  method("Verlet", by(Integrator::velocity_verlet));
  method("Runge–Kutta", by(Integrator::runge_kutta_4));
  method("book", [](const Case& c) {
    return contact::spring_motion(contact::linear_spring(c.number("angular_frequency")),
                                  {c.number("position"), c.number("velocity")},
                                  c.number("step") * c.number("steps"))
        .position;
  });
}

// ---------------------------------------------------------------- a point between walls

template <class S>
std::vector<contact::Plane<S>> walls_of(const Case& c) {
  std::vector<contact::Plane<S>> walls;
  const std::vector<double> numbers = c.numbers("walls");  // nx, ny, nz, offset, …
  for (std::size_t i = 0; i + 3 < numbers.size(); i += 4) {
    if constexpr (std::is_same_v<S, double>) {
      walls.push_back({{numbers[i], numbers[i + 1], numbers[i + 2]}, numbers[i + 3]});
    } else {
      walls.push_back({{oracle::exact(numbers[i]), oracle::exact(numbers[i + 1]),
                        oracle::exact(numbers[i + 2])},
                       oracle::exact(numbers[i + 3])});
    }
  }
  return walls;
}

struct Place {
  Vector position;
  int impacts = 0;
};

/// A naive loop, in which each mistake can be switched on.
Place naive(const Case& c, bool once, bool lost, bool approach) {
  Vector x = c.vector("position");
  Vector v = c.vector("velocity");
  const double k = c.number("restitution");
  double left = c.number("step");
  const auto walls = walls_of<double>(c);
  Place place;
  while (place.impacts < 1000) {
    double first = left;
    const contact::Plane<double>* met = nullptr;
    for (const auto& wall : walls) {
      const double gap = wall.normal.dot(x) - wall.offset;
      const double rate = wall.normal.dot(v);
      if (approach ? !(rate < 0) : rate == 0) continue;
      const double t = -gap / rate;
      if (t >= 0 && (t < first || (t == first && met == nullptr))) {
        first = t;
        met = &wall;
      }
    }
    if (met == nullptr || (once && place.impacts > 0)) break;
    x += v * first;
    left -= first;
    v -= (1 + k) * v.dot(met->normal) * met->normal;
    ++place.impacts;
    if (lost) {
      left = 0;
      break;
    }
  }
  place.position = x + v * left;
  return place;
}

void add_walls(hard_cases::Runner& runner) {
  runner.question("walls", [](const Case& c) {
    const auto end = contact::advance_straight<Rational>(
        {oracle::exact(c.vector("position")), oracle::exact(c.vector("velocity"))}, 0,
        oracle::exact(c.number("step")), walls_of<Rational>(c),
        contact::impact_rules<Rational>(oracle::exact(c.number("restitution")), 0, 1000));
    return Json{{"class", "a"},
                {"impacts", end.impacts},
                {"position", hard_cases::hex(oracle::nearest(end.state.position))}};
  });
  const auto method = [&runner](const char* name, auto advance) {
    runner.method("walls", name, [advance](const Case& c, const Json& answer) {
      const Place got = advance(c);
      if (got.impacts != answer.at("impacts").get<int>()) return false;
      const double room = std::ldexp(
          c.vector("position").norm() + c.vector("velocity").norm() * c.number("step"), -40);
      for (int i = 0; i < 3; ++i) {
        const double right = std::strtod(
            answer.at("position").at(static_cast<std::size_t>(i)).get<std::string>().c_str(),
            nullptr);
        if (!close(got.position(i), right, room)) return false;
      }
      return true;
    });
  };
  method("one impact a step", [](const Case& c) { return naive(c, true, false, true); });
  method("ends at the impact", [](const Case& c) { return naive(c, false, true, true); });
  method("no test for approach", [](const Case& c) { return naive(c, false, false, false); });
  method("naive loop", [](const Case& c) { return naive(c, false, false, true); });
  method("book", [](const Case& c) {
    const auto end = contact::advance_straight<double>(
        {c.vector("position"), c.vector("velocity")}, 0, c.number("step"), walls_of<double>(c),
        contact::impact_rules(c.number("restitution"), 0.0, 1000));
    return Place{end.state.position, end.impacts};
  });
}

// ---------------------------------------------------------------- two balls and a wall

template <class S, class Number>
contact::TwoBallsAndWall<S> balls_of(const Case& c, const Number& number) {
  return {{number(c.number("inner_mass")), number(c.number("inner_velocity"))},
          {number(c.number("outer_mass")), number(c.number("outer_velocity"))},
          number(c.number("wall_gap")),
          number(c.number("ball_gap")),
          number(c.number("restitution")),
          0};
}

void add_hits(hard_cases::Runner& runner) {
  runner.question("hits", [](const Case& c) {
    Rational time = oracle::exact(c.number("time"));
    const auto end = contact::two_balls_by_events(
        balls_of<Rational>(c, [](double x) { return oracle::exact(x); }), time, 4000);
    return Json{{"class", "a"}, {"hits", static_cast<int>(end.hits)}};
  });
  const auto method = [&runner](const char* name, auto hits) {
    runner.method("hits", name, [hits](const Case& c, const Json& answer) {
      return hits(c) == answer.at("hits").get<int>();
    });
  };
  const auto in_steps = [](double dt) {
    return [dt](const Case& c) {
      const auto steps = static_cast<long long>(std::ceil(c.number("time") / dt));
      const auto end =
          contact::two_balls_in_steps(balls_of<double>(c, [](double x) { return x; }),
                                      c.number("time") / static_cast<double>(steps), steps);
      return static_cast<int>(end.hits);
    };
  };
  method("steps of 1/60 s", in_steps(1.0 / 60));
  method("steps of 1/4096 s", in_steps(1.0 / 4096));
  method("float, by events", [](const Case& c) {
    auto time = static_cast<float>(c.number("time"));
    return static_cast<int>(
        contact::two_balls_by_events(
            balls_of<float>(c, [](double x) { return static_cast<float>(x); }), time, 4000)
            .hits);
  });
  method("book", [](const Case& c) {
    double time = c.number("time");
    return static_cast<int>(
        contact::two_balls_by_events(balls_of<double>(c, [](double x) { return x; }), time, 4000)
            .hits);
  });
}

void add_collapse(hard_cases::Runner& runner) {
  runner.question("collapse", [](const Case& c) {
    const Rational e = oracle::exact(c.number("restitution"));
    const bool endless = (1 - e) * (1 - e) * oracle::exact(c.number("outer_mass")) >=
                         4 * e * oracle::exact(c.number("inner_mass"));
    return Json{{"class", "a"}, {"endless", endless}};
  });
  const auto method = [&runner](const char* name, auto endless) {
    runner.method("collapse", name, [endless](const Case& c, const Json& answer) {
      return endless(c.number("inner_mass"), c.number("outer_mass"), c.number("restitution")) ==
             answer.at("endless").get<bool>();
    });
  };
  method("float, (1 − e)² M ≥ 4em", [](double m, double n, double e) {
    const auto k = static_cast<float>(e);
    return (1 - k) * (1 - k) * static_cast<float>(n) >= 4 * k * static_cast<float>(m);
  });
  method("double, (1 − e)² M ≥ 4em",
         [](double m, double n, double e) { return (1 - e) * (1 - e) * n >= 4 * e * m; });
  method("double, by the trace", [](double m, double n, double e) {
    return 1 - e + (1 + e) * (e * n - m) / (n + m) >= 2 * e;
  });
  method("a hundred collisions", [](double m, double n, double e) {
    double time = 1e30;
    const auto end = contact::two_balls_by_events<double>({{m, 0}, {n, -1}, 1, 1, e, 0}, time, 100);
    return end.hits == 100;
  });
  method("book", [](double m, double n, double e) { return contact::collapses(m, n, e); });
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("19_time_stepping");
  add_closing(runner);
  add_fall(runner);
  add_spring(runner);
  add_walls(runner);
  add_hits(runner);
  add_collapse(runner);
  return runner.run(argc, argv);
}
