/// @file
/// Methods for the impulses of two contacts without friction, as the ladder measures them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/exact.hpp>
#include <contact/two_contacts.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "support/ladder.hpp"

namespace measured_two {

using contact::Exact;

template <class S>
using Pair = std::array<S, 2>;

/// A x + b are the velocities of the contacts after the impulses x.
template <class S>
struct Problem {
  Pair<Pair<S>> a{};  ///< 1/kg
  Pair<S> b{};        ///< m/s
};

/// Two contacts of a body of 1 kg and 0.25 kg·m², which the chapter's figure can show, or of two
/// bodies in a row.
struct Input {
  Problem<double> in_double;
  Problem<float> in_float;  ///< each number rounded to the nearest
  bool of_one_body = true;
  double first = 0, second = 0;               ///< lever arms, m
  double velocity = 0, angular_velocity = 0;  ///< before, m/s and rad/s
};

struct Answer {
  Pair<double> impulses{};    ///< N·s
  Pair<double> velocities{};  ///< of the contacts afterwards, m/s
  double speed = 1;           ///< the largest before, m/s
  bool found = true;
};

template <class S>
S velocity(const Problem<S>& p, std::size_t i, const Pair<S>& x) {
  return p.a[i][0] * x[0] + p.a[i][1] * x[1] + p.b[i];
}

template <class S>
Answer answered(const Problem<S>& p, const Pair<S>& x, bool found = true) {
  Answer answer;
  for (std::size_t i = 0; i < 2; ++i) {
    answer.impulses[i] = double(x[i]);
    answer.velocities[i] = double(velocity(p, i, x));
  }
  answer.speed = double(std::max(std::abs(p.b[0]), std::abs(p.b[1])));
  answer.found = found;
  return answer;
}

/// The velocities by the four cases, decided without rounding and rounded once. They are the same
/// for all solutions, also where the matrix has no inverse. The impulses are left at 0.
inline Answer truth(const Input& input) {
  const Problem<double>& p = input.in_double;
  Answer answer;
  answer.speed = std::max(std::abs(p.b[0]), std::abs(p.b[1]));
  if (p.b[0] >= 0 && p.b[1] >= 0) {
    answer.velocities = p.b;
    return answer;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t k = 1 - i;
    if (p.b[i] > 0) continue;
    const Exact other = Exact(p.a[i][i]) * Exact(p.b[k]) - Exact(p.a[k][i]) * Exact(p.b[i]);
    if (other.sign() < 0) continue;
    answer.velocities[k] = quotient<double>(other, Exact(p.a[i][i]));
    return answer;
  }
  return answer;  // both push, and neither moves away
}

/// Wrong is a velocity that is off by more than a thousandth of the speed of the impact, or a pull.
inline ladder::Verdict judge(const Answer& got, const Answer& right) {
  ladder::Verdict verdict;
  verdict.error = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double error = std::abs(got.velocities[i] - right.velocities[i]) / right.speed;
    if (!(error <= verdict.error)) verdict.error = error;
    if (!(got.impulses[i] >= 0)) verdict.wrong = true;
  }
  if (!got.found) {
    verdict.wrong = true;
    verdict.error = 1;
  }
  if (std::isnan(verdict.error)) verdict.error = 1;
  verdict.wrong = verdict.wrong || !(verdict.error <= 1e-3);
  return verdict;
}

// [iterations]
/// Gauss–Seidel from 0, starting with one of the contacts; one iteration is one contact after the
/// other.
template <class S>
Answer gauss_seidel(const Problem<S>& p, int iterations, std::size_t first, S relaxation) {
  Pair<S> x{};
  for (int n = 0; n < iterations; ++n) {
    for (const std::size_t i : {first, 1 - first})
      x[i] = std::max(S(0), x[i] - relaxation * velocity(p, i, x) / p.a[i][i]);
  }
  return answered(p, x);
}

/// Jacobi from 0, with half of each change.
template <class S>
Answer jacobi(const Problem<S>& p, int iterations) {
  Pair<S> x{};
  for (int n = 0; n < iterations; ++n) {
    const Pair<S> now = x;
    for (std::size_t i = 0; i < 2; ++i)
      x[i] = (now[i] + std::max(S(0), now[i] - velocity(p, i, now) / p.a[i][i])) / S(2);
  }
  return answered(p, x);
}
// [/iterations]

/// Restitution and impulse of one contact in place of both: the one that approaches faster.
inline Answer one_point(const Problem<double>& p) {
  const std::size_t i = p.b[1] < p.b[0] ? 1 : 0;
  Pair<double> x{};
  x[i] = std::max(0.0, -p.b[i] / p.a[i][i]);
  return answered(p, x);
}

/// Each contact as if it were alone, both impulses together.
inline Answer each_alone(const Problem<double>& p) {
  Pair<double> x{};
  for (std::size_t i = 0; i < 2; ++i) x[i] = std::max(0.0, -p.b[i] / p.a[i][i]);
  return answered(p, x);
}

/// The four cases as they stand, one after the other: the first that meets all conditions.
template <class S>
Answer four_cases(const Problem<S>& p) {
  const auto meets = [&p](const Pair<S>& x) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (!(x[i] >= S(0))) return false;
      if (x[i] == S(0) && !(velocity(p, i, x) >= S(0))) return false;
    }
    return true;
  };
  const auto& [a, b] = p;
  const S det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
  const std::array<Pair<S>, 4> cases{
      {{S(0), S(0)},
       {-b[0] / a[0][0], S(0)},
       {S(0), -b[1] / a[1][1]},
       {(a[0][1] * b[1] - a[1][1] * b[0]) / det, (a[1][0] * b[0] - a[0][0] * b[1]) / det}}};
  for (const Pair<S>& x : cases)
    if (meets(x)) return answered(p, x);
  return answered(p, {}, false);
}

/// The four cases of the reference, whose decisions are exact for the numbers as stored.
template <class S>
Answer block(const Problem<S>& p) {
  const auto x = contact::solve_two_contacts<S>({p.a[0][0], p.a[0][1], p.a[1][1]}, p.b[0], p.b[1]);
  return x ? answered<S>(p, {x->first, x->second}) : answered<S>(p, {}, false);
}

/// The active sets of the reference, in double.
inline Answer active_sets(const Problem<double>& p) {
  const auto x = contact::solve_complementarity<double>(
      {{p.a[0][0], p.a[0][1]}, {p.a[1][0], p.a[1][1]}}, {p.b[0], p.b[1]});
  return x ? answered<double>(p, {(*x)[0], (*x)[1]}) : answered<double>(p, {}, false);
}

inline Input completed(Input input) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k)
      input.in_float.a[i][k] = static_cast<float>(input.in_double.a[i][k]);
    input.in_float.b[i] = static_cast<float>(input.in_double.b[i]);
  }
  return input;
}

/// Contacts of one body. With few digits in the lever arms the matrix is exact.
inline Input on_body(double first, double second, double velocity, double angular_velocity) {
  Input input;
  input.first = first;
  input.second = second;
  input.velocity = velocity;
  input.angular_velocity = angular_velocity;
  const Pair<double> arms{first, second};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) input.in_double.a[i][k] = 1 + 4 * arms[i] * arms[k];
    input.in_double.b[i] = velocity + angular_velocity * arms[i];
  }
  return completed(input);
}

inline double on_grid(generators::Random& random, double most, double unit) {
  return std::round(random.uniform(-most, most) / unit) * unit;
}

/// A motion with which both contacts push, or any with which one of them approaches.
inline Input moving(generators::Random& random, double first, double second) {
  if (random.chance(0.5)) {
    const double x = random.uniform(0.1, 1), y = random.uniform(0.1, 1);
    return on_body(first, second, -(x + y), -4 * (first * x + second * y));
  }
  for (;;) {
    const double velocity = random.uniform(-3, 1);
    const Input input = on_body(first, second, velocity, random.uniform(-3, 3));
    if (std::min(input.in_double.b[0], input.in_double.b[1]) < -0.1) return input;
  }
}

/// A body on a lighter one on the ground; the lower contact is the first.
inline Input in_row(double upper, double lower, double upper_velocity, double lower_velocity) {
  Input input;
  input.of_one_body = false;
  input.in_double = {{{{1 / lower, -1 / lower}, {-1 / lower, 1 / lower + 1 / upper}}},
                     {lower_velocity, upper_velocity - lower_velocity}};
  return completed(input);
}

/// The figure shows the same body, from 0.
inline ladder::Example shown(const Input& input, const Answer& got, const Answer& right) {
  ladder::Example example;
  example.facts = {ladder::numbers("velocities of the contacts before, m/s", input.in_double.b),
                   ladder::numbers("impulses by this method, N s", got.impulses),
                   ladder::numbers("velocities afterwards by this method, m/s", got.velocities),
                   ladder::numbers("right, m/s", right.velocities)};
  if (!input.of_one_body) {
    example.note = "Two bodies in a row: the figure has contacts of one body.";
    return example;
  }
  example.figure = "iterations";
  example.fields = {{"first", {input.first}},
                    {"second", {input.second}},
                    {"velocity", {input.velocity}},
                    {"angular_velocity", {input.angular_velocity}},
                    {"start", {0, 0}},
                    {"relaxation", {1}},
                    {"share", {0.5}},
                    {"shown", {4}}};
  example.note = "The figure shows iterations from 0 and the block solve.";
  return example;
}

inline ladder::Ladder<Input, Answer> experiment() {
  ladder::Ladder<Input, Answer> ladder("What do two contacts do?", truth, judge);
  constexpr double fine = 0x1p-12, finest = 0x1p-20;
  ladder.family("random", "lever arms up to 2 m", [](generators::Random& random) {
    const double first = on_grid(random, 2, fine);
    return moving(random, first, on_grid(random, 2, fine));
  });
  ladder.family("symmetric", "symmetric, falls flat", [](generators::Random& random) {
    const double arm = 0.25 + std::abs(on_grid(random, 1.75, fine));
    return on_body(-arm, arm, -random.uniform(0.5, 3), 0);
  });
  ladder.family("parallel", "nearly at one point", [](generators::Random& random) {
    const double first = on_grid(random, 2, finest);
    const double apart = finest * random.integer(1, 1024);
    return moving(random, first, first + apart);
  });
  ladder.family("masses", "1,000 kg on 1 kg on the ground", [](generators::Random& random) {
    const double upper = -random.uniform(0.5, 3);
    return in_row(1000, 1, upper, random.uniform(-0.5, 0.5));
  });
  ladder.family("redundant", "at one point", [](generators::Random& random) {
    const double arm = on_grid(random, 2, fine);
    for (;;) {
      const double velocity = random.uniform(-3, 1);
      const Input input = on_body(arm, arm, velocity, random.uniform(-3, 3));
      if (input.in_double.b[0] < -0.1) return input;
    }
  });

  const auto in_double = [](const char* id, const char* title) {
    return ladder::Method{.id = id, .title = title, .scalar = "double", .exact = false};
  };
  const auto in_float = [](const char* id, const char* title) {
    return ladder::Method{.id = id, .title = title, .scalar = "float", .exact = false};
  };
  const auto iterated = [&](const char* id, const char* title, int n, double relaxation) {
    ladder.method(in_double(id, title), [=](const Input& input) {
      return gauss_seidel(input.in_double, n, 0, relaxation);
    });
  };
  ladder.method(in_double("one-point", "one point: the faster contact"),
                [](const Input& input) { return one_point(input.in_double); });
  ladder.method(in_double("each-alone", "each as if alone"),
                [](const Input& input) { return each_alone(input.in_double); });
  iterated("one-by-one", "one after the other", 1, 1);
  ladder.method(in_double("reversed", "one after the other, reversed"),
                [](const Input& input) { return gauss_seidel(input.in_double, 1, 1, 1.0); });
  iterated("gauss-seidel-4", "Gauss-Seidel, 4 iterations", 4, 1);
  iterated("gauss-seidel-16", "Gauss-Seidel, 16 iterations", 16, 1);
  iterated("gauss-seidel-64", "Gauss-Seidel, 64 iterations", 64, 1);
  iterated("relaxed-16", "16 iterations, over-relaxed by 1.5", 16, 1.5);
  ladder.method(in_double("jacobi-16", "Jacobi, 16 iterations"),
                [](const Input& input) { return jacobi(input.in_double, 16); });
  ladder.method(in_double("jacobi-64", "Jacobi, 64 iterations"),
                [](const Input& input) { return jacobi(input.in_double, 64); });
  ladder.method(in_float("four-cases-float", "four cases, the first that holds"),
                [](const Input& input) { return four_cases(input.in_float); });
  ladder.method(in_double("four-cases", "four cases, the first that holds"),
                [](const Input& input) { return four_cases(input.in_double); });
  ladder.method(in_double("active-sets", "active sets by elimination"),
                [](const Input& input) { return active_sets(input.in_double); });
  ladder.method(in_float("block-float", "block solve: four cases, exact decisions"),
                [](const Input& input) { return block(input.in_float); });
  ladder.method({.id = "block",
                 .title = "block solve: four cases, exact decisions",
                 .scalar = "double",
                 .exact = true},
                [](const Input& input) { return block(input.in_double); });
  ladder.method(
      {.id = "exact", .title = "four cases, exact signs", .scalar = "exact", .exact = true},
      [](const Input& input) { return truth(input); });
  ladder.recommend("block");
  ladder.show([](const Input& input, const Answer& got, const Answer& right,
                 const ladder::Method&) { return shown(input, got, right); });
  return ladder;
}

}  // namespace measured_two
