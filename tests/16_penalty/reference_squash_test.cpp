// The drawn shape of a ball that overlaps: its area or volume in fractions (class (a) of the
// oracle).
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/squash.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace squash_test {
namespace {

using contact::squash;
using contact::SquashKeeps;
using generators::Random;
using oracle::Rational;
using support::contains;
using support::refusal;

TEMPLATE_TEST_CASE("a squashed ball keeps its area or its volume and touches the surface", "",
                   float, double) {
  using S = TestType;
  Random random(1701);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  int held = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const S r = S(std::abs(random.magnitude(-30, 30)));
    const S d = S(random.uniform(0, 1.2) * double(r));
    const auto disc = squash(r, d, SquashKeeps::area);
    const auto ball = squash(r, d, SquashKeeps::volume);
    const Rational radius = oracle::exact(r);
    const Rational left = radius - oracle::exact(d);
    const Rational along = oracle::exact(disc.along);
    REQUIRE(disc.along == ball.along);
    REQUIRE(disc.held == ball.held);
    REQUIRE(abs(along - (disc.held ? Rational(radius / 4) : left)) <= 2 * u * radius);
    if (disc.held) REQUIRE(left < radius / 4 * (1 + 4 * u));
    if (!disc.held) REQUIRE(left >= radius / 4 * (1 - 4 * u));
    held += disc.held;
    const Rational area = along * oracle::exact(disc.across);
    REQUIRE(abs(area - radius * radius) <= 9 * u * radius * radius);
    const Rational volume = along * oracle::exact(ball.across) * oracle::exact(ball.across);
    REQUIRE(abs(volume - radius * radius * radius) <= 16 * u * radius * radius * radius);
    REQUIRE(disc.across >= ball.across);
  }
  CHECK(held > generators::tried(200));
}

TEST_CASE("a ball without overlap is drawn round") {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double d : {0.0, -1.0, -inf, inf, nan}) {
    const auto round = squash(2.0, d, SquashKeeps::volume);
    CHECK(round.along == 2);
    CHECK(round.across == 2);
    CHECK(!round.held);
  }
  const auto whole = squash(2.0, 0.5, SquashKeeps::area, 1.0);
  CHECK(whole.along == 2);
  CHECK(whole.held);
}

TEST_CASE("a squash without a radius or a flattest shape is refused") {
  CHECK(contains(refusal([] { squash(0.0, 1.0, SquashKeeps::area); }), "radius = 0"));
  CHECK(contains(refusal([] { squash(1.0, 1.0, SquashKeeps::area, 0.0); }), "flattest = 0"));
  CHECK(contains(refusal([] { squash(1.0, 1.0, SquashKeeps::area, 1.5); }), "flattest"));
}

}  // namespace
}  // namespace squash_test
