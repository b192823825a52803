// sphere_plane.hpp and moving_sphere_plane.hpp against the oracle. u is the unit roundoff of the
// type, η its smallest number. A decision has no tolerance: either the inputs decide it beyond the
// documented error bound, or the arithmetic is exact.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/sphere_plane.hpp>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle_planes.hpp"
#include "support/rounding.hpp"

using contact::Plane;
using contact::Sphere;
using contact::Triangle;
using contact::Vector3;
using generators::all_families;
using generators::any_finite;
using generators::any_vector;
using generators::Family;
using generators::Random;
using oracle::ExactPlane;
using oracle::Rational;
using oracle::Vector;
using reference::absolute_dot;
using reference::distance_bound;
using reference::fits;
using reference::plane_of;
using rounding::eta;
using rounding::gamma;
using rounding::u;

TEMPLATE_TEST_CASE("a sphere meets a plane as the oracle says", "", float, double) {
  using S = TestType;
  Random random(110);
  int decided = 0;
  int meeting = 0;
  int grazing = 0;
  for (int i = 0; i < 12000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    const auto t = generators::rounded<S>(generators::triangle(random, family));
    const auto plane = plane_of(t);
    if (!plane) continue;
    const Sphere<S> ball = generators::rounded<S>(generators::sphere(
        random, family,
        {t.a.template cast<double>(), t.b.template cast<double>(), t.c.template cast<double>()}));
    const auto e = oracle::exact(ball);

    // From the raw points, exactly: against an exact comparison of numbers with a root, without
    // squaring.
    const bool right = oracle::meets(
        e, oracle::plane_through(oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c)));
    REQUIRE(contact::sphere_meets_plane_exactly(ball, t.a, t.b, t.c) == right);
    meeting += right ? 1 : 0;

    // From the stored unit plane: right beyond the error of the distance (the comparison itself
    // does not round).
    const Rational d = oracle::value(oracle::plane_as_stored(*plane), e.centre);
    if (abs(abs(d) - e.radius) <= distance_bound(*plane, ball.centre)) {
      ++grazing;
      continue;
    }
    ++decided;
    REQUIRE(contact::sphere_meets_plane(ball, *plane) == (abs(d) <= e.radius));
  }
  CHECK(decided > 3500);
  CHECK(grazing > 300);
  CHECK(meeting > 1000);
}

TEST_CASE("the exact sphere test is right for any bit patterns, and rejects collinear points") {
  Random random(111);
  for (int i = 0; i < 1500; ++i) {
    const Triangle<double> t{any_vector(random), any_vector(random), any_vector(random)};
    const Sphere<double> ball{any_vector(random), std::abs(any_finite(random))};
    const ExactPlane plane =
        oracle::plane_through(oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c));
    REQUIRE(contact::sphere_meets_plane_exactly(ball, t.a, t.b, t.c) ==
            (plane.exists() && oracle::meets(oracle::exact(ball), plane)));
  }
  const Vector3<double> a(0, 0, 0);
  const Vector3<double> b(1, 1, 1);
  CHECK_FALSE(contact::sphere_meets_plane_exactly<double>({a, 1}, a, b, a));
  CHECK(
      contact::sphere_meets_plane<double>({{0, 0, 2}, 2}, contact::RawPlane<double>{{0, 0, 3}, 0}));
  CHECK_FALSE(contact::sphere_meets_plane<double>({{0, 0, 2}, -3},
                                                  contact::RawPlane<double>{{0, 0, 3}, 0}));
}

TEMPLATE_TEST_CASE("a moving sphere touches when and where the oracle says", "", float, double) {
  using S = TestType;
  Random random(112);
  int decided = 0;
  int hits = 0;
  int overlaps = 0;
  for (int i = 0; i < 12000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    const auto wide = generators::triangle(random, family);
    const auto t = generators::rounded<S>(wide);
    const bool rounds =
        family != Family::grid;  // as for segments: on the grid only the quotient is rounded
    const auto made = rounds ? plane_of(t) : [&] {
      const auto p = generators::plane(random, family);
      return std::optional(Plane<S>{generators::rounded<S>(p.normal), static_cast<S>(p.offset)});
    }();
    if (!made) continue;
    const Plane<S> plane = *made;
    Sphere<double> shape = generators::sphere(random, family, wide);
    if (random.chance(0.7) && rounds) shape.radius /= 8;
    const Sphere<S> ball = generators::rounded<S>(shape);
    const auto path = generators::segment(random, family, wide);
    const Vector3<S> displacement = generators::rounded<S>(Vector3<double>(path.end - path.start));

    // As stored: the plane's normal is treated as a unit vector, by its invariant.
    const ExactPlane stored = oracle::plane_as_stored(plane);
    const auto e = oracle::exact(ball);
    const Vector way = oracle::exact(displacement);
    const Rational d = oracle::value(stored, e.centre);
    const Rational rate = oracle::dot(stored.normal, way);
    const Rational d_error = rounds ? distance_bound(plane, ball.centre) : Rational(0);
    const Rational rate_error =
        rounds ? gamma<S>(3) * absolute_dot(stored.normal, way) + 3 * eta<S>() / 2 : Rational(0);
    const Rational gap = abs(d) - e.radius;
    const Rational gap_error = rounds ? d_error * (1 + u<S>()) + u<S>() * abs(gap) : Rational(0);
    const Rational closing = d > 0 || (d == 0 && rate <= 0) ? Rational(-rate) : rate;

    const auto got = contact::moving_sphere_plane(ball, displacement, plane);
    if (got) REQUIRE((got->t >= S(0) && got->t <= S(1)));

    if (rounds && (abs(d) <= d_error || abs(gap) <= gap_error)) continue;
    if (gap <= 0) {
      ++overlaps;
      REQUIRE(got.has_value());
      REQUIRE(got->t == S(0));
      REQUIRE(got->centre == ball.centre);
      continue;
    }
    if (rounds && abs(gap - closing) <= gap_error + rate_error) continue;
    ++decided;
    REQUIRE(got.has_value() == (gap <= closing));
    if (!got) continue;
    ++hits;
    const Rational right = gap / closing;
    // t = N / D, N off by gap_error and D by rate_error, and the quotient's own u.
    const Rational tolerance =
        (gap_error + right * rate_error) / (closing - rate_error) + 2 * u<S>() * right + eta<S>();
    REQUIRE(oracle::exact(oracle::error(double(got->t), right)) <= tolerance);
    const Vector centre = e.centre + way * right;
    const Rational s = d > 0 || (d == 0 && rate <= 0) ? 1 : -1;
    for (int k = 0; k < 3; ++k) {
      // A product and a sum round the centre; the radius times the normal and a difference round
      // the contact point.
      const Rational moved = tolerance * abs(way(k)) +
                             2 * u<S>() * (abs(e.centre(k)) + 2 * abs(way(k))) + 2 * eta<S>();
      REQUIRE(oracle::exact(oracle::error(double(got->centre(k)), centre(k))) <= moved);
      const Rational point = centre(k) - s * e.radius * stored.normal(k);
      REQUIRE(oracle::exact(oracle::error(double(got->point(k)), point)) <=
              moved * 2 + 3 * u<S>() * (abs(centre(k)) + e.radius) + 2 * eta<S>());
      REQUIRE(oracle::exact(got->normal(k)) == s * stored.normal(k));
    }
  }
  CHECK(decided > 1500);
  CHECK(hits > 300);
  CHECK(overlaps > 300);
}

TEST_CASE("a moving sphere touches at the time that the unrounded plane gives") {
  // The constructed geometry, not the stored plane: a normal of whole numbers, |N| in a quadratic
  // field.
  Random random(113);
  int hits = 0;
  for (int i = 0; i < 6000; ++i) {
    const Vector3<double> normal{double(random.integer(-5, 5)), double(random.integer(-5, 5)),
                                 double(random.integer(-5, 5))};
    if (normal == Vector3<double>::Zero()) continue;
    const Vector3<double> through{double(random.integer(-5, 5)), double(random.integer(-5, 5)),
                                  double(random.integer(-5, 5))};
    const Sphere<double> ball{{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)},
                              random.uniform(0, 3)};
    const Vector3<double> way{random.uniform(-20, 20), random.uniform(-20, 20),
                              random.uniform(-20, 20)};
    const ExactPlane exact_plane =
        oracle::plane_facing(oracle::exact(normal), oracle::exact(through));
    const auto right = oracle::first_touch(oracle::exact(ball), oracle::exact(way), exact_plane);
    const auto got = contact::moving_sphere_plane(
        ball, way, contact::plane_from_normal_and_point(normal, through));
    const double closing = std::abs(oracle::nearest(
        oracle::divided_by_root(oracle::dot(exact_plane.normal, oracle::exact(way)),
                                oracle::dot(exact_plane.normal, exact_plane.normal))));
    // The normal is off by 4 u an entry, the offset by 8 u |through| ≤ 70 u, the centre is within
    // 16, the path within 35 of 0: gap and closing are off by less than 300 u together, t by twice
    // that over the closing distance.
    const Rational tolerance =
        600 * u<double>() / oracle::exact(std::max(closing, 1e-6)) + 4 * u<double>();
    if (!right || !got) {
      if (right.has_value() == got.has_value()) continue;
      // They may differ only if the contact is at the very end or at the very start.
      const double t = right ? oracle::nearest(*right) : double(got->t);
      REQUIRE((t < 1e-9 || t > 1 - 1e-9));
      continue;
    }
    ++hits;
    REQUIRE(oracle::exact(oracle::error(got->t, *right)) <= tolerance);
  }
  CHECK(hits > 1500);
}

TEST_CASE(
    "a moving sphere: at rest, along, away, just short, just there, overlapping, on the plane") {
  const auto floor = contact::plane_from_normal_and_point<double>({0, 0, 1}, {0, 0, 0});
  const Sphere<double> ball{{0, 0, 3}, 1};
  CHECK_FALSE(contact::moving_sphere_plane(ball, {0, 0, 0}, floor).has_value());
  CHECK_FALSE(contact::moving_sphere_plane(ball, {7, 0, 0}, floor).has_value());
  CHECK_FALSE(contact::moving_sphere_plane(ball, {0, 0, 9}, floor).has_value());
  CHECK_FALSE(
      contact::moving_sphere_plane(ball, {0, 0, -std::nextafter(2.0, 0.0)}, floor).has_value());
  const auto there = contact::moving_sphere_plane(ball, {0, 0, -2}, floor);
  REQUIRE(there.has_value());
  CHECK(there->t == 1.0);
  CHECK(there->point == Vector3<double>(0, 0, 0));
  CHECK(there->normal == Vector3<double>(0, 0, 1));
  const auto below = contact::moving_sphere_plane<double>({{0, 0, -3}, 1}, {1, 0, 4}, floor);
  REQUIRE(below.has_value());
  CHECK(below->t == 0.5);
  CHECK(below->centre == Vector3<double>(0.5, 0, -1));
  CHECK(below->point == Vector3<double>(0.5, 0, 0));
  CHECK(below->normal == Vector3<double>(0, 0, -1));
  const auto inside =
      contact::moving_sphere_plane<double>({{4, 0, -0.5}, 1}, {0, 0, -9}, floor);  // moving out
  REQUIRE(inside.has_value());
  CHECK(inside->t == 0.0);
  CHECK(inside->point == Vector3<double>(4, 0, 0));
  CHECK(inside->normal == Vector3<double>(0, 0, -1));
  const auto centred = contact::moving_sphere_plane<double>({{0, 0, 0}, 1}, {0, 0, 5}, floor);
  REQUIRE(centred.has_value());
  CHECK(centred->normal == Vector3<double>(0, 0, -1));  // opposed to the motion
  const auto particle = contact::moving_sphere_plane<double>({{0, 0, 1}, 0}, {0, 0, -4}, floor);
  CHECK(particle->t == 0.25);
}
