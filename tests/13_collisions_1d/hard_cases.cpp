// Recomputes the answers of hard_cases.json and checks which methods are right in which case.
//
// Velocities, energies and rows are of class (a): rational in the stored numbers, rounded once. A
// velocity of "after" is right if its error is at most 16 u (|v₁| + |v₂|) + η, twice the bound of
// the reference; one of "small_velocity" if its error is at most 2^-40 of itself, which no formula
// in doubles can guarantee. The error of a loss may be 2^-40 of itself, that of a row 2^-40 Σ|v|. A
// count and a decision are right or not; counts are of class (c), by intervals, with ties decided
// algebraically.
#include "support/hard_cases.hpp"

#include <cmath>
#include <contact/block_count.hpp>
#include <contact/collision_1d.hpp>
#include <contact/cradle.hpp>
#include <cstdlib>
#include <vector>

using contact::LineBody;
using contact::LineCollision;
using hard_cases::Case;
using hard_cases::hex;
using hard_cases::Json;
using hard_cases::unhex;
using oracle::Rational;

namespace {

struct Pair {
  LineBody<double> first, second;
  double e;
};
Pair pair_of(const Case& c) {
  return {contact::line_body(c.number("m1"), c.number("v1")),
          contact::line_body(c.number("m2"), c.number("v2")), c.number("e")};
}
LineBody<Rational> exactly(const LineBody<double>& body) {
  return {oracle::exact(body.mass), oracle::exact(body.velocity)};
}
LineCollision<Rational> right_answer(const Pair& p) {
  return contact::collide(exactly(p.first), exactly(p.second), oracle::exact(p.e));
}

using Method = LineCollision<double> (*)(const Pair&);

LineCollision<double> textbook(const Pair& p) {
  const auto& [a, b, e] = p;
  if (!(a.velocity > b.velocity)) return {false, a.velocity, b.velocity};
  const double mass = a.mass + b.mass;
  return {true, ((a.mass - e * b.mass) * a.velocity + (1 + e) * b.mass * b.velocity) / mass,
          ((b.mass - e * a.mass) * b.velocity + (1 + e) * a.mass * a.velocity) / mass};
}
LineCollision<double> without_test(const Pair& p) {
  const auto& [a, b, e] = p;
  const auto share = contact::mass_shares(a.mass, b.mass);
  const double change = (1 + e) * (a.velocity - b.velocity);
  return {true, a.velocity - change * share.second, b.velocity + change * share.first};
}
LineCollision<double> by_impulse(const Pair& p) {
  const auto& [a, b, e] = p;
  if (!(a.velocity > b.velocity)) return {false, a.velocity, b.velocity};
  const double impulse = (1 + e) * (a.velocity - b.velocity) * a.mass * b.mass / (a.mass + b.mass);
  return {true, a.velocity - impulse / a.mass, b.velocity + impulse / b.mass};
}
LineCollision<double> updated_too_early(const Pair& p) {
  auto [a, b, e] = p;
  if (!(a.velocity > b.velocity)) return {false, a.velocity, b.velocity};
  const auto share = contact::mass_shares(a.mass, b.mass);
  a.velocity -= (1 + e) * (a.velocity - b.velocity) * share.second;
  b.velocity += (1 + e) * (a.velocity - b.velocity) * share.first;
  return {true, a.velocity, b.velocity};
}
LineCollision<double> book(const Pair& p) { return contact::collide(p.first, p.second, p.e); }
LineCollision<double> book_exact(const Pair& p) {
  return contact::collide_exactly(p.first, p.second, p.e);
}

void add_after(hard_cases::Runner& runner) {
  for (const char* question : {"after", "small_velocity"}) {
    runner.question(question, [](const Case& c) {
      const auto right = right_answer(pair_of(c));
      return Json{{"class", "a"}, {"first", hex(right.first)}, {"second", hex(right.second)}};
    });
  }
  const auto add = [&runner](const char* name, Method method) {
    runner.method("after", name, [method](const Case& c, const Json&) {
      const Pair p = pair_of(c);
      const auto right = right_answer(p);
      const auto got = method(p);
      const Rational room = oracle::exact(0x1p-49) * (abs(oracle::exact(p.first.velocity)) +
                                                      abs(oracle::exact(p.second.velocity))) +
                            oracle::exact(0x1p-1074);
      const auto close = [&room](double x, const Rational& true_x) {
        const double distance = oracle::error(x, true_x);
        // Beyond the largest number, infinity is the right answer.
        if (!std::isfinite(x)) return x == oracle::nearest(true_x);
        return std::isfinite(distance) && oracle::exact(distance) <= room;
      };
      return close(got.first, right.first) && close(got.second, right.second);
    });
  };
  add("textbook", textbook);
  add("without test for approach", without_test);
  add("v₁ first, v₂ from it", updated_too_early);
  add("impulse / mass", by_impulse);
  add("book", book);
  add("book, exact", book_exact);
  const auto small = [&runner](const char* name, Method method) {
    runner.method("small_velocity", name, [method](const Case& c, const Json& answer) {
      const double right = unhex(answer, "first");
      return std::abs(method(pair_of(c)).first - right) <= std::ldexp(std::abs(right), -40);
    });
  };
  small("textbook", textbook);
  small("book", book);
  small("book, exact", book_exact);
}

void add_approach(hard_cases::Runner& runner) {
  runner.question("approach", [](const Case& c) {
    const bool yes = oracle::exact(c.number("v1")) > oracle::exact(c.number("v2"));
    return Json{{"class", "a"}, {"approach", yes}};
  });
  const auto add = [&runner](const char* name, auto decide) {
    runner.method("approach", name, [decide](const Case& c, const Json& answer) {
      return decide(c.number("v1"), c.number("v2")) == answer.at("approach").template get<bool>();
    });
  };
  add("v₁ − v₂ > 1e-9", [](double v1, double v2) { return v1 - v2 > 1e-9; });
  add("in float",
      [](double v1, double v2) { return static_cast<float>(v1) > static_cast<float>(v2); });
  add("v₁² > v₂²", [](double v1, double v2) { return v1 * v1 > v2 * v2; });
  add("book", [](double v1, double v2) {
    return contact::approaching(contact::line_body(1.0, v1), contact::line_body(1.0, v2));
  });
}

void add_lost(hard_cases::Runner& runner) {
  runner.question("lost", [](const Case& c) {
    const Pair p = pair_of(c);
    const Rational lost =
        contact::energy_lost(exactly(p.first), exactly(p.second), oracle::exact(p.e));
    return Json{{"class", "a"}, {"lost", hex(lost)}};
  });
  const auto add = [&runner](const char* name, auto method) {
    runner.method("lost", name, [method](const Case& c, const Json& answer) {
      const double right = unhex(answer, "lost");
      const double got = method(pair_of(c));
      return got == right || std::abs(got - right) <= std::ldexp(std::abs(right), -40);
    });
  };
  const auto energy = [](const LineBody<double>& body, double v) {
    return 0.5 * body.mass * v * v;
  };
  add("energy before − after", [energy](const Pair& p) {
    const auto after = book(p);
    return energy(p.first, p.first.velocity) + energy(p.second, p.second.velocity) -
           energy(p.first, after.first) - energy(p.second, after.second);
  });
  add("(1 − e²) of the total energy", [energy](const Pair& p) {
    return (1 - p.e * p.e) *
           (energy(p.first, p.first.velocity) + energy(p.second, p.second.velocity));
  });
  add("½ μ (1 − e²) w², as written", [](const Pair& p) {
    const double w = p.first.velocity - p.second.velocity;
    if (!(w > 0)) return 0.0;
    const double mu = p.first.mass * p.second.mass / (p.first.mass + p.second.mass);
    return 0.5 * mu * (1 - p.e * p.e) * (w * w);
  });
  add("book", [](const Pair& p) { return contact::energy_lost(p.first, p.second, p.e); });
}

/// ⌈π/θ⌉ − 1 for θ = arctan √(1/R): by intervals unless π/θ is an integer, which is 4 for R = 1 and
/// 6 for R = 3.
std::int64_t count_of(double ratio) {
  if (ratio == 1) return 3;
  if (ratio == 3) return 5;
  using oracle::Interval;
  for (unsigned bits = 128; bits <= 4096; bits *= 2) {
    const Interval one(Rational(1), bits);
    const Interval angle = atan(one / sqrt(Interval(oracle::exact(ratio), bits)));
    const Interval steps = Interval::pi(bits) / angle;
    const auto whole = [](const Rational& x) -> oracle::Integer {
      return numerator(x) / denominator(x);
    };
    const auto low = whole(steps.low());
    if (low == whole(steps.high())) return static_cast<std::int64_t>(low);
  }
  throw hard_cases::CorpusError("a count was not decided at 4096 bits");
}

void add_count(hard_cases::Runner& runner) {
  runner.question("count", [](const Case& c) {
    return Json{{"class", "c"}, {"count", count_of(c.number("ratio"))}};
  });
  const auto add = [&runner](const char* name, auto count) {
    runner.method("count", name, [count](const Case& c, const Json& answer) {
      return count(c.number("ratio")) == answer.at("count").template get<std::int64_t>();
    });
  };
  constexpr std::int64_t limit = 100000;
  add("float, formula", [](double r) { return contact::count_by_formula(static_cast<float>(r)); });
  add("formula", [](double r) { return contact::count_by_formula(r); });
  add("textbook", [](double r) { return contact::count_by_textbook(r, limit); });
  add("book, simulation", [](double r) { return contact::count_by_colliding(r, limit); });
  add("double-double, formula",
      [](double r) { return contact::count_by_formula(contact::DoubleDouble(r)); });
  add("book", [](double r) { return contact::count_collisions(r).value_or(-1); });
}

std::vector<LineBody<double>> row_of(const Case& c) {
  const auto masses = c.numbers("masses");
  const auto velocities = c.numbers("velocities");
  std::vector<LineBody<double>> row;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    row.push_back(contact::line_body(masses[i], velocities[i]));
  }
  return row;
}

void add_row(hard_cases::Runner& runner) {
  constexpr int limit = 1000;
  runner.question("row", [](const Case& c) {
    std::vector<LineBody<Rational>> row;
    for (const auto& ball : row_of(c)) row.push_back(exactly(ball));
    const auto settled = contact::collide_row(row, oracle::exact(c.number("e")),
                                              contact::PairOrder::fastest_first, limit);
    Json velocities = Json::array();
    for (const Rational& v : settled.velocities) velocities.push_back(hex(v));
    return Json{{"class", "a"}, {"velocities", velocities}};
  });
  const auto add = [&runner](const char* name, auto settle) {
    runner.method("row", name, [settle](const Case& c, const Json& answer) {
      const auto row = row_of(c);
      const std::vector<double> got = settle(row, c.number("e"));
      double size = 0;
      for (const auto& ball : row) size += std::abs(ball.velocity);
      for (std::size_t i = 0; i < got.size(); ++i) {
        const double right =
            std::strtod(answer.at("velocities")[i].template get<std::string>().c_str(), nullptr);
        if (!(std::abs(got[i] - right) <= std::ldexp(size, -40))) return false;
      }
      return true;
    });
  };
  add("all pairs at once", [](const std::vector<LineBody<double>>& row, double e) {
    return contact::collide_simultaneously(row, e, limit).velocities;
  });
  for (const auto& [name, order] :
       {std::pair{"book, from the left", contact::PairOrder::left_to_right},
        std::pair{"book, from the right", contact::PairOrder::right_to_left},
        std::pair{"book, fastest first", contact::PairOrder::fastest_first}}) {
    add(name, [order = order](const std::vector<LineBody<double>>& row, double e) {
      return contact::collide_row(row, e, order, limit).velocities;
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  hard_cases::Runner runner("13_collisions_1d");
  add_after(runner);
  add_approach(runner);
  add_lost(runner);
  add_count(runner);
  add_row(runner);
  return runner.run(argc, argv);
}
