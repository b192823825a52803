// Whether a point is in a body: against fractions, for points on surfaces and one step beside them.
#include <09_separating_planes/pair_families.hpp>
#include <09_separating_planes/pair_truth.hpp>
#include <09_separating_planes/random_poses.hpp>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/body_contains.hpp>
#include <limits>
#include <map>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <variant>

namespace body_contains_test {
namespace {

using contact::contains;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using pair_bodies::Kind;
using Point = contact::Vector3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Body>
bool contains_in_fractions(const Body& body, const Point& point) {
  const pair_truth::Core at = pair_truth::core_of(contact::Sphere<double>{point, 0});
  return pair_truth::truth(pair_truth::core_of(body), at).sign <= 0;
}
bool contains_in_fractions(const contact::Cylinder<double>& body, const Point& point) {
  const Vector core = oracle::exact(body.core.end) - oracle::exact(body.core.start);
  const Vector w = oracle::exact(point) - oracle::exact(body.core.start), moment = w.cross(core);
  const Rational r = oracle::exact(body.radius), along = w.dot(core), whole = core.dot(core);
  return along >= 0 && along <= whole && moment.dot(moment) <= r * r * whole;
}
bool contains_in_fractions(const contact::Ellipsoid<double>& body, const Point& point) {
  const Vector w = oracle::exact(point) - oracle::exact(body.centre);
  std::array<Vector, 3> image;
  for (int i = 0; i < 3; ++i) {
    image[static_cast<std::size_t>(i)] =
        oracle::exact(Point(body.axes.col(i))) * oracle::exact(body.half_lengths(i));
  }
  const Rational volume = image[0].dot(Vector(image[1].cross(image[2])));
  Rational squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational x = w.dot(Vector(image[(i + 1) % 3].cross(image[(i + 2) % 3]))) / volume;
    squared += x * x;
  }
  return squared <= 1;
}

double nudged(Random& random, double x) {
  const int steps = random.integer(-2, 2);
  for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, steps > 0 ? infinity : -infinity);
  return x;
}

/// A point of the surface of a body, up to two steps beside it in each coordinate; or any point.
Point point_near(Random& random, const pair_bodies::Body& body) {
  const Point n = random_poses::direction(random);
  const double share = random.uniform();
  Point at = std::visit(
      [&](const auto& b) {
        const Point far = contact::support(b, n) + n * contact::radius_of(b);
        if (random.chance(0.3)) {
          const Point other = contact::support(b, random_poses::direction(random));
          return Point(far * share + other * (1 - share));
        }
        return far;
      },
      body);
  for (int i = 0; i < 3; ++i) at(i) = nudged(random, at(i));
  return at;
}

void check_kind(std::uint64_t seed, Kind kind, int count, int low, int high) {
  Random random(seed);
  std::map<bool, int> seen;
  const int all = generators::tried(count);
  for (int i = 0; i < all; ++i) {
    const auto frame = random.chance(0.3) ? pair_families::detail::whole_frame(random)
                                          : pair_families::detail::any_frame(random);
    const auto drawn = pair_families::detail::body(random, kind, frame);
    const int power = random.integer(low, high);
    const Point point = point_near(random, drawn) * std::ldexp(1.0, power);
    std::visit(
        [&](const auto& body) {
          const bool inside = contains(body, point);
          ++seen[inside];
          REQUIRE(inside == contains_in_fractions(body, point));
        },
        pair_bodies::scaled(drawn, power));
  }
  CHECK(seen[true] > all / 100);
  CHECK(seen[false] > all / 10);
}

TEST_CASE("a point is in a body with a round surface exactly if fractions say so") {
  std::uint64_t seed = 1;
  for (const Kind kind : {Kind::sphere, Kind::capsule, Kind::cylinder, Kind::ellipsoid}) {
    check_kind(seed++, kind, 1500, -3, 3);
    check_kind(seed++, kind, 300, -498, 498);
  }
}

TEST_CASE("a point is in a body with vertices exactly if fractions say so") {
  std::uint64_t seed = 21;
  for (const Kind kind : {Kind::lozenge, Kind::box, Kind::hull}) {
    check_kind(seed++, kind, 400, -3, 3);
    check_kind(seed++, kind, 100, -498, 498);
  }
}

TEST_CASE("a triangle contains its vertices and points of its plane, and none one step above") {
  Random random(31);
  for (int i = 0; i < generators::tried(300); ++i) {
    const auto whole = [&random] {
      const int x = random.integer(-9, 9), y = random.integer(-9, 9);
      return Point(x, y, random.integer(-9, 9));
    };
    const Point a = whole(), b = whole(), c = whole();
    const contact::Triangle<double> triangle{a, b, c};
    const double x = random.integer(0, 8) / 8.0, y = random.integer(0, 8) / 8.0;
    const Point point = a + (b - a) * x + (c - a) * y;
    REQUIRE(contains(triangle, point) == contains_in_fractions(triangle, point));
    REQUIRE(contains(triangle, a));
    REQUIRE(contains(triangle, c));
    const Point above(point.x(), point.y(), std::nextafter(point.z(), infinity));
    REQUIRE(contains(triangle, above) == contains_in_fractions(triangle, above));
  }
}

TEST_CASE("a hull contains its vertices and the means of any two of them") {
  Random random(41);
  for (int i = 0; i < generators::tried(60); ++i) {
    const auto frame = pair_families::detail::whole_frame(random);
    const auto body = std::get<contact::ConvexHull<double>>(
        pair_families::detail::body(random, Kind::hull, frame));
    for (const Point& v : body.vertices) {
      REQUIRE(contains(body, v));
      const Point mean = (v + body.vertices.front()) / 2;
      REQUIRE(contains(body, mean) == contains_in_fractions(body, mean));
    }
  }
}

TEST_CASE("a hull of points, of a segment and of a triangle contains only these") {
  const contact::ConvexHull<double> point{{{1, 2, 3}}};
  CHECK(contains(point, Point(1, 2, 3)));
  CHECK_FALSE(contains(point, Point(1, 2, std::nextafter(3.0, 4.0))));
  const contact::ConvexHull<double> segment{{{0, 0, 0}, {4, 2, 8}, {2, 1, 4}}};
  CHECK(contains(segment, Point(1, 0.5, 2)));
  CHECK_FALSE(contains(segment, Point(1, 0.5, std::nextafter(2.0, 3.0))));
  CHECK_FALSE(contains(segment, Point(-1, -0.5, -2)));
  const contact::ConvexHull<double> round{{{0, 0, 0}, {4, 0, 0}}, 1};
  CHECK(contains(round, Point(2, 1, 0)));
  CHECK(contains(round, Point(5, 0, 0)));
  CHECK_FALSE(contains(round, Point(std::nextafter(5.0, 6.0), 0, 0)));
}

TEST_CASE("a degenerate body contains its core or nothing, as its comment says") {
  const Point at{1, 2, 3};
  const contact::Capsule<double> ball{{at, at}, 0};
  CHECK(contains(ball, at));
  CHECK_FALSE(contains(ball, Point(1, 2, 4)));
  CHECK_FALSE(contains(contact::Cylinder<double>{{at, at}, 5}, at));
  CHECK(contains(contact::Cylinder<double>{{at, Point(1, 2, 5)}, 0}, Point(1, 2, 4)));
  contact::Ellipsoid<double> flat{at, contact::Matrix3<double>::Identity(), Point(1, 0, 1)};
  CHECK_FALSE(contains(flat, at));
  const contact::Lozenge<double> segment{at, Point(2, 0, 0), Point(-1, 0, 0), 0};
  CHECK(contains(segment, Point(0, 2, 3)));
  CHECK_FALSE(contains(segment, Point(-0.5, 2, 3)));
}

TEST_CASE("nothing contains a point that is not finite, and nothing is in such a body") {
  for (const double bad : {nan, infinity, -infinity}) {
    const Point nowhere{0, bad, 0}, origin = Point::Zero(), one{1, 1, 1};
    const auto check = [&](const auto& body, const auto& broken) {
      CHECK(contains(body, origin));
      CHECK_FALSE(contains(body, nowhere));
      CHECK_FALSE(contains(broken, origin));
    };
    check(contact::Capsule<double>{{origin, one}, 1}, contact::Capsule<double>{{origin, one}, bad});
    check(contact::Cylinder<double>{{origin, one}, 1},
          contact::Cylinder<double>{{nowhere, one}, 1});
    contact::Ellipsoid<double> ball{origin, contact::Matrix3<double>::Identity(), one};
    auto broken = ball;
    broken.axes(1, 1) = bad;
    check(ball, broken);
    check(contact::Triangle<double>{origin, one, one},
          contact::Triangle<double>{origin, nowhere, one});
    check(contact::Lozenge<double>{origin, one, one, 1},
          contact::Lozenge<double>{origin, one, nowhere, 1});
    check(contact::ConvexHull<double>{{origin, one}, 1},
          contact::ConvexHull<double>{{origin, nowhere}, 1});
    check(contact::HalfSpace<double>{{one, 1}}, contact::HalfSpace<double>{{one, bad}});
  }
  CHECK_FALSE(contains(contact::ConvexHull<double>{}, Point(0, 0, 0)));
  CHECK_FALSE(
      contains(contact::Capsule<double>{{Point::Zero(), Point::Zero()}, -1}, Point(0, 0, 0)));
}

TEST_CASE("a half-space contains its boundary, exactly") {
  const contact::HalfSpace<double> half{{{0.1, 0.2, 0.3}, 0.1 * 0.5}};
  CHECK(contains(half, Point(0.5, 0, 0)) ==
        (oracle::exact(0.1) * oracle::exact(0.5) <= oracle::exact(0.1 * 0.5)));
  const contact::HalfSpace<double> floor{{{0, 0, 1}, 2}};
  CHECK(contains(floor, Point(5, 5, 2)));
  CHECK_FALSE(contains(floor, Point(5, 5, std::nextafter(2.0, 3.0))));
}

TEST_CASE("floats are decided for their stored numbers") {
  const contact::Capsule<float> capsule{{{0, 0, 0}, {1, 0, 0}}, 0.1F};
  CHECK(contains(capsule, contact::Vector3<float>(0.5F, 0.1F, 0)));
  CHECK_FALSE(contains(capsule, contact::Vector3<float>(0.5F, std::nextafter(0.1F, 1.0F), 0)));
  const contact::Triangle<float> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(contains(triangle, contact::Vector3<float>(0.25F, 0.75F, 0)));
  CHECK_FALSE(contains(triangle, contact::Vector3<float>(0.25F, std::nextafter(0.75F, 1.0F), 0)));
}

}  // namespace
}  // namespace body_contains_test
