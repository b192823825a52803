// Every reference function of chapter 1 against the oracle. u is the unit roundoff of the type, η
// its smallest number. A decision has no tolerance: either the inputs decide it beyond the
// documented error bound, or the arithmetic is exact.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/moving_sphere_plane.hpp>
#include <contact/plane.hpp>
#include <contact/segment_plane.hpp>
#include <contact/sphere_plane.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/generators.hpp"
#include "support/oracle_planes.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::Plane;
using contact::Segment;
using contact::Side;
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
using oracle::Surd;
using oracle::Vector;
using rounding::eta;
using rounding::gamma;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

/// Σ |aᵢ bᵢ|.
Rational absolute_dot(const Vector& a, const Vector& b) {
  return abs(a.x() * b.x()) + abs(a.y() * b.y()) + abs(a.z() * b.z());
}

/// The families whose numbers fit a float (huge and tiny do not: they would be ∞ and 0).
template <class S>
bool fits(Family family) {
  return sizeof(S) == sizeof(double) || (family != Family::huge && family != Family::tiny);
}

/// A random plane of type S that meets the neighbourhood of a triangle: through its corners, or
/// facing along its normal.
template <class S>
std::optional<Plane<S>> plane_of(const Triangle<S>& t) {
  const ExactPlane plane =
      oracle::plane_through(oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c));
  if (!plane.exists()) return std::nullopt;
  return contact::plane_from_points(t.a, t.b, t.c);
}

/// What |n·x − k| can be off by in type S: four roundings in a row, three products that may
/// underflow.
template <class S>
Rational distance_bound(const Plane<S>& plane, const Vector3<S>& x) {
  return gamma<S>(4) * (absolute_dot(oracle::exact(plane.normal), oracle::exact(x)) +
                        abs(oracle::exact(plane.offset))) +
         3 * eta<S>() / 2;
}

}  // namespace

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
    // For the stored normal, only the dot product of the offset is rounded: three roundings in a
    // row.
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
    // Near the largest number the offset may or may not overflow; that is tested by itself below.
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
    if (i % 3 == 1) t.c = t.a + random.uniform(-2, 2) * (t.b - t.a);   // collinear but for rounding
    if (i % 3 == 2) t.b = generators::detail::nudged(random, t.a, 3);  // an edge a few ulps long
    check(generators::rounded<S>(t));
  }
  if constexpr (sizeof(S) == sizeof(double)) {
    for (int i = 0; i < 1500;
         ++i) {  // any exponents at all, and one corner near the largest number
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
  CHECK(within > 1000);  // the generators do reach the inputs that no plain method decides
}

TEST_CASE("a distance from a point of the plane keeps its digits far from the origin") {
  Random random(106);
  for (int i = 0; i < 4000; ++i) {
    const auto t = generators::triangle(random, Family::far);
    const auto plane = plane_of(t);
    if (!plane) continue;
    const Vector3<double> x = generators::point(random, Family::far, t);
    const Vector to_x = oracle::exact(x) - oracle::exact(t.a);
    const Rational right = oracle::dot(oracle::exact(plane->normal), to_x);
    // A rounded difference, a product, two sums: four roundings in a row, of x − a and not of x.
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

TEMPLATE_TEST_CASE("a segment crosses where the oracle says", "", float, double) {
  using S = TestType;
  Random random(109);
  int decided = 0;
  int hits = 0;
  for (int i = 0; i < 12000; ++i) {
    const Family family = all_families[static_cast<std::size_t>(i) % all_families.size()];
    if (!fits<S>(family)) continue;
    const auto t = generators::triangle(random, family);
    // On the grid the plane lies along an axis: every number on the way is a small whole number, so
    // nothing is rounded and every touch must be seen.
    const bool rounds = family != Family::grid;
    const auto made = rounds ? plane_of(generators::rounded<S>(t)) : [&] {
      const auto p = generators::plane(random, family);
      return std::optional(Plane<S>{generators::rounded<S>(p.normal), static_cast<S>(p.offset)});
    }();
    if (!made) continue;
    const Plane<S> plane = *made;
    const Segment<S> s = generators::rounded<S>(generators::segment(random, family, t));
    const ExactPlane stored = oracle::plane_as_stored(plane);
    const auto e = oracle::exact(s);
    const Rational d0 = oracle::value(stored, e.start);
    const Rational d1 = oracle::value(stored, e.end);
    const Rational e0 = rounds ? distance_bound(plane, s.start) : Rational(0);
    const Rational e1 = rounds ? distance_bound(plane, s.end) : Rational(0);
    const auto got = contact::segment_plane(s, plane);
    if (got) {  // holds for every hit, decided or not
      REQUIRE((got->t >= S(0) && got->t <= S(1)));
      for (int k = 0; k < 3; ++k) {
        REQUIRE((got->point(k) >= std::min(s.start(k), s.end(k)) &&
                 got->point(k) <= std::max(s.start(k), s.end(k))));
      }
    }
    if (rounds && (abs(d0) <= e0 || abs(d1) <= e1)) continue;
    ++decided;
    const auto right = oracle::crossing(e, stored);
    REQUIRE(got.has_value() == right.has_value());
    if (!got) continue;
    ++hits;
    // t = N / D with N = d0 off by e0 and D = d0 − d1 off by e0 + e1; the difference and the
    // quotient add 2 u each way.
    const Rational size = abs(d0 - d1);
    const Rational tolerance =
        (e0 + right->t * (e0 + e1)) / (size - e0 - e1) + 3 * u<S>() * right->t + eta<S>();
    REQUIRE(oracle::exact(oracle::error(double(got->t), right->t)) <= tolerance);
    // The two weights come from the same rounded distances, so together they are 1 but for 2 u
    // each; products and sum: 2 u.
    for (int k = 0; k < 3; ++k) {
      const Rational a = e.start(k);
      const Rational b = e.end(k);
      REQUIRE(oracle::exact(oracle::error(double(got->point(k)), right->point(k))) <=
              tolerance * abs(b - a) + 5 * u<S>() * (abs(a) + abs(b)) + 3 * eta<S>());
    }
  }
  CHECK(decided > 3500);
  CHECK(hits > 1500);
}

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

    // From the raw points, exactly: against a comparison of numbers with a root, which squares
    // nothing by hand.
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

TEST_CASE("the exact sphere test is right for any bit patterns, and refuses what is no plane") {
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
        family != Family::grid;  // as for segments: on the grid nothing rounds but the quotient
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

    // As stored: the plane's normal taken for a unit vector, as its invariant says.
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
    // 16, the way within 35 of 0: gap and closing are off by less than 300 u together, t by twice
    // that over the closing distance.
    const Rational tolerance =
        600 * u<double>() / oracle::exact(std::max(closing, 1e-6)) + 4 * u<double>();
    if (!right || !got) {
      if (right.has_value() == got.has_value()) continue;
      // They may differ only if the touch is at the very end or at the very start.
      const double t = right ? oracle::nearest(*right) : double(got->t);
      REQUIRE((t < 1e-9 || t > 1 - 1e-9));
      continue;
    }
    ++hits;
    REQUIRE(oracle::exact(oracle::error(got->t, *right)) <= tolerance);
  }
  CHECK(hits > 1500);
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

TEST_CASE("a distance that overflows only on the way is still right") {
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

TEST_CASE("touching counts, and a segment in the plane has no single point") {
  const auto floor = contact::plane_from_normal_and_point<double>({0, 0, 1}, {0, 0, 0});
  CHECK(contact::segment_plane<double>({{0, 0, 0}, {0, 0, 1}}, floor)->t == 0.0);
  CHECK(contact::segment_plane<double>({{0, 0, 1}, {0, 0, 0}}, floor)->t == 1.0);
  CHECK_FALSE(contact::segment_plane<double>({{0, 0, 0}, {5, 0, 0}}, floor).has_value());
  CHECK_FALSE(contact::segment_plane<double>({{0, 0, 0}, {0, 0, 0}}, floor).has_value());
  CHECK_FALSE(contact::segment_plane<double>({{0, 0, 2}, {5, 0, 2}}, floor).has_value());
  CHECK(contact::sphere_meets_plane<double>({{0, 0, 2}, 2}, floor));
  CHECK(contact::sphere_meets_plane<double>({{0, 0, -2}, 2}, floor));
  CHECK_FALSE(contact::sphere_meets_plane<double>({{0, 0, 2}, std::nextafter(2.0, 0.0)}, floor));
  CHECK(contact::sphere_meets_plane<double>({{0, 0, 0}, 0}, floor));
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
  CHECK(centred->normal == Vector3<double>(0, 0, -1));  // against the motion
  const auto particle = contact::moving_sphere_plane<double>({{0, 0, 1}, 0}, {0, 0, -4}, floor);
  CHECK(particle->t == 0.25);
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
