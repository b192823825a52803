// impulse_sum.hpp against rational arithmetic on the stored numbers (class (a) of the oracle). u is
// the unit roundoff of the type. A bound in a comment of the reference is tested
// without an allowance.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impulse_sum.hpp>
#include <limits>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using generators::any_finite;
using generators::Random;
using oracle::Rational;
using reference::impulses;
using reference::Push;
using rounding::error;
using rounding::eta;
using rounding::gamma;
using rounding::nearest;
using rounding::u;

namespace {

template <class S>
Rational sum_of(const std::vector<S>& terms) {
  Rational sum = 0;
  for (const S x : terms) sum += oracle::exact(x);
  return sum;
}

template <class S>
Rational size_of(const std::vector<S>& terms) {
  Rational sum = 0;
  for (const S x : terms) sum += abs(oracle::exact(x));
  return sum;
}

constexpr std::array<Push, 4> all_pushes{Push::one_way, Push::both_ways, Push::zero_total,
                                         Push::spread};

}  // namespace

TEMPLATE_TEST_CASE("every sum of impulses satisfies the bound in its comment", "", float, double) {
  using S = TestType;
  Random random(1201);
  int zero_totals = 0;
  int cancelled = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto terms = impulses<S>(random, all_pushes[static_cast<std::size_t>(i) % 4]);
    const int n = static_cast<int>(terms.size());
    const Rational right = sum_of(terms);
    const Rational size = size_of(terms);
    const int halvings = static_cast<int>(std::bit_width(static_cast<unsigned>(n - 1)));
    REQUIRE(error(contact::total_recursive(terms), right) <= gamma<S>(n - 1) * size);
    REQUIRE(error(contact::total_pairwise(terms), right) <= gamma<S>(halvings + 4) * size);
    REQUIRE(error(contact::total_compensated(terms), right) <=
            u<S>() * abs(right) + gamma<S>(n - 1) * gamma<S>(n - 1) * size);
    REQUIRE(error(contact::total_kahan(terms), right) <=
            (2 * u<S>() + 8 * n * u<S>() * u<S>()) * size);
    REQUIRE(contact::total_exactly(terms) == nearest<S>(right));
    const S total = contact::total_impulse(terms);
    REQUIRE(error(total, right) <= 3 * u<S>() * abs(right));
    REQUIRE((total == S(0)) == (right == 0));
    zero_totals += right == 0;
    cancelled += abs(right) < size * u<S>();
  }
  CHECK(zero_totals > 500);
  CHECK(cancelled > 900);
}

TEST_CASE("sums of rationals are exact in every order") {
  Random random(1202);
  for (int i = 0; i < 200; ++i) {
    std::vector<Rational> terms;
    for (const double x : impulses<double>(random, Push::spread)) terms.push_back(oracle::exact(x));
    Rational right = 0;
    for (const Rational& x : terms) right += x;
    REQUIRE(contact::total_recursive(terms) == right);
    REQUIRE(contact::total_pairwise(terms) == right);
  }
}

TEST_CASE("a thousand tenths between a large impulse and its opposite, as in the lesson") {
  const auto tenths = []<class S>(S, int power) {
    std::vector<S> all(1002, S(0.1F));
    all.front() = std::ldexp(S(1), power);
    all.back() = -all.front();
    return all;
  };
  CHECK(contact::total_recursive(tenths(0.0F, 21)) == 0);
  CHECK(contact::total_recursive(tenths(0.0F, 20)) == 125);
  CHECK(contact::total_recursive(tenths(0.0F, 18)) == 93.75F);
  CHECK(contact::total_recursive(tenths(0.0, 50)) == 0);
  CHECK(contact::total_recursive(tenths(0.0, 49)) == 125);
  CHECK(contact::total_pairwise(tenths(0.0F, 29)) > 0);
  CHECK(contact::total_pairwise(tenths(0.0F, 30)) == 0);
  for (int power = 0; power <= 52; ++power) {
    CAPTURE(power);
    CHECK(std::abs(contact::total_compensated(tenths(0.0F, power)) - 100) < 0.002F);
    // Kahan's correction is rounded to the digits of the last term, which are just below 2^power:
    // from 2^27 on they are multiples of 8, and 100 is none.
    if (power < 20) continue;
    const float kahan = contact::total_kahan(tenths(0.0F, power));
    CHECK(std::fmod(kahan, std::ldexp(1.0F, power - 24)) == 0);
    CHECK((kahan == 100) == (power < 27));
  }
  CHECK(contact::total_kahan(tenths(0.0F, 32)) == 0);
}

TEST_CASE("a sum with an intermediate overflow is finite, and none is NaN") {
  const double big = std::numeric_limits<double>::max();
  const std::vector<double> there_and_back{big, big, 3.0, -big, -big};
  CHECK(contact::total_exactly(there_and_back) == 3.0);
  CHECK(contact::total_impulse(there_and_back) == 3.0);
  for (const auto total : {contact::total_recursive<double>, contact::total_pairwise<double>,
                           contact::total_compensated<double>, contact::total_kahan<double>}) {
    CHECK(std::isfinite(total(there_and_back)));
    CHECK(std::abs(total({big, big / 2, -big}) - big / 2) <= 1e-15 * big);
    CHECK(total({big, big}) == std::numeric_limits<double>::infinity());
    CHECK(total({}) == 0.0);
  }
  CHECK(contact::total_exactly<double>({}) == 0.0);
  CHECK(contact::total_impulse<double>({}) == 0.0);
  Random random(1203);
  for (int i = 0; i < 3000; ++i) {
    std::vector<double> terms;
    for (int n = random.integer(0, 12); n > 0; --n) {
      terms.push_back(random.chance(0.5) ? any_finite(random) : random.magnitude(1015, 1023));
    }
    REQUIRE_FALSE(std::isnan(contact::total_recursive(terms)));
    REQUIRE_FALSE(std::isnan(contact::total_pairwise(terms)));
    REQUIRE_FALSE(std::isnan(contact::total_compensated(terms)));
    REQUIRE(contact::total_exactly(terms) == oracle::nearest(sum_of(terms)));
    const double total = contact::total_impulse(terms);
    REQUIRE_FALSE(std::isnan(total));
    if (std::isfinite(total)) {
      REQUIRE(error(total, sum_of(terms)) <= 3 * u<double>() * abs(sum_of(terms)) + eta<double>());
    }
  }
}
