// Right answers are sums without rounding, rounded once. Every test asks for at least two different
// answers, so that no constant passes one.
#include "sum_of_impulses.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <algorithm>
#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Impulses = std::vector<double>;

double in_order(const Impulses& impulses) {
  double sum = 0;
  for (const double x : impulses) sum += x;
  return sum;
}

double kahan(const Impulses& impulses) {
  double sum = 0;
  double carry = 0;
  for (const double x : impulses) {
    const double y = x - carry;
    const double next = sum + y;
    carry = (next - sum) - y;
    sum = next;
  }
  return sum;
}

Impulses sorted(Impulses impulses, bool rising) {
  std::stable_sort(impulses.begin(), impulses.end(), [rising](double x, double y) {
    return rising ? std::abs(x) < std::abs(y) : std::abs(x) > std::abs(y);
  });
  return impulses;
}

void check(const Impulses& impulses) {
  Exact sum;
  double size = 0;
  for (const double x : impulses) {
    sum += Exact(x);
    size += std::abs(x);
  }
  const double right = quotient<double>(sum, Exact(1.0));
  const double n = static_cast<double>(impulses.size());
  const double bound = 2 * 0x1p-53 * std::abs(right) + 2 * n * n * 0x1p-106 * size;
  ask("What is the sum of the impulses?")
      .given("impulses", impulses)
      .suspect("rounding-added-up", [&] { return in_order(impulses); })
      .suspect("kahan-large-term", [&] { return kahan(impulses); })
      .suspect("sorting-for-accuracy", [&] { return in_order(sorted(impulses, true)); })
      .suspect("sorting-for-accuracy", [&] { return in_order(sorted(impulses, false)); })
      .suspect("float-accumulator",
               [&]() -> double {
                 float total = 0;
                 for (const double x : impulses) total += static_cast<float>(x);
                 return total;
               })
      .answer([&] { return exercise::total(impulses); })
      .close_to(right, within(bound));
}

constexpr double kLarge = 0x1p+60;

}  // namespace

TEST_CASE("a few impulses add up") {
  check({});
  check({3});
  check({1, -4, 0.5});
  check({16777216, 1, 1});
}

TEST_CASE("small impulses beside a large one are not lost") {
  check({0x1p+55, 3, -0x1p+55, 2});
  check({0x1p+54, 1, 1, 1, -0x1p+54});
  check({kLarge, 1, 1, 1, -kLarge});
  check({-kLarge, 0.5, kLarge});
  check({0x1p+54, 1, 1, 1, 1});
}

TEST_CASE("the total is right if large impulses cancel") {
  check({kLarge, 3, 0x1p+57, -kLarge, 1, -0x1p+57});
  check({0x1p+55, 5, -0x1p+54, 7, -0x1p+54});
  check({kLarge, 0x1p+40, -kLarge, -0x1p+40});
}

TEST_CASE("a large impulse may come late") {
  check({1, 0x1p+54, 1, 1, 1, 1, -0x1p+54});
  check({1, kLarge, 1, -kLarge});
  check({3, -kLarge, 0.25, kLarge, 8});
}

TEST_CASE("ten thousand impulses") {
  Impulses there(10000, 0.1);
  check(there);
  for (std::size_t i = 0; i < there.size(); i += 2) there[i] = -0.3;
  check(there);
}

TEST_CASE("random impulses agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200; ++asked) {
    Impulses impulses;
    for (int n = random.integer(1, 30); n > 0; --n) {
      const double x = random.magnitude(0, 50);
      impulses.push_back(x);
      if (random.chance(0.8)) impulses.push_back(-x * (1 + std::ldexp(random.uniform(), -45)));
    }
    for (std::size_t i = impulses.size(); i > 1; --i) {
      const auto other = static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1));
      std::swap(impulses[i - 1], impulses[other]);
    }
    check(impulses);
  }
}
