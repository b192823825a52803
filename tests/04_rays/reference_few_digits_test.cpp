// When the terms of a ray and a ball are exact in double.
#include <contact/few_digits.hpp>
#include <contact/ray_sphere.hpp>

#include <support/generators.hpp>

#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace {

using contact::Exact;
using contact::Ray;
using contact::Sphere;
using contact::Vector3;
using contact::detail::terms_are_exact;

Vector3<double> whole(generators::Random& random, int largest, double unit) {
  const double x = random.integer(-largest, largest) * unit;
  const double y = random.integer(-largest, largest) * unit;
  return {x, y, random.integer(-largest, largest) * unit};
}

TEST_CASE("terms that are said to be exact are") {
  generators::Random random(51);
  int exact = 0;
  for (int i = 0; i < generators::tried(200000); ++i) {
    const int largest = i % 3 == 0 ? 4 : i % 3 == 1 ? 500 : 3000;
    const double unit = std::ldexp(1.0, random.integer(-110, 95));
    const Ray<double> ray{whole(random, largest, unit),
                          whole(random, largest, std::ldexp(1.0, random.integer(-110, 95)))};
    const Sphere<double> ball{whole(random, largest, unit), random.integer(0, largest) * unit};
    const contact::SphereTerms<Exact> right =
        contact::detail::exact_terms(contact::exact_ray_of(ray), ball);
    REQUIRE(contact::hits_sphere(ray, ball) == contact::detail::hits_exactly(right, false));
    if (!terms_are_exact(ray, ball)) continue;
    ++exact;
    const contact::SphereTerms<double> got = contact::detail::RoughSphere(ray, ball).x;
    REQUIRE(Exact(got.a) == right.a);
    REQUIRE(Exact(got.b) == right.b);
    REQUIRE(Exact(got.c) == right.c);
    REQUIRE(Exact(got.depth) == right.depth);
  }
  CHECK(exact > generators::tried(50000));
}

TEST_CASE("whole numbers up to a thousand have few digits; a third, 2049 and no number have not") {
  const Sphere<double> ball{{500, 0, -500}, 1000};
  const Ray<double> ray{{-500, 3, 499}, {1000, 999, -7}};
  CHECK(terms_are_exact(ray, ball));
  for (const double bad : {1.0 / 3, 2049.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 0x1p200}) {
    Ray<double> other = ray;
    other.direction.y() = bad;
    CHECK_FALSE(terms_are_exact(other, ball));
    other = ray;
    other.origin.y() = bad;
    CHECK_FALSE(terms_are_exact(other, ball));
    CHECK_FALSE(terms_are_exact(ray, Sphere<double>{ball.centre, bad}));
  }
  CHECK_FALSE(terms_are_exact(ray, Sphere<double>{ball.centre, -1}));
}

}  // namespace
