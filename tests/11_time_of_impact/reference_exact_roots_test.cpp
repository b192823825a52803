// exact_roots.hpp: roots are counted and enclosed, and signs at them are right.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/exact_roots.hpp>
#include <vector>

#include "support/generators.hpp"

namespace {

using contact::Exact;
using contact::ExactPolynomial;

/// t − x.
ExactPolynomial factor_with_root(double x) {
  return ExactPolynomial::between(Exact(-x), Exact(1.0) - Exact(x));
}

/// t² − x, with the root √x.
ExactPolynomial square_less(double x) {
  const ExactPolynomial t = factor_with_root(0);
  return t * t - ExactPolynomial(Exact(x));
}

}  // namespace

TEST_CASE("the roots of products of linear factors are found, each once", "[roots]") {
  generators::Random random(1111);
  for (int round = 0; round < generators::tried(500); ++round) {
    std::vector<double> known;
    ExactPolynomial p(Exact(round % 2 == 0 ? 3.0 : -5.0));
    for (int k = random.integer(1, 4); k > 0; --k) {
      const double root = random.integer(-8, 16) / 8.0;
      p = p * factor_with_root(root);
      if (root >= 0 && root <= 1) known.push_back(root);
    }
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    const contact::ExactRoots found = contact::exact_roots(p);
    REQUIRE(found.roots.size() == known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      CHECK(found.roots[i].low <= Exact(known[i]));
      CHECK(Exact(known[i]) <= found.roots[i].high);
    }
  }
}

TEST_CASE("a root that is no fraction is enclosed to 2^-60 of itself", "[roots]") {
  const contact::ExactRoots found = contact::exact_roots(square_less(0.5));
  REQUIRE(found.roots.size() == 1);
  const auto [low, high] = contact::refined(found.roots[0], found.polynomial);
  CHECK(low * low < Exact(0.5));
  CHECK(Exact(0.5) < high * high);
  CHECK(high - low <= Exact(0x1p-60) * high);
}

TEST_CASE("roots that differ by less than doubles can tell are separated", "[roots]") {
  // √(1/2) and √(1/2 + 2^-120)
  const ExactPolynomial t = factor_with_root(0);
  const ExactPolynomial p = square_less(0.5);
  const ExactPolynomial q = p - ExactPolynomial(Exact(0x1p-120));
  CHECK(contact::exact_roots(p * q).roots.size() == 2);
  CHECK(contact::exact_roots(p * p).roots.size() == 1);
  CHECK(contact::exact_roots(p * (t - ExactPolynomial(Exact(2.0)))).roots.size() == 1);
}

TEST_CASE("signs at a root are right where bounds do not decide them", "[roots]") {
  const ExactPolynomial p = square_less(0.5);
  const contact::ExactRoots found = contact::exact_roots(p);
  REQUIRE(found.roots.size() == 1);
  const auto sign = [&](const ExactPolynomial& q) {
    return contact::sign_at_root(q, found.polynomial, found.roots[0]);
  };
  CHECK(sign(p) == 0);
  CHECK(sign(p * factor_with_root(3)) == 0);
  CHECK(sign(p + ExactPolynomial(Exact(0x1p-200))) == 1);
  CHECK(sign(p - ExactPolynomial(Exact(0x1p-200))) == -1);
  CHECK(sign(factor_with_root(0)) == 1);
  CHECK(sign(ExactPolynomial()) == 0);
}

TEST_CASE("a tiny root is found, and no root outside the step", "[roots]") {
  const contact::ExactRoots found =
      contact::exact_roots(factor_with_root(0x1p-1000) * factor_with_root(0x1p500));
  REQUIRE(found.roots.size() == 1);
  const auto [low, high] = contact::refined(found.roots[0], found.polynomial);
  CHECK(low <= Exact(0x1p-1000));
  CHECK(Exact(0x1p-1000) <= high);
  CHECK(contact::detail::time_down<double>(low) == 0x1p-1000);
  CHECK(contact::exact_roots(ExactPolynomial(Exact(4.0))).roots.empty());
}

TEST_CASE("a root far below the smallest double is enclosed to 2^-1200", "[roots]") {
  const Exact large = Exact(0x1p1000) * Exact(0x1p1000) * Exact(3.0);
  const auto p =
      ExactPolynomial::between(Exact(-1.0), large - Exact(1.0));  // the root is 1 / large
  const contact::ExactRoots found = contact::exact_roots(p);
  REQUIRE(found.roots.size() == 1);
  const auto [low, high] = contact::refined(found.roots[0], found.polynomial);
  CHECK(low.sign() == 0);
  CHECK(large * high >= Exact(1.0));
  CHECK(high <= Exact(0x1p-600) * Exact(0x1p-600));
}

TEST_CASE("two roots that take thousands of halvings are separated", "[roots]") {
  const Exact large = Exact(0x1p1000) * Exact(0x1p1000) * Exact(0x1p500);
  const auto below = ExactPolynomial::between(Exact(-1.0), large - Exact(1.0));
  const auto above = ExactPolynomial::between(Exact(-3.0), large - Exact(3.0));
  const contact::ExactRoots found = contact::exact_roots(below * above);
  REQUIRE(found.roots.size() == 2);
  CHECK(large * found.roots[0].low <= Exact(1.0));
  CHECK(large * found.roots[0].high >= Exact(1.0));
  CHECK(large * found.roots[1].low <= Exact(3.0));
  CHECK(large * found.roots[1].high >= Exact(3.0));
  CHECK(found.roots[0].high <= found.roots[1].low);
}
