#include "support/generators.hpp"

#include <catch2/catch_test_macros.hpp>
#include <cstddef>

#include "support/oracle.hpp"

using namespace generators;

TEST_CASE("the same seed gives the same numbers, on every machine") {
  Random random(42);
  CHECK(random.bits() ==
        13679457532755275413u);  // published first outputs of splitmix64 for seed 42
  CHECK(random.bits() == 2949826092126892291u);
  CHECK(random.bits() == 5139283748462763858u);
}

TEST_CASE("numbers stay in their range and fill it") {
  Random random(7);
  double sum = 0;
  std::array<int, 9> seen{};
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform();
    REQUIRE((x >= 0 && x < 1));
    sum += x;
    const int k = random.integer(-4, 4);
    REQUIRE((k >= -4 && k <= 4));
    ++seen[static_cast<std::size_t>(k + 4)];
    const double m = std::abs(random.magnitude(-3, 5));
    REQUIRE((m >= 0.125 && m < 64));
  }
  CHECK(std::abs(sum / 20000 - 0.5) < 0.01);  // five standard deviations
  for (const int count : seen) CHECK((count > 1900 && count < 2550));
}

TEST_CASE("every family makes what it promises") {
  for (const Family family : all_families) {
    CAPTURE(name(family));
    Random random(11);
    int exactly_coplanar = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto t = proper_triangle(random, family);
      const auto s = segment(random, family, t);
      const auto r = ray(random, family, t);
      const auto sphere_near = sphere(random, family, t);
      const auto p = plane(random, family);
      const auto n = neighbour(random, family, t);
      REQUIRE((contact::all_finite(t.a) && contact::all_finite(t.b) && contact::all_finite(t.c)));
      REQUIRE((contact::all_finite(s.start) && contact::all_finite(s.end)));
      REQUIRE((contact::all_finite(r.origin) && contact::all_finite(r.direction)));
      REQUIRE((contact::all_finite(sphere_near.centre) && sphere_near.radius >= 0));
      REQUIRE(std::abs(p.normal.dot(p.normal) - 1) < 1e-15);
      REQUIRE((n.a == t.b && n.b == t.a));
      const auto e = oracle::exact(t);
      const oracle::Vector normal = oracle::Vector(e.b - e.a).cross(oracle::Vector(e.c - e.a));
      const oracle::Vector x = oracle::exact(point(random, family, t));
      if (normal.dot(oracle::Vector(x - e.a)) == 0) ++exactly_coplanar;
    }
    if (family == Family::coplanar) CHECK(exactly_coplanar == 2000);
    if (family == Family::grid) CHECK(exactly_coplanar > 20);
    if (family == Family::random) CHECK(exactly_coplanar == 0);
  }
}
