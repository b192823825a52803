// What do accurate sums of many impulses cost?
#include <support/ladder.hpp>

#include <contact/impulse_sum.hpp>

#ifdef CONTACT_HAS_GMP
#include <boost/multiprecision/gmp.hpp>
#endif

namespace {

constexpr int count = 128;

/// The same impulses stored as float and as double; the conversion is not timed.
struct Input {
  std::vector<float> in_float;
  std::vector<double> in_double;
};

/// A sum as the nearest number and the rest, and Σ|Jᵢ|, the scale of the error.
struct Sum {
  double nearest = 0;
  double rest = 0;
  double size = 0;
};

/// The answer of a method, for the floats or for the doubles; the truth has both.
struct Answer {
  bool of_floats = false;
  Sum in_float, in_double;
};

Input in_both_types(std::vector<double> impulses) {
  std::vector<float> narrow;
  for (const double x : impulses) narrow.push_back(static_cast<float>(x));
  return {std::move(narrow), std::move(impulses)};
}

void shuffle(generators::Random& random, std::vector<double>& impulses) {
  for (std::size_t i = impulses.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1));
    std::swap(impulses[i - 1], impulses[other]);
  }
}

/// Impulses of one sign.
Input one_way(generators::Random& random) {
  std::vector<double> impulses;
  for (int i = 0; i < count; ++i) impulses.push_back(random.uniform(0.5, 1));
  return in_both_types(std::move(impulses));
}

/// Samples of a force that changes sign.
Input to_and_fro(generators::Random& random) {
  std::vector<double> impulses;
  const double period = random.uniform(5, 20);
  const double start = random.uniform();
  for (int i = 0; i < count; ++i) {
    // A triangle wave between -1 and 1.
    const double phase = i / period + start;
    const double share = phase - std::floor(phase);
    impulses.push_back(4 * std::abs(share - 0.5) - 1);
  }
  return in_both_types(std::move(impulses));
}

/// Actions and reactions: every impulse and its opposite, in any order.
Input zero_total(generators::Random& random) {
  std::vector<double> impulses;
  for (int i = 0; i < count / 2; ++i) {
    const double x = random.uniform(-1, 1);
    impulses.push_back(x);
    impulses.push_back(-x);
  }
  shuffle(random, impulses);
  return in_both_types(std::move(impulses));
}

/// Sizes from 1 to 2^53, about 10^16: large impulses come with their opposites, small ones do not.
Input spread(generators::Random& random) {
  std::vector<double> impulses;
  for (int i = 0; i < count / 4; ++i) {
    const double x = random.magnitude(40, 53);
    impulses.push_back(x);
    impulses.push_back(-x);
  }
  while (impulses.size() < count) {
    impulses.push_back(random.uniform(0.5, 1));
  }
  shuffle(random, impulses);
  return in_both_types(std::move(impulses));
}

template <class S>
Sum exact_sum(const std::vector<S>& impulses) {
  contact::Exact sum;
  double size = 0;
  for (const S x : impulses) {
    sum += contact::Exact(double(x));
    size += std::abs(double(x));
  }
  const auto nearest = rounded<double>(sum);
  return {nearest, rounded<double>(sum - contact::Exact(nearest)), size};
}

Answer truth_of(const Input& input) {
  return {false, exact_sum(input.in_float), exact_sum(input.in_double)};
}

#ifdef CONTACT_HAS_GMP
double by_rationals(const std::vector<double>& terms) {
  using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                                 boost::multiprecision::et_off>;
  Rational sum = 0;
  for (const double x : terms) sum += Rational(x);
  return static_cast<double>(sum);
}
#endif

ladder::Ladder<Input, Answer> experiment() {
  const auto judge = [](const Answer& got, const Answer& right) {
    ladder::Verdict verdict;
    const Sum& told = got.of_floats ? got.in_float : got.in_double;
    const Sum& truth = got.of_floats ? right.in_float : right.in_double;
    verdict.error = std::abs((told.nearest - truth.nearest) - truth.rest) / truth.size;
    return verdict;
  };
  ladder::Ladder<Input, Answer> ladder("What do 128 impulses add up to?", truth_of, judge);

  ladder.family("one-way", "all of one sign", one_way);
  ladder.family("to-and-fro", "a force that changes sign", to_and_fro);
  ladder.family("zero-total", "actions and reactions: zero total", zero_total);
  ladder.family("spread", "sizes from 1 to 1e16, the large ones cancel", spread);

  const auto in_both = [&ladder](const char* id, const char* title, auto method) {
    ladder.method(
        {.id = std::string(id) + "-float", .title = title, .scalar = "float", .exact = false},
        [method](const Input& input) {
          return Answer{true, {static_cast<double>(method(input.in_float)), 0, 0}, {}};
        });
    ladder.method(
        {.id = std::string(id) + "-double", .title = title, .scalar = "double", .exact = false},
        [method](const Input& input) {
          return Answer{false, {}, {method(input.in_double), 0, 0}};
        });
  };
  in_both("order", "recursive", [](const auto& terms) { return contact::total_recursive(terms); });
  in_both("pairwise", "pairwise", [](const auto& terms) { return contact::total_pairwise(terms); });
  in_both("kahan", "Kahan", [](const auto& terms) { return contact::total_kahan(terms); });
  in_both("compensated", "compensated",
          [](const auto& terms) { return contact::total_compensated(terms); });

  const auto exact = [&ladder](const char* id, const char* title, const char* scalar, auto method) {
    ladder.method({.id = id, .title = title, .scalar = scalar, .exact = true},
                  [method](const Input& input) {
                    return Answer{false, {}, {method(input.in_double), 0, 0}};
                  });
  };
  exact("filtered", "the book's: compensated, else exact", "double, then exact",
        [](const std::vector<double>& terms) { return contact::total_impulse(terms); });
  exact("exact", "exact", "exact",
        [](const std::vector<double>& terms) { return contact::total_exactly(terms); });
#ifdef CONTACT_HAS_GMP
  exact("rational", "in fractions (GMP)", "rational", by_rationals);
#endif
  ladder.recommend("filtered");
  ladder.show(
      [](const Input& input, const Answer& got, const Answer& right, const ladder::Method&) {
        const Sum& told = got.of_floats ? got.in_float : got.in_double;
        const Sum& truth = got.of_floats ? right.in_float : right.in_double;
        ladder::Example example;
        // The figure lists the impulses.
        example.facts = {ladder::number("sum by this method, N·s", told.nearest),
                         ladder::number("exact, then rounded, N·s", truth.nearest)};
        const std::vector<double> impulses =
            got.of_floats ? std::vector<double>(input.in_float.begin(), input.in_float.end())
                          : input.in_double;
        example.figure = "given_sums";
        example.fields = {ladder::field("impulses", impulses),
                          {"type", {got.of_floats ? 0.0 : 1.0}},
                          {"count", {double(count)}}};
        example.note = "The figure adds these impulses one after the other.";
        return example;
      });
  return ladder;
}

}  // namespace

LADDER(experiment)
