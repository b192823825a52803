// plane.hpp against the oracle. u is the unit roundoff of the type, η its
// smallest number. A decision has no tolerance: either the inputs decide it beyond the documented
// error bound, or the arithmetic is exact.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <contact/sphere_plane.hpp>
#include <limits>
#include <stdexcept>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle_planes.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::Plane;
using contact::Segment;
using contact::Side;
using contact::Triangle;
using contact::Vector3;
using generators::all_families;
using generators::any_finite;
using generators::any_vector;
using generators::Family;
using generators::Random;
using oracle::ExactPlane;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using reference::absolute_dot;
using reference::distance_bound;
using reference::fits;
using reference::plane_of;
using rounding::eta;
using rounding::gamma;
using rounding::u;
using support::contains;
using support::refusal;

TEMPLATE_TEST_CASE("a normalised vector is off by at most 4 u an entry", "", float, double) {
  using S = TestType;
  Random random(101);
  for (int i = 0; i < 6000; ++i) {
    Vector3<double> wide{random.magnitude(-140, 120), random.magnitude(-140, 120),
                         random.magnitude(-140, 120)};
    if constexpr (sizeof(S) == sizeof(double)) {
      if (random.chance(0.5)) wide = any_vector(random);
    }
    if (random.chance(0.1)) wide(random.integer(0, 2)) = 0;
    const Vector3<S> v = generators::rounded<S>(wide);
    if (v == Vector3<S>::Zero()) continue;
    const Vector3<S> n = contact::normalised(v);
    const auto right = oracle::unit_normal({oracle::exact(v), 0});
    // Squares and two sums are off by 3 u, which the root halves: 1.5 u; the root and the quotient
    // add u each. 3.5 u < 4 u.
    for (int k = 0; k < 3; ++k) {
      const double size = std::abs(oracle::nearest(right[static_cast<std::size_t>(k)]));
      const Rational bound = 4 * u<S>() * oracle::exact(size) + eta<S>();
      REQUIRE(oracle::exact(oracle::error(double(n(k)), right[static_cast<std::size_t>(k)])) <=
              bound);
    }
    const Vector e = oracle::exact(n);
    REQUIRE(abs(oracle::dot(e, e) - 1) <= oracle::exact(contact::tolerance::unit_normal<S>));
  }
}

TEMPLATE_TEST_CASE("a plane from a normal and a point passes the point within 4 u of its distance",
                   "", float, double) {
  using S = TestType;
  Random random(102);
  for (int i = 0; i < 4000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    const Vector3<S> normal = generators::rounded<S>(generators::point(random, Family::random));
    const Vector3<S> point = generators::rounded<S>(generators::point(random, family));
    if (normal == Vector3<S>::Zero()) continue;
    const auto plane = contact::plane_from_normal_and_point(normal, point);
    // For the stored normal, only the dot product of the offset is rounded: three successive
    // roundings.
    const ExactPlane stored = oracle::plane_as_stored(plane);
    const Vector x = oracle::exact(point);
    REQUIRE(abs(oracle::value(stored, x)) <=
            gamma<S>(3) * absolute_dot(stored.normal, x) + 2 * eta<S>());
    const auto right = oracle::unit_normal({oracle::exact(normal), 0});
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(oracle::exact(oracle::error(double(plane.normal(int(k))), right[k])) <= 4 * u<S>());
    }
  }
}

TEMPLATE_TEST_CASE(
    "a plane from coefficients has d on the left, so its offset is -d over the length", "", float,
    double) {
  using S = TestType;
  Random random(103);
  for (int i = 0; i < 6000; ++i) {
    const int range = sizeof(S) == sizeof(double) ? 900 : 100;
    const Vector3<S> v = generators::rounded<S>(Vector3<double>{random.magnitude(-range, range),
                                                                random.magnitude(-range, range),
                                                                random.magnitude(-range, range)});
    const S d = static_cast<S>(random.magnitude(-range, range));
    const Surd right = oracle::unit_offset({oracle::exact(v), -oracle::exact(d)});
    const double size = std::abs(oracle::nearest(right));
    // Near the largest number the offset may or may not overflow; that is tested separately below.
    if (size > double(std::numeric_limits<S>::max()) / 2) continue;
    const auto plane = contact::plane_from_coefficients(v.x(), v.y(), v.z(), d);
    // The length is off by 2.5 u (see above), the quotient adds u, scaling back may underflow: 3.5
    // u and η / 2.
    REQUIRE(oracle::exact(oracle::error(double(plane.offset), right)) <=
            4 * u<S>() * oracle::exact(size) + eta<S>());
  }
  const auto plane = contact::plane_from_coefficients<S>(0, 3, 4, -10);  // 3y + 4z = 10
  CHECK(plane.offset == S(2));
  CHECK(contact::side(plane, Vector3<S>(0, 0, 0)) == Side::back);
}

TEMPLATE_TEST_CASE("three points give a normal within 256 u, and only collinear ones are refused",
                   "", float, double) {
  using S = TestType;
  Random random(104);
  int made = 0;
  int refused = 0;
  const auto check = [&](const Triangle<S>& t) {
    CAPTURE(contact::vector_text(t.a), contact::vector_text(t.b), contact::vector_text(t.c));
    const ExactPlane right =
        oracle::plane_through(oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c));
    if (!right.exists()) {
      REQUIRE_THROWS_AS(contact::plane_from_points(t.a, t.b, t.c), std::invalid_argument);
      ++refused;
      return;
    }
    const auto plane = contact::plane_from_points(t.a, t.b, t.c);
    const auto unit = oracle::unit_normal(right);
    // The vector is off by at most 222 u from the cross product (derived beside the code) and 4 √3
    // u from normalising.
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(oracle::exact(oracle::error(double(plane.normal(int(k))), unit[k])) <= 256 * u<S>());
    }
    ++made;
  };
  for (int i = 0; i < 8000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    Triangle<double> t = generators::triangle(random, family);
    if (i % 3 == 1)
      t.c = t.a + random.uniform(-2, 2) * (t.b - t.a);  // collinear except for rounding
    if (i % 3 == 2) t.b = generators::detail::nudged(random, t.a, 3);  // an edge a few ulps long
    check(generators::rounded<S>(t));
  }
  if constexpr (sizeof(S) == sizeof(double)) {
    for (int i = 0; i < 1500; ++i) {  // any exponents, and one vertex near the largest number
      Triangle<double> t{any_vector(random), any_vector(random), any_vector(random)};
      t = {t.a / 4, t.b / 4, t.c / 4};  // so that the offset can be stored
      check(t);
    }
  }
  CHECK(made > 3000);
  CHECK(refused > 100);
}

TEMPLATE_TEST_CASE("a signed distance is within its stated error, and its sign is right beyond it",
                   "", float, double) {
  using S = TestType;
  Random random(105);
  int beyond = 0;
  int within = 0;
  for (int i = 0; i < 12000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    const auto t = generators::triangle(random, family);
    const auto plane = plane_of(generators::rounded<S>(t));
    if (!plane) continue;
    const Vector3<S> x = generators::rounded<S>(generators::point(random, family, t));
    const Rational right = oracle::value(oracle::plane_as_stored(*plane), oracle::exact(x));
    const S got = contact::signed_distance(*plane, x);
    const Rational bound = oracle::exact(contact::signed_distance_error(*plane, x));
    REQUIRE(distance_bound(*plane, x) <= bound);  // the computed bound covers the exact one
    REQUIRE(oracle::exact(oracle::error(double(got), right)) <= bound);
    if (abs(right) > bound) {
      REQUIRE(static_cast<int>(contact::side(*plane, x)) == oracle::sign(right));
      ++beyond;
    } else {
      ++within;
    }
  }
  CHECK(beyond > 2500);
  CHECK(within > 1000);  // the generators reach inputs that no rounded method decides
}

TEST_CASE("a distance from a point of the plane is accurate far from the origin") {
  Random random(106);
  for (int i = 0; i < 4000; ++i) {
    const auto t = generators::triangle(random, Family::far);
    const auto plane = plane_of(t);
    if (!plane) continue;
    const Vector3<double> x = generators::point(random, Family::far, t);
    const Vector to_x = oracle::exact(x) - oracle::exact(t.a);
    const Rational right = oracle::dot(oracle::exact(plane->normal), to_x);
    // A rounded difference, a product, two sums: four successive roundings, of x − a and not of x.
    REQUIRE(oracle::exact(
                oracle::error(contact::signed_distance_from_point(plane->normal, t.a, x), right)) <=
            gamma<double>(4) * absolute_dot(oracle::exact(plane->normal), to_x) +
                3 * eta<double>() / 2);
  }
}

TEST_CASE("the side of a plane through three points is right for every finite double") {
  Random random(107);
  std::array<int, 3> seen{};
  for (int i = 0; i < 10000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    Triangle<double> t = generators::triangle(random, family);
    Vector3<double> x = generators::point(random, family, t);
    if (i % 10 == 9) {
      t = {any_vector(random), any_vector(random), any_vector(random)};
      x = random.chance(0.3) ? t.b : any_vector(random);
    }
    const int right = oracle::side(
        oracle::plane_through(oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c)),
        oracle::exact(x));
    REQUIRE(static_cast<int>(contact::side_of_points_exactly(t.a, t.b, t.c, x)) == right);
    ++seen[static_cast<std::size_t>(right + 1)];
  }
  for (const int count : seen) CHECK(count > 500);
}

TEST_CASE("with rational numbers every query is exact") {
  Random random(108);
  int hits = 0;
  int in_plane = 0;
  for (int i = 0; i < 6000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    const auto t = oracle::exact(generators::triangle(random, family));
    const auto triangle = generators::triangle(random, family);
    const auto s = oracle::exact(generators::segment(random, family, triangle));
    const ExactPlane right = oracle::plane_through(
        oracle::exact(triangle.a), oracle::exact(triangle.b), oracle::exact(triangle.c));
    if (!right.exists()) continue;
    const contact::RawPlane<Rational> raw = contact::raw_plane_from_points<Rational>(
        oracle::exact(triangle.a), oracle::exact(triangle.b), oracle::exact(triangle.c));
    REQUIRE(raw.normal == right.normal);
    REQUIRE(static_cast<int>(contact::side(raw, t.a)) == oracle::side(right, t.a));
    // segment_plane uses ratios of distances only, so a normal of any length gives the same t and
    // point.
    const auto got = contact::segment_plane<Rational>(s, {raw.normal, raw.offset});
    const auto expected = oracle::crossing(s, right);
    REQUIRE(got.has_value() == expected.has_value());
    if (got) {
      REQUIRE(got->t == expected->t);
      REQUIRE(got->point == expected->point);
      ++hits;
    } else if (oracle::side(right, s.start) == 0) {
      ++in_plane;
    }
    const auto ball = oracle::exact(generators::sphere(random, family, triangle));
    REQUIRE(contact::sphere_meets_plane(ball, raw) == oracle::meets(ball, right));
  }
  CHECK(hits > 1500);
  CHECK(in_plane > 100);
}

TEST_CASE("no query turns finite input into NaN, whatever the bits") {
  Random random(114);
  for (int i = 0; i < 20000; ++i) {
    Vector3<double> direction = any_vector(random);
    if (direction == Vector3<double>::Zero()) continue;
    const Plane<double> plane{contact::normalised(direction), any_finite(random)};
    const Segment<double> s{any_vector(random), any_vector(random)};
    const double r = std::abs(any_finite(random));
    REQUIRE_FALSE(std::isnan(contact::signed_distance(plane, s.start)));
    REQUIRE_FALSE(std::isnan(contact::signed_distance_error(plane, s.start)));
    const auto hit = contact::segment_plane(s, plane);
    if (hit) {
      REQUIRE((hit->t >= 0 && hit->t <= 1));
      REQUIRE(contact::all_finite(hit->point));
    }
    const auto touch = contact::moving_sphere_plane({s.start, r}, s.end, plane);
    if (touch) {
      REQUIRE((touch->t >= 0 && touch->t <= 1));
      REQUIRE_FALSE(touch->centre.hasNaN());
      REQUIRE_FALSE(touch->point.hasNaN());
      REQUIRE(contact::all_finite(touch->normal));
    }
    (void)contact::sphere_meets_plane<double>({s.start, r}, plane);
  }
}

TEST_CASE("a distance is right though a partial sum overflows") {
  const double big = std::numeric_limits<double>::max();
  const Plane<double> plane =
      contact::plane_from_coefficients(0.529150262212918, 0.6, 0.6, -0.9 * big);
  // n·x − k adds 0.6 M + 0.6 M first, which is too large, though the sum is not.
  const Vector3<double> x(-big, big, big);
  const Rational right = oracle::value(oracle::plane_as_stored(plane), oracle::exact(x));
  const double got = contact::signed_distance(plane, x);
  CHECK(oracle::sign(right) == -1);
  CHECK(oracle::exact(oracle::error(got, right)) <= 8 * u<double>() * oracle::exact(big));
  const auto hit = contact::segment_plane<double>(
      {{big, big, big}, {-big, -big, -big}}, contact::plane_from_coefficients(1.0, 1.0, 1.0, 0.0));
  REQUIRE(hit.has_value());
  CHECK(hit->t == 0.5);
  CHECK(hit->point == Vector3<double>(0, 0, 0));
  // The start is 2.5 / √3 times the largest number away and the step takes 3 / √3 of it back: 5/6
  // of the step.
  const auto diagonal = contact::plane_from_coefficients(1.0, 1.0, 1.0, 0.0);
  const auto touch =
      contact::moving_sphere_plane<double>({{big / 2, big, big}, 1}, {-big, -big, -big}, diagonal);
  REQUIRE(touch.has_value());
  CHECK(std::abs(touch->t - 5.0 / 6) < 1e-15);
  CHECK(contact::all_finite(touch->point));
  // Edges longer than the largest number.
  const auto wide =
      contact::plane_from_points<double>({big, 0, 0}, {-big, big / 2, 0}, {-big, 0, big / 2});
  const auto unit = oracle::unit_normal(oracle::plane_through(
      oracle::exact(Vector3<double>(big, 0, 0)), oracle::exact(Vector3<double>(-big, big / 2, 0)),
      oracle::exact(Vector3<double>(-big, 0, big / 2))));
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(oracle::exact(oracle::error(wide.normal(int(k)), unit[k])) <= 256 * u<double>());
  }
}

TEST_CASE("a construction refuses bad input, naming the argument and the value") {
  const double inf = std::numeric_limits<double>::infinity();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  using V = Vector3<double>;
  const auto zero = refusal([] {
    contact::plane_from_normal_and_point<double>({0, 0, 0}, {1, 2, 3});
  });
  CHECK((contains(zero, "normal") && contains(zero, "(0, 0, 0)")));
  const auto infinite = refusal([&] {
    contact::plane_from_normal_and_point<double>({0, 0, 1}, {1, inf, 3});
  });
  CHECK((contains(infinite, "point") && contains(infinite, "inf")));
  const auto nan_normal = refusal([&] { contact::normalised(V(not_a_number, 0, 1)); });
  CHECK((contains(nan_normal, "normal") && contains(nan_normal, "nan")));
  const auto line = refusal([] {
    contact::plane_from_points<double>({0, 0, 0}, {1, 2, 3}, {2, 4, 6});
  });
  CHECK((contains(line, "a, b, c") && contains(line, "(2, 4, 6)") && contains(line, "line")));
  const auto same = refusal([] {
    contact::plane_from_points<double>({1, 2, 3}, {1, 2, 3}, {2, 4, 6});
  });
  CHECK(contains(same, "line"));
  const auto bad_b = refusal([&] {
    contact::plane_from_points<double>({0, 0, 0}, {inf, 2, 3}, {2, 4, 6});
  });
  CHECK(contains(bad_b, "b = "));
  const auto no_normal = refusal([] { contact::plane_from_coefficients(0.0, 0.0, 0.0, 4.0); });
  CHECK(contains(no_normal, "normal"));
  const auto bad_d =
      refusal([&] { contact::plane_from_coefficients(0.0, 0.0, 1.0, not_a_number); });
  CHECK((contains(bad_d, "d = ") && contains(bad_d, "nan")));
  const auto far_away = refusal([] { contact::plane_from_coefficients(0.0, 0.0, 1e-300, 1e300); });
  CHECK((contains(far_away, "d = ") && contains(far_away, "overflows")));
  const double big = std::numeric_limits<double>::max();
  const auto corner = refusal([&] {
    contact::plane_from_normal_and_point<double>({1, 1, 1}, {big, big, big});
  });
  CHECK((contains(corner, "point") && contains(corner, "overflows")));
}
