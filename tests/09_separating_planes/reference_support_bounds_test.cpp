// Bounds on supports against exact ones, with one square root.
#include <09_separating_planes/pair_families.hpp>
#include <09_separating_planes/random_poses.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/support_bounds.hpp>
#include <limits>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <variant>

namespace support_bounds_test {
namespace {

using contact::support_bounds;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using pair_bodies::Kind;
using Point = contact::Vector3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Rational magnitude(const Rational& x) { return x < 0 ? Rational(-x) : x; }

// max n · x over a body, as a + b √d.
template <class Body>
Surd exact_support(const Body& body, const Vector& n) {
  Rational most = n.dot(oracle::exact(Point(contact::vertex(body, 0))));
  for (int i = 1; i < contact::vertex_count(body); ++i) {
    const Rational along = n.dot(oracle::exact(Point(contact::vertex(body, i))));
    if (most < along) most = along;
  }
  return {most, oracle::exact(contact::radius_of(body)), n.dot(n)};
}
Surd exact_support(const contact::OrientedBox<double>& body, const Vector& n) {
  Rational most = n.dot(oracle::exact(body.centre));
  for (int i = 0; i < 3; ++i) {
    const Rational along = n.dot(oracle::exact(Point(body.axes.col(i))));
    most += magnitude(along) * oracle::exact(body.half_lengths(i));
  }
  return {most, 0, 0};
}
Surd exact_support(const contact::Lozenge<double>& body, const Vector& n) {
  Rational most = n.dot(oracle::exact(body.corner));
  for (const Point& edge : {body.first_edge, body.second_edge}) {
    const Rational along = n.dot(oracle::exact(edge));
    if (along > 0) most += along;
  }
  return {most, oracle::exact(body.radius), n.dot(n)};
}
Surd exact_support(const contact::Ellipsoid<double>& body, const Vector& n) {
  Rational squared = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational term =
        n.dot(oracle::exact(Point(body.axes.col(i)))) * oracle::exact(body.half_lengths(i));
    squared += term * term;
  }
  return {n.dot(oracle::exact(body.centre)), 1, squared};
}
Surd exact_support(const contact::Cylinder<double>& body, const Vector& n) {
  const Vector start = oracle::exact(body.core.start), end = oracle::exact(body.core.end);
  const Vector core = end - start, moment = n.cross(core);
  const Rational of_start = n.dot(start), of_end = n.dot(end);
  return {of_start < of_end ? of_end : of_start, oracle::exact(body.radius),
          moment.dot(moment) / core.dot(core)};
}

/// Whether x ≤ s.
bool at_most(double x, const Surd& s) {
  return x == -infinity || (x < infinity && oracle::sign(s + Rational(-oracle::exact(x))) >= 0);
}
bool at_least(double x, const Surd& s) {
  return x == infinity || (x > -infinity && oracle::sign(s + Rational(-oracle::exact(x))) <= 0);
}

/// Draws bodies and directions; scales them by powers of two from `low` to `high`.
template <class Check>
void for_bodies(std::uint64_t seed, int count, int low, int high, const Check& check) {
  Random random(seed);
  for (const Kind kind : pair_bodies::all_kinds) {
    for (int i = 0; i < generators::tried(count); ++i) {
      const auto frame = pair_families::detail::any_frame(random);
      const auto body = pair_bodies::scaled(pair_families::detail::body(random, kind, frame),
                                            random.integer(low, high));
      Point n = random_poses::direction(random);
      if (random.chance(0.3)) n(random.integer(0, 2)) = 0;
      if (random.chance(0.3)) n(random.integer(0, 2)) *= 0x1p-40;
      n *= std::ldexp(1.0, random.integer(low, high));
      std::visit([&](const auto& b) { check(b, n); }, body);
    }
  }
}

TEST_CASE("the bounds of a support contain the exact one, and are close together") {
  for_bodies(1, 400, -3, 3, [](const auto& body, const Point& n) {
    const auto bounds = support_bounds(body, n);
    const Surd exact = exact_support(body, oracle::exact(n));
    REQUIRE(at_most(bounds.down, exact));
    REQUIRE(at_least(bounds.up, exact));
    // |x| and sizes are at most 64 m.
    REQUIRE(bounds.up - bounds.down <= 0x1p-47 * 512 * n.norm());
    REQUIRE(contact::support_up(body, n) == bounds.up);
    REQUIRE(contact::support_down(body, n) == bounds.down);
  });
}

TEST_CASE("the bounds of a support hold for bodies and directions of any magnitude") {
  int known = 0, all = 0;
  for_bodies(2, 300, -500, 500, [&](const auto& body, const Point& n) {
    const auto bounds = support_bounds(body, n);
    const Surd exact = exact_support(body, oracle::exact(n));
    REQUIRE(at_most(bounds.down, exact));
    REQUIRE(at_least(bounds.up, exact));
    ++all;
    known += std::isfinite(bounds.up) ? 1 : 0;
  });
  CHECK(known == all);
  for_bodies(3, 150, -1070, 1010, [](const auto& body, const Point& n) {
    const auto bounds = support_bounds(body, n);
    const Surd exact = exact_support(body, oracle::exact(n));
    REQUIRE(at_most(bounds.down, exact));
    REQUIRE(at_least(bounds.up, exact));
  });
}

TEST_CASE("a support that is rounded without a bound is too small for many bodies") {
  int too_small = 0, all = 0;
  for_bodies(4, 100, 0, 0, [&](const auto& body, const Point& n) {
    const auto bounds = support_bounds(body, n);
    ++all;
    too_small +=
        at_least((bounds.up + bounds.down) / 2, exact_support(body, oracle::exact(n))) ? 0 : 1;
  });
  CHECK(too_small > all / 5);
}

TEST_CASE("the bounds of a float body are those of its stored numbers") {
  const contact::Sphere<float> ball{{0.1F, 0.2F, 0.3F}, 0.7F};
  const contact::Sphere<double> same{ball.centre.cast<double>(), double(ball.radius)};
  const Point n{1, -2, 0.5};
  CHECK(support_bounds(ball, n).up == support_bounds(same, n).up);
  CHECK(support_bounds(ball, n).down == support_bounds(same, n).down);
}

TEST_CASE("bounds of a support are 0 for no direction and infinite for what is not finite") {
  const contact::Sphere<double> ball{{1, 2, 3}, 1};
  CHECK(support_bounds(ball, Point::Zero()).up == 0);
  CHECK(support_bounds(ball, Point::Zero()).down == 0);
  for (const double bad : {nan, infinity, -infinity}) {
    CHECK(support_bounds(ball, Point(bad, 0, 0)).up == infinity);
    CHECK(support_bounds(ball, Point(bad, 0, 0)).down == -infinity);
    const contact::Sphere<double> nowhere{{bad, 2, 3}, 1};
    CHECK(support_bounds(nowhere, Point(1, 0, 0)).up == infinity);
    CHECK(support_bounds(nowhere, Point(1, 0, 0)).down == -infinity);
    const contact::ConvexHull<double> half{{{1, 2, 3}, {bad, 0, 0}}};
    CHECK(support_bounds(half, Point(1, 0, 0)).up == infinity);
    CHECK(support_bounds(half, Point(-1, 0, 0)).up == infinity);
  }
  const contact::Cylinder<double> flat{{{1, 2, 3}, {1, 2, 3}}, 1};
  CHECK(support_bounds(flat, Point(1, 0, 0)).up == infinity);
}

}  // namespace
}  // namespace support_bounds_test
