// The right answer comes from whole numbers: with the values x − offset, sums and squares are
// whole, and both sides of the comparison are multiplied by all denominators. Every test asks for
// at least two different answers, so that no constant passes it.
#include "same_averages.hpp"

#include <cstdint>
#include <numeric>

#include <support/exercise.hpp>
#include <support/generators.hpp>

namespace {

using namespace contact::testing;
using exercise::Comparison;
using Whole = std::int64_t;
using Sample = std::vector<double>;

/// n values, their sum, and n times the sum of the squared distances from their mean.
struct Sums {
  Whole count = 0, sum = 0, squares = 0;
};

Sums sums_of(const std::vector<int>& values) {
  Sums sums{static_cast<Whole>(values.size()), 0, 0};
  for (const int x : values) sums.sum += x;
  for (const int x : values) sums.squares += sums.count * x * x;
  sums.squares -= sums.sum * sums.sum;
  return sums;
}

/// Both sides of the comparison, squared, times the same number. At most 20 values of at most 40,
/// so they are below 2^60.
struct Sides {
  Whole distance, limit;
};

/// @param halves twice the limit
Sides sides_of(const Sums& a, const Sums& b, int halves) {
  const Whole distance = a.sum * b.count - b.sum * a.count;
  return {4 * distance * distance * (a.count - 1) * (b.count - 1),
          Whole{halves} * halves *
              (a.squares * b.count * b.count * (b.count - 1) +
               b.squares * a.count * a.count * (a.count - 1))};
}

/// Wrong formulae.
enum class Way { one_value, added, alone, by_n, pooled, cancels, one_side, at_least };

Comparison compared(const Sample& first, const Sample& second, double limit, Way way) {
  if (first.size() < 2 || second.size() < 2) return Comparison::too_few;
  const auto mean = [](const Sample& x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  };
  const auto squares = [&](const Sample& x) {
    const double m = mean(x);
    double sum = 0;
    if (way == Way::cancels) {
      for (const double v : x) sum += v * v;
      return sum - static_cast<double>(x.size()) * m * m;
    }
    for (const double v : x) sum += (v - m) * (v - m);
    return sum;
  };
  const double n1 = static_cast<double>(first.size()), n2 = static_cast<double>(second.size());
  const double q1 = squares(first), q2 = squares(second);
  const double less = way == Way::by_n ? 0 : 1;
  const double e1 = q1 / (n1 - less) / n1, e2 = q2 / (n2 - less) / n2;
  double error = e1 + e2;
  if (way == Way::one_value) error = e1 * n1 + e2 * n2;
  if (way == Way::alone) error = e1;
  if (way == Way::pooled) error = (q1 + q2) / (n1 + n2 - 2) * (1 / n1 + 1 / n2);
  if (way == Way::added) error = std::pow(std::sqrt(e1) + std::sqrt(e2), 2);
  double distance = mean(first) - mean(second);
  if (way == Way::one_side) distance = std::max(0.0, distance);
  const double square = distance * distance, allowed = limit * limit * error;
  return square > allowed || (way == Way::at_least && square == allowed) ? Comparison::differ
                                                                         : Comparison::agree;
}

Sample moved(const std::vector<int>& values, double offset, double unit) {
  Sample moved;
  for (const int x : values) moved.push_back(offset + unit * x);
  return moved;
}

/// @param offset added to the values, in the unit of `unit`, so that sums with them are exact
void check(const std::vector<int>& first, const std::vector<int>& second, int halves,
           double offset = 0, double unit = 1) {
  const Sample a = moved(first, offset, unit), b = moved(second, offset, unit);
  const double limit = halves / 2.0;
  const Sums of_a = sums_of(first), of_b = sums_of(second);
  Comparison right = Comparison::too_few;
  if (a.size() >= 2 && b.size() >= 2) {
    const Sides sides = sides_of(of_a, of_b, halves);
    right = sides.distance > sides.limit ? Comparison::differ : Comparison::agree;
  }
  const auto like = [&](Way way) { return [&, way] { return compared(a, b, limit, way); }; };
  ask("Do the two means differ by more than chance explains?")
      .given("first", a)
      .given("second", b)
      .given("limit", limit)
      .suspect_if(
          "one-value-has-no-spread",
          [&](const Comparison& got) { return right == Comparison::too_few && got != right; })
      .suspect_if("no-spread-is-too-few",
                  [&](const Comparison& got) {
                    return got == Comparison::too_few && right != got && of_a.squares == 0 &&
                           of_b.squares == 0;
                  })
      .suspect("larger-on-one-side-only", like(Way::one_side))
      .suspect("equality-counts-as-more", like(Way::at_least))
      .suspect("deviation-of-one-value", like(Way::one_value))
      .suspect("divided-by-n", like(Way::by_n))
      .suspect("one-standard-error-alone", like(Way::alone))
      .suspect("standard-errors-added", like(Way::added))
      .suspect("variances-pooled", like(Way::pooled))
      .suspect("variance-cancels", like(Way::cancels))
      .answer([&] { return exercise::compare(a, b, limit); })
      .equals(right);
}

}  // namespace

TEST_CASE("one value has no spread") {
  check({5}, {1, 2}, 6);
  check({1, 3}, {}, 6);
  check({1, 3}, {2, 4}, 6);
  check({7}, {7}, 6);
  check({}, {}, 6);
}

TEST_CASE("means far apart") {
  check({1, 3}, {2, 4}, 6);
  check({20, 21, 22}, {1, 2, 3}, 6);
  check({1, 2, 3}, {20, 21, 22}, 6);
  check({4, 4, 4}, {5, 5}, 6);  // without any spread
}

TEST_CASE("a mean is better known than a value") {
  check({1, 1}, {8, 4}, 4);
  check({2, 3, 4, 2, 3, 4}, {5, 4, 5, 6, 5, 6}, 6);
  check({0, 9, 0, 9}, {5, 14, 5, 14}, 8);
}

TEST_CASE("two errors add as squares") {
  check({7, 10}, {0, 7}, 6);
  check({10, 3}, {3, 1}, 4);
  check({2, 0}, {5, 11}, 4);
  // The smaller sample has the larger spread, or the larger one.
  check({8, 12, 11, 12, 10}, {7, 0}, 6);
  check({0, 12, 0, 12, 0, 12, 0, 12}, {9, 10}, 2);
}

TEST_CASE("the distances from the sample's own mean are too small") {
  check({12, 11}, {8, 3}, 6);
  check({1, 5}, {0, 0}, 4);
  check({12, 11}, {4, 3}, 6);
}

TEST_CASE("exactly at the limit") {
  // A distance of 3 and a standard error of 1.
  check({-1, 1}, {3, 3}, 6);
  check({3, 3}, {-1, 1}, 6);
  check({-1, 1}, {4, 4}, 6);
  check({4, 4, 4}, {4, 4}, 6);  // 0 and 0
}

TEST_CASE("large means, small spread") {
  check({1, 3, 2, 2}, {3, 5, 4, 4}, 6, 1e8);
  check({1, 3, 2, 2}, {2, 4, 3, 3}, 6, 1e8);
  check({1, 3, 2, 2}, {9, 11, 10, 10}, 9, 5e8, 0x1p-10);
  check({1, 3, 2, 2}, {2, 4, 3, 3}, 9, 5e8, 0x1p-10);
  check({1, 1}, {1, 1, 1}, 9, -9e8);
}

TEST_CASE("random samples agree with whole numbers") {
  generators::Random random(seed(0));
  int asked = 0;
  while (asked < 400) {
    const auto sample = [&random](int middle, int spread) {
      std::vector<int> values;
      const int count = random.integer(0, 12);
      for (int i = 0; i < count; ++i) values.push_back(middle + random.integer(-spread, spread));
      return values;
    };
    const std::vector<int> first = sample(0, random.integer(1, 16));
    const int middle = random.integer(-16, 16);
    const std::vector<int> second = sample(middle, random.integer(1, 16));
    const int halves = random.integer(3, 9);
    const double unit = std::ldexp(1.0, random.integer(-16, 10));
    const double offset = unit * 1000 * random.integer(-400, 400);
    if (first.size() >= 2 && second.size() >= 2) {
      const Sides sides = sides_of(sums_of(first), sums_of(second), halves);
      const double ratio = static_cast<double>(sides.distance) / static_cast<double>(sides.limit);
      if (ratio > 0.97 && ratio < 1.03) continue;
    }
    ++asked;
    check(first, second, halves, offset, unit);
  }
}
