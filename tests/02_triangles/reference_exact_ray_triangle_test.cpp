// exact_ray_triangle.hpp: no wrong answer for any finite input.
#include <02_triangles/adversarial.hpp>
#include <02_triangles/families.hpp>
#include <02_triangles/truth.hpp>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/barycentric.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/ray_triangle.hpp>
#include <limits>
#include <support/generators.hpp>
#include <support/oracle.hpp>

#include "reference.hpp"

using contact::Ray;
using contact::Segment;
using contact::Triangle;
using contact::Vector3;
using generators::Family;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::determinant;

namespace {

struct Count {
  int asked = 0, wrong = 0, hits = 0;
};

/// The exact test's decision and values, with and without its filter.
template <class Line>
void hold_exact(const Line& line, const Triangle<double>& triangle, Count& count) {
  const auto right = truth::meet(line, triangle);
  const auto got = contact::intersect_exact(line, triangle);
  ++count.asked;
  count.hits += right.has_value();
  if (got.has_value() != right.has_value()) {
    ++count.wrong;
    return;
  }
  if (!got) return;
  // 2^-40 max(1, |t|), as documented; beyond the largest double t is infinite.
  const Rational tolerance = Rational(1) / (Rational(1) * (std::int64_t{1} << 40));
  const Rational largest = oracle::exact(std::numeric_limits<double>::max());
  if (std::isinf(got->t)) {
    REQUIRE(right->t > largest);
  } else {
    REQUIRE(got->t >= 0);
    REQUIRE(oracle::error(got->t, right->t) <= tolerance * std::max(Rational(1), right->t));
  }
  REQUIRE(oracle::error(got->barycentric, right->weights) <= tolerance);
  REQUIRE(got->barycentric.minCoeff() >= 0);
  REQUIRE(got->barycentric.maxCoeff() <= 1);
}

}  // namespace

TEST_CASE("the exact test has no wrong answer over adversarial rays and segments") {
  // 17,000 of each of six kinds; half are read as rays and half as segments.
  Random random(31);
  for (std::size_t kind = 0; kind < adversarial::all.size(); ++kind) {
    Count count;
    for (int i = 0; i < generators::tried(17000); ++i) {
      const adversarial::Case c = adversarial::all[kind](random);
      CAPTURE(kind, i);
      if (i % 2 == 0) {
        hold_exact(Ray<double>{c.start, c.second}, c.triangle, count);
      } else {
        hold_exact(Segment<double>{c.start, c.second}, c.triangle, count);
      }
    }
    CAPTURE(kind, count.asked, count.hits);
    REQUIRE(count.wrong == 0);
    REQUIRE(count.hits > generators::tried(100));
  }
}

TEST_CASE("the exact test has no wrong answer over the common families") {
  Random random(32);
  for (const Family family : generators::all_families) {
    Count count;
    for (int i = 0; i < 2000; ++i) {
      const Triangle<double> triangle = generators::triangle(random, family);
      CAPTURE(generators::name(family), i);
      hold_exact(generators::ray(random, family, triangle), triangle, count);
      hold_exact(generators::segment(random, family, triangle), triangle, count);
    }
    CAPTURE(generators::name(family), count.hits);
    REQUIRE(count.wrong == 0);
    REQUIRE(count.hits > 100);
  }
}

TEST_CASE("for floats the exact test has no wrong answer, where float methods have many") {
  Random random(33);
  int asked = 0, wrong = 0, wrong_in_float = 0, wrong_in_double = 0;
  for (int i = 0; i < 6000; ++i) {
    const families::Aimed aimed =
        i % 2 == 0 ? families::at_edge(random) : families::on_grid(random);
    const Triangle<float>& triangle = aimed.triangles[0];
    const bool right = truth::meet(aimed.ray, triangle).has_value();
    const auto got = contact::intersect_exact(aimed.ray, triangle);
    ++asked;
    wrong += got.has_value() != right;
    wrong_in_float += contact::intersect_moller_trumbore(aimed.ray, triangle).has_value() != right;
    wrong_in_double += contact::intersect_moller_trumbore(contact::in_double(aimed.ray),
                                                          contact::in_double(triangle))
                           .has_value() != right;
  }
  CAPTURE(asked, wrong_in_float, wrong_in_double);
  REQUIRE(wrong == 0);
  REQUIRE(wrong_in_float > 1000);
  REQUIRE(wrong_in_double > 200);
}

TEST_CASE("with and without its filter the exact test makes the same decision, and agrees on t") {
  Random random(35);
  for (int i = 0; i < 6000; ++i) {
    const adversarial::Case c =
        adversarial::all[static_cast<std::size_t>(i) % adversarial::all.size()](random);
    const Ray<double> ray{c.start, c.second};
    const auto filtered = contact::intersect_exact(ray, c.triangle);
    const auto plain = contact::intersect_exact_unfiltered(ray, c.triangle);
    REQUIRE(filtered.has_value() == plain.has_value());
    if (!plain) continue;
    // Without the filter the values are the nearest doubles.
    const auto right = truth::meet(ray, c.triangle);
    REQUIRE(plain->t == oracle::nearest(right->t));
    REQUIRE(plain->barycentric == oracle::nearest(right->weights));
  }
}

TEST_CASE(
    "the filter decides almost everything that is not degenerate, and its bound is never "
    "exceeded") {
  Random random(36);
  int certain = 0;
  for (int i = 0; i < 20000; ++i) {
    const adversarial::Case c =
        adversarial::all[static_cast<std::size_t>(i) % adversarial::all.size()](random);
    const Vector3<double> p = c.triangle.a - c.start, q = c.triangle.b - c.start,
                          r = c.triangle.c - c.start;
    const contact::Bounded bounded = contact::bounded_volume(p, q, r);
    const Vector start = oracle::exact(c.start);
    const Triangle<Rational> exact = oracle::exact(c.triangle);
    const Rational right = determinant(exact.a - start, exact.b - start, exact.c - start);
    if (bounded.certain_sign() != 0) REQUIRE(bounded.certain_sign() == oracle::sign(right));
    if (std::isfinite(bounded.bound))
      REQUIRE(oracle::error(bounded.value, right) <= oracle::exact(bounded.bound));
    certain += bounded.certain_sign() != 0;
  }
  REQUIRE(certain > 4000);
  int undecided = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&] { return adversarial::point([&] { return random.uniform(-1, 1); }); };
    const Vector3<double> p = draw(), q = draw(), r = draw();
    undecided += contact::bounded_volume(p, q, r).certain_sign() == 0;
  }
  REQUIRE(undecided == 0);
}
