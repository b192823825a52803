// A moving sphere against a plane: the decision and the time are those of fractions, from both
// sides.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/offset_plane.hpp>
#include <limits>
#include <optional>

#include "moving_bodies.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

namespace offset_plane_test {
namespace {

using contact::Plane;
using contact::Sphere;
using contact::sphere_plane_impact;
using contact::Vector3;
using generators::Random;
using generators::tried;
using oracle::Rational;
using V = Vector3<double>;

template <class S>
struct Question {
  Sphere<S> sphere;
  Vector3<S> displacement;
  Plane<S> plane;
};

/// On integers; of any direction; and moved to within some ulps of the touch at the end of the
/// step.
template <class S>
Question<S> question(Random& random, int family) {
  Question<S> q;
  const V centre =
      family == 0 ? moving_bodies::on_integers(random, 3) : V(moving_bodies::in_cube(random, 3));
  const V way =
      family == 0 ? moving_bodies::on_integers(random, 6) : V(moving_bodies::in_cube(random, 6));
  V normal = moving_bodies::in_cube(random, 1) + V(0, 0, 1e-3);
  if (family == 0) {
    normal = V::Zero();
    normal(random.integer(0, 2)) = random.chance(0.5) ? 1 : -1;
  }
  const double radius = family == 0 ? random.integer(0, 2) : random.uniform(0, 1);
  const double offset = family == 0 ? random.integer(-2, 2) : random.uniform(-2, 2);
  q.sphere = {centre.cast<S>(), static_cast<S>(radius)};
  q.displacement = way.cast<S>();
  q.plane = {contact::normalised(Vector3<S>(normal.cast<S>())), static_cast<S>(offset)};
  if (family == 2) {
    const S end = q.plane.normal.dot(Vector3<S>(q.sphere.centre + q.displacement));
    S k = random.chance(0.5) ? end + q.sphere.radius : end - q.sphere.radius;
    for (int i = random.integer(-2, 2); i != 0; i += i > 0 ? -1 : 1)
      k = std::nextafter(k, i > 0 ? S(100) : S(-100));
    q.plane.offset = k;
  }
  return q;
}

/// The right time, as a fraction; nothing if there is no touch.
template <class S>
std::optional<Rational> right_time(const Question<S>& q) {
  const oracle::Vector n = oracle::exact(q.plane.normal);
  Rational gap = n.dot(oracle::exact(q.sphere.centre)) - oracle::exact(q.plane.offset);
  Rational change = n.dot(oracle::exact(q.displacement));
  if (gap < 0 || (gap == 0 && change > 0)) {
    gap = -gap;
    change = -change;
  }
  gap -= oracle::exact(q.sphere.radius);
  if (gap <= 0) return Rational(0);
  if (change >= 0 || gap > -change) return std::nullopt;
  return Rational(gap / -change);
}

TEMPLATE_TEST_CASE("a sphere and a plane: the touch is that of fractions, t to 32 u", "", float,
                   double) {
  using S = TestType;
  Random random(21);
  int touches = 0, passes = 0, starts = 0;
  for (int i = 0; i < tried(10000); ++i) {
    const Question<S> q = question<S>(random, i % 3);
    const auto right = right_time(q);
    const auto got = sphere_plane_impact(q.sphere, q.displacement, q.plane);
    INFO("sphere " << i);
    REQUIRE(got.has_value() == right.has_value());
    if (!right) {
      ++passes;
      continue;
    }
    ++(*right == 0 ? starts : touches);
    const Rational off = abs(Rational(oracle::exact(got->t) - *right));
    REQUIRE(off <= *right * 32 * rounding::u<S>());
    REQUIRE_FALSE(std::signbit(got->t));
    // The normal leads to the side of the centre, and the point is on the plane.
    const oracle::Vector n = oracle::exact(q.plane.normal);
    const Rational side = n.dot(oracle::exact(q.sphere.centre)) - oracle::exact(q.plane.offset);
    if (side != 0) REQUIRE((got->normal == q.plane.normal) == (side > 0));
    const Rational height = n.dot(oracle::exact(got->point)) - oracle::exact(q.plane.offset);
    REQUIRE(abs(height) <= 64 * 16 * rounding::u<S>());
  }
  CHECK(touches > tried(1000));
  CHECK(passes > tried(1000));
  CHECK(starts > tried(300));
}

const Plane<double> floor_plane{V(0, 0, 1), 0};

TEST_CASE("a sphere touches the plane from behind with the opposite normal") {
  const auto hit = sphere_plane_impact<double>({V(1, 2, -3), 1}, V(0, 0, 4), floor_plane);
  REQUIRE(hit.has_value());
  CHECK(hit->t == 0.5);
  CHECK(hit->normal == V(0, 0, -1));
  CHECK(hit->centre == V(1, 2, -1));
  CHECK(hit->point == V(1, 2, 0));
}

TEST_CASE("a sphere on the plane touches at once: at rest, moving along and moving away") {
  for (const V& way : {V(0, 0, 0), V(5, 0, 0), V(0, 0, 7), V(0, 0, -7)}) {
    const auto hit = sphere_plane_impact<double>({V(0, 0, 1), 1}, way, floor_plane);
    REQUIRE(hit.has_value());
    CHECK(hit->t == 0);
    CHECK(hit->point == V(0, 0, 0));
  }
}

TEST_CASE("a sphere clear of the plane at rest, along it or away from it does not touch") {
  for (const V& way : {V(0, 0, 0), V(5, 0, 0), V(0, 0, 7)})
    CHECK_FALSE(sphere_plane_impact<double>({V(0, 0, 2), 1}, way, floor_plane).has_value());
}

TEST_CASE("a centre on the plane has the normal against its motion") {
  CHECK(sphere_plane_impact<double>({V(0, 0, 0), 1}, V(0, 0, -1), floor_plane)->normal ==
        V(0, 0, 1));
  CHECK(sphere_plane_impact<double>({V(0, 0, 0), 1}, V(0, 0, 1), floor_plane)->normal ==
        V(0, 0, -1));
}

TEST_CASE("a sphere that arrives at the end of the step touches, and one ulp short does not") {
  const double far = std::nextafter(3, 4);
  CHECK(sphere_plane_impact<double>({V(0, 0, 3), 1}, V(0, 0, -2), floor_plane)->t == 1);
  CHECK_FALSE(sphere_plane_impact<double>({V(0, 0, far), 1}, V(0, 0, -2), floor_plane));
}

TEST_CASE("the touch with a plane has no negative zero") {
  const auto hit = sphere_plane_impact<double>({V(-0.0, -0.0, -2), 1}, V(-0.0, 0, 2), floor_plane);
  REQUIRE(hit.has_value());
  for (int k = 0; k < 3; ++k) {
    CHECK_FALSE((hit->point(k) == 0 && std::signbit(hit->point(k))));
    CHECK_FALSE((hit->centre(k) == 0 && std::signbit(hit->centre(k))));
    CHECK_FALSE((hit->normal(k) == 0 && std::signbit(hit->normal(k))));
  }
}

TEST_CASE("a sphere of any scale touches the plane at the same fraction") {
  for (const double scale : {0x1p-1040, 0x1p-500, 0x1p500, 0x1p1000}) {
    const Plane<double> plane{V(0, 0, 1), scale};
    const auto hit =
        sphere_plane_impact<double>({V(0, 0, 4 * scale), scale}, V(0, 0, -4 * scale), plane);
    REQUIRE(hit.has_value());
    CHECK(hit->t == 0.5);
  }
}

TEST_CASE("the distance from a plane is that of the stored numbers, whatever the normal's length") {
  // |n|² = 1 + 4.4e-17: n · c is above 1, the distance from the plane is not.
  const Sphere<double> sphere{V(1.5774467022710263, 0.0669149732967303, 0), 1};
  const Plane<double> plane{V(0.6, 0.8, 0), 0};
  const auto product = [](double x, double y) { return Rational(x) * Rational(y); };
  CHECK(product(0.6, sphere.centre.x()) + product(0.8, sphere.centre.y()) > Rational(1));
  CHECK_FALSE(sphere_plane_impact<double>(sphere, V(0, 0, 0), plane).has_value());
}

TEST_CASE("a centre that leaves the numbers is infinite, at the right time") {
  const auto hit =
      sphere_plane_impact<double>({V(1.7e308, 0, 1), 0.5}, V(1.7e308, 0, -2), floor_plane);
  REQUIRE(hit.has_value());
  CHECK(hit->t == 0.25);
  CHECK(hit->centre.x() == std::numeric_limits<double>::infinity());
  CHECK(hit->centre.z() == 0.5);
}

TEST_CASE("a number that is not finite touches no plane") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(sphere_plane_impact<double>({V(nan, 0, 0), 1}, V(0, 0, 0), floor_plane));
  CHECK_FALSE(sphere_plane_impact<double>({V(0, 0, 0), nan}, V(0, 0, 0), floor_plane));
  CHECK_FALSE(sphere_plane_impact<double>({V(0, 0, 0), 1}, V(0, 0, nan), floor_plane));
  CHECK_FALSE(sphere_plane_impact<double>({V(0, 0, 0), 1}, V(0, 0, 0), {V(0, 0, 1), nan}));
}

}  // namespace
}  // namespace offset_plane_test
