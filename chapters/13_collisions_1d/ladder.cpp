// What do right counts of collisions cost?
#include <support/ladder.hpp>

#include <contact/block_count.hpp>

namespace {

/// The same ratio stored as float and as double; the conversion is not timed.
struct Input {
  float in_float = 1;
  double in_double = 1;
};

/// The answer of a method, for the float or for the double; the truth has both.
struct Answer {
  bool of_float = false;
  std::int64_t in_float = 0;
  std::int64_t in_double = 0;
};

Input in_both_types(double ratio) { return {static_cast<float>(ratio), ratio}; }

/// 3 ≤ n ≤ largest, each length of n alike.
int number_of_steps(generators::Random& random, int largest) {
  const double wanted = random.uniform(5, largest);
  const int shift = random.integer(0, 9);
  return std::max(5, static_cast<int>(std::ldexp(wanted, -shift)));
}

Input any_ratio(generators::Random& random) {
  const double fraction = random.uniform(1, 2);
  return in_both_types(std::ldexp(fraction, random.integer(0, 15)));
}
Input power_of_100(generators::Random& random) {
  double ratio = 1;
  for (int k = random.integer(0, 3); k > 0; --k) ratio *= 100;
  return in_both_types(ratio);
}
/// Within 2 ulp of a tie, in either type.
Input near_tie(generators::Random& random) {
  const int n = number_of_steps(random, 5000);
  Input input = in_both_types(contact::close_call(n, random.integer(-2, 2)));
  for (int ulps = random.integer(-2, 2); ulps != 0; ulps += ulps < 0 ? 1 : -1) {
    input.in_float = std::nextafter(input.in_float, ulps < 0 ? 1.0f : 2 * input.in_float);
  }
  return input;
}

/// The truth, by none of the methods: the n with cot²(π/n) < M/m ≤ cot²(π/(n + 1)), from 3 on.
/// tie_ratio() is off by at most 2^-96 of itself (reference_block_count_test.cpp holds it against
/// intervals); a ratio that is nearer to a tie, and is none, does not occur here, and would be a
/// -1.
std::int64_t count_between_ties(double ratio) {
  if (ratio == 1) return 3;  // The two that a step reaches exactly, n = 4 and n = 6.
  if (ratio == 3) return 5;
  for (int n = std::max(3, static_cast<int>(3.14 * std::sqrt(ratio)));;) {
    const auto above_tie = [ratio](int steps) {
      return (contact::DoubleDouble(ratio) - contact::tie_ratio(steps)).high();
    };
    const double here = above_tie(n);
    const double next = above_tie(n + 1);
    if (!(std::min(std::abs(here), std::abs(next)) > 0x1p-95 * ratio)) return -1;
    if (here > 0 && next < 0) return n;
    n += here > 0 ? 1 : -1;
  }
}

Answer truth_of(const Input& input) {
  return {false, count_between_ties(input.in_float), count_between_ties(input.in_double)};
}

/// A double beside a tie is one of five neighbours that a figure compares; other ratios are shown
/// by their collisions, as long as these are few.
ladder::Example shown(const Input& input, const Answer& got, const Answer& right,
                      const ladder::Method& method) {
  const auto told = static_cast<double>(got.of_float ? got.in_float : got.in_double);
  const auto truth = static_cast<double>(got.of_float ? right.in_float : right.in_double);
  const double ratio = got.of_float ? static_cast<double>(input.in_float) : input.in_double;
  ladder::Example example;
  example.facts = {
      got.of_float ? ladder::number("M/m", input.in_float) : ladder::number("M/m", input.in_double),
      ladder::number("collisions by this method", told), ladder::number("exact", truth)};
  for (int n = static_cast<int>(truth) - 1; method.scalar == "double" && n <= truth + 2; ++n) {
    for (int ulps = -2; n >= 5 && n <= 5000 && ulps <= 2; ++ulps) {
      if (contact::close_call(n, ulps) != ratio) continue;
      example.figure = "close_calls";
      example.fields = {{"n", {static_cast<double>(n)}}};
      example.note = ulps == 0 ? "In the figure this ratio is the nearest to the tie."
                               : "In the figure this ratio is " + std::to_string(std::abs(ulps)) +
                                     " ulp " + (ulps < 0 ? "below" : "above") +
                                     " the one nearest to the tie.";
      return example;
    }
  }
  if (ratio <= 100) {
    example.figure = "clicks";
    example.fields = {{"ratio", {ratio}}, {"step", {truth}}};
    example.note = "The figure counts with the method that is never wrong.";
  } else {
    example.note = "The figure shows ratios up to 100, and so many collisions could not be seen.";
  }
  return example;
}

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    ladder::Verdict verdict;
    const std::int64_t told = got.of_float ? got.in_float : got.in_double;
    const std::int64_t truth = got.of_float ? right.in_float : right.in_double;
    verdict.undecided = told < 0;
    verdict.wrong = !verdict.undecided && told != truth;
    verdict.error = std::abs(static_cast<double>(told - truth));
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("How many collisions do the blocks make?", truth_of, judge);
  ladder.family("random", "ratios from 1 to 65536", any_ratio);
  ladder.family("powers", "1, 100, 10000, 1000000: the digits of π", power_of_100);
  ladder.family("ties", "within 2 ulp of cot²(π/n), n up to 5000", near_tie);

  constexpr std::int64_t limit = 20000;
  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(
        {.id = std::string(id) + "-float", .title = title, .scalar = "float", .exact = false},
        [method](const Input& input) {
          return Answer{true, method(input.in_float), 0};
        });
    ladder.method(
        {.id = std::string(id) + "-double", .title = title, .scalar = "double", .exact = false},
        [method](const Input& input) {
          return Answer{false, 0, method(input.in_double)};
        });
  };
  in_both("formula", "the formula with π and arctan",
          [](const auto& ratio) { return contact::count_by_formula(ratio); });
  in_both("textbook", "simulation, textbook formulas",
          [](const auto& ratio) { return contact::count_by_textbook(ratio, limit); });
  in_both("colliding", "simulation, the book's formulas",
          [](const auto& ratio) { return contact::count_by_colliding(ratio, limit); });
  ladder.method(
      {.id = "formula-double-double",
       .title = "the formula with π and arctan",
       .scalar = "double-double",
       .exact = false},
      [](const Input& input) {
        return Answer{false, 0, contact::count_by_formula(contact::DoubleDouble(input.in_double))};
      });
  ladder.method({.id = "certain",
                 .title = "the book's: the sign of sin nθ",
                 .scalar = "exact, then double-double",
                 .exact = true},
                [](const Input& input) {
                  return Answer{false, 0, contact::count_collisions(input.in_double).value_or(-1)};
                });
  ladder.recommend("certain");
  ladder.show(shown);
  return ladder;
}

}  // namespace

LADDER(experiment)
