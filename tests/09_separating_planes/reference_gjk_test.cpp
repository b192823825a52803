// GJK: distances against exact ones, closest points, starts, and that it ends for all numbers.
#include <09_separating_planes/pair_families.hpp>
#include <09_separating_planes/pair_truth.hpp>
#include <09_separating_planes/random_poses.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/body_contains.hpp>
#include <contact/gjk.hpp>
#include <limits>
#include <string>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <type_traits>
#include <variant>

namespace gjk_test {
namespace {

using contact::gjk;
using contact::GjkResult;
using contact::GjkStart;
using contact::PolytopeCore;
using generators::Random;
using pair_bodies::Body;
using pair_bodies::Kind;
using pair_families::Family;
using Point = contact::Vector3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double u = 0x1p-53;

/// The largest number of either body.
template <class A, class B>
double size_of(const A& a, const B& b) {
  return std::max(contact::gjk_detail::largest_number(a), contact::gjk_detail::largest_number(b));
}

/// The exact distance of two cores.
template <class A, class B>
oracle::Surd core_distance(const A& a, const B& b) {
  auto core_a = pair_truth::core_of(a), core_b = pair_truth::core_of(b);
  core_a.radius = core_b.radius = 0;
  const auto truth = pair_truth::truth(core_a, core_b);
  return truth.sign > 0 ? truth.distance : oracle::Surd{};
}

/// Each pair of bodies with vertices, of every family.
template <class Check>
void for_polytopes(std::uint64_t seed, int count, const Check& check) {
  Random random(seed);
  for (const Family family : pair_families::all) {
    for (const Kind kind_a : pair_bodies::polytope_kinds) {
      for (const Kind kind_b : pair_bodies::polytope_kinds) {
        for (int i = 0; i < generators::tried(count); ++i) {
          INFO(pair_families::name(family) << ": " << pair_bodies::name(kind_a) << ", "
                                           << pair_bodies::name(kind_b) << ", case " << i);
          const auto drawn = pair_families::pair(random, kind_a, kind_b, family);
          std::visit(
              [&](const auto& a, const auto& b) {
                if constexpr (PolytopeCore<std::decay_t<decltype(a)>> &&
                              PolytopeCore<std::decay_t<decltype(b)>>) {
                  check(random, a, b);
                }
              },
              drawn.a, drawn.b);
        }
      }
    }
  }
}

TEST_CASE("the distance of two cores is off by a few u of their coordinates, in every family") {
  int converged = 0, all = 0;
  for_polytopes(1, 8, [&](Random&, const auto& a, const auto& b) {
    const GjkResult<double> found = gjk(a, b);
    const oracle::Surd exact = core_distance(a, b);
    const double room = 64 * u * size_of(a, b);
    REQUIRE(oracle::error(found.distance, exact) <= room);
    REQUIRE(oracle::sign(exact +
                         oracle::Rational(oracle::exact(room) - oracle::exact(found.lower))) >= 0);
    ++all;
    converged += found.converged ? 1 : 0;
  });
  CHECK(converged * 100 >= all * 99);
}

TEST_CASE("the closest points are points of the cores and differ by the distance") {
  for_polytopes(2, 4, [](Random&, const auto& a, const auto& b) {
    const GjkResult<double> found = gjk(a, b);
    const double room = 64 * u * size_of(a, b);
    REQUIRE((found.on_a - found.on_b - found.between).cwiseAbs().maxCoeff() <= room);
    REQUIRE(std::abs(found.between.stableNorm() - found.distance) <= 4 * u * found.distance);
    REQUIRE(gjk(contact::Sphere<double>{found.on_a, 0}, a).distance <= room);
    REQUIRE(gjk(contact::Sphere<double>{found.on_b, 0}, b).distance <= room);
    double sum = 0;
    REQUIRE(found.count >= 1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
      REQUIRE(found.weights[i] > 0);
      sum += found.weights[i];
      const Point vertex = contact::vertex(a, found.simplex[i].a);
      REQUIRE((found.simplex[i].of_a - vertex).cwiseAbs().maxCoeff() <= room / 8);
    }
    REQUIRE(std::abs(sum - 1) <= 8 * u);
  });
}

TEST_CASE("no start changes the distance by more than rounding") {
  for_polytopes(3, 4, [](Random& random, const auto& a, const auto& b) {
    const GjkResult<double> found = gjk(a, b);
    const double room = 64 * u * size_of(a, b);
    GjkStart<double> start = start_from(found);
    REQUIRE(std::abs(gjk(a, b, start).distance - found.distance) <= room);
    // Of other bodies: any numbers, also of vertices that these do not have.
    start.count = random.integer(0, 4);
    for (std::size_t i = 0; i < 4; ++i) {
      start.a[i] = random.integer(-1, 9);
      start.b[i] = random.integer(-1, 9);
    }
    start.direction = random_poses::direction(random) * random.magnitude(-300, 300);
    REQUIRE(std::abs(gjk(a, b, start).distance - found.distance) <= room);
  });
}

TEST_CASE("a pair that did not move is solved from its simplex with one pair of supports") {
  Random random(4);
  for (int i = 0; i < generators::tried(500); ++i) {
    const auto drawn = pair_families::pair(random, Kind::box, Kind::hull, Family::random);
    const auto& a = std::get<contact::OrientedBox<double>>(drawn.a);
    const auto& b = std::get<contact::ConvexHull<double>>(drawn.b);
    const GjkResult<double> found = gjk(a, b);
    REQUIRE(gjk(a, b, start_from(found)).iterations <= 1);
  }
}

TEST_CASE("exchanged bodies have the same distance up to rounding") {
  for_polytopes(5, 4, [](Random&, const auto& a, const auto& b) {
    REQUIRE(std::abs(gjk(a, b).distance - gjk(b, a).distance) <= 64 * u * size_of(a, b));
  });
}

TEST_CASE("bodies a power of two larger have that power of two times the distance") {
  Random random(6);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto drawn = pair_families::pair(random, Kind::box, Kind::triangle, Family::random);
    const auto& a = std::get<contact::OrientedBox<double>>(drawn.a);
    const auto& b = std::get<contact::Triangle<double>>(drawn.b);
    const GjkResult<double> found = gjk(a, b);
    const int power = random.integer(-900, 1015);
    const GjkResult<double> scaled = gjk(contact::gjk_detail::times_power_of_two(a, power),
                                         contact::gjk_detail::times_power_of_two(b, power));
    REQUIRE(scaled.distance == std::ldexp(found.distance, power));
    REQUIRE(scaled.iterations == found.iterations);
  }
}

/// Two bodies that a plane perpendicular to n separates, with points of both at this distance.
template <class A, class B>
B moved_to(const A& a, const B& b, const Point& n, double distance) {
  const Point move = contact::support(a, n) + n * distance - contact::support(b, -n);
  return std::get<B>(pair_bodies::moved(Body(b), move));
}

TEST_CASE("the distance of smooth bodies is that to which they were moved apart") {
  Random random(7);
  int slow = 0, all = 0;
  for (const Kind kind_a : pair_bodies::all_kinds) {
    for (const Kind kind_b : {Kind::cylinder, Kind::ellipsoid}) {
      for (int i = 0; i < generators::tried(300); ++i) {
        INFO(pair_bodies::name(kind_a) << ", " << pair_bodies::name(kind_b) << ", case " << i);
        const Body drawn_a =
            pair_families::detail::body(random, kind_a, pair_families::detail::any_frame(random));
        const Body drawn_b =
            pair_families::detail::body(random, kind_b, pair_families::detail::any_frame(random));
        const Point n = random_poses::direction(random);
        const double distance = std::abs(random.magnitude(-30, 3));
        std::visit(
            [&](const auto& a, const auto& b) {
              const auto moved = moved_to(a, b, n, distance);
              const GjkResult<double> found = gjk(a, moved);
              const double size = size_of(a, moved);
              ++all;
              slow += found.converged ? 0 : 1;
              REQUIRE(found.iterations <= 255);
              REQUIRE(found.lower <= distance + 256 * u * size);
              REQUIRE(found.distance >= distance - 256 * u * size);
              if (found.converged) REQUIRE(found.distance <= distance + 1024 * u * size);
            },
            drawn_a, drawn_b);
      }
    }
  }
  CHECK(slow * 50 <= all);
}

TEST_CASE("with an accuracy GJK ends earlier, and is off by no more than that") {
  Random random(8);
  int saved = 0, all = 0;
  for (int i = 0; i < generators::tried(500); ++i) {
    const Body drawn_a = pair_families::detail::body(random, Kind::ellipsoid,
                                                     pair_families::detail::any_frame(random));
    const Body drawn_b = pair_families::detail::body(random, Kind::ellipsoid,
                                                     pair_families::detail::any_frame(random));
    const auto& a = std::get<contact::Ellipsoid<double>>(drawn_a);
    const auto b = moved_to(a, std::get<contact::Ellipsoid<double>>(drawn_b),
                            random_poses::direction(random), 0.5);
    GjkStart<double> start;
    start.accuracy = 1e-5;
    const GjkResult<double> coarse = gjk(a, b, start);
    REQUIRE(coarse.distance - coarse.lower <= 1e-5);
    REQUIRE(std::abs(coarse.distance - 0.5) <= 1e-5);
    all += gjk(a, b).iterations;
    saved += gjk(a, b).iterations - coarse.iterations;
  }
  CHECK(saved * 4 > all);
}

TEST_CASE("segments that nearly cross have a direction perpendicular to both") {
  Random random(9);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Point d = random_poses::direction(random), e = random_poses::direction(random);
    const Point across = d.cross(e);
    if (across.norm() < 0.2) continue;
    const Point n = across.normalized() * std::abs(random.magnitude(-46, -20));
    const Point middle = random_poses::any_point(random, 1);
    const double s = random.uniform(0.2, 1), t = random.uniform(0.2, 1);
    const contact::Capsule<double> a{{Point(middle + n - d * s), Point(middle + n + d)}, 1};
    const contact::Capsule<double> b{{Point(middle - e * t), Point(middle + e)}, 1};
    const GjkResult<double> found = gjk(a, b);
    if (found.distance < 256 * u) continue;
    REQUIRE(std::abs(found.between.dot(d)) <= 64 * u * found.distance);
    REQUIRE(std::abs(found.between.dot(e)) <= 64 * u * found.distance);
  }
}

template <class A, class B>
void check_ends(const A& a, const B& b) {
  const auto found = gjk(a, b);
  REQUIRE_FALSE(std::isnan(found.distance));
  REQUIRE_FALSE(std::isnan(found.lower));
  REQUIRE(found.distance >= 0);
  REQUIRE(found.iterations <= 255);
  if (found.count == 0) return;
  for (int i = 0; i < 3; ++i) {
    REQUIRE_FALSE(std::isnan(found.between(i)));
    REQUIRE_FALSE(std::isnan(found.on_a(i)));
    REQUIRE_FALSE(std::isnan(found.on_b(i)));
  }
}

TEST_CASE("GJK ends without NaN for numbers of any bit pattern") {
  Random random(10);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const auto any = [&random] { return generators::any_vector(random); };
    const auto finite = [&any] {
      for (;;) {
        const Point p = any();
        if (contact::all_finite(p)) return p;
      }
    };
    contact::OrientedBox<double> box{finite(), random_poses::turn(random), finite().cwiseAbs()};
    const Point p = finite(), q = finite(), r = finite(), s = finite();
    const contact::Ellipsoid<double> ellipsoid{box.centre, box.axes, box.half_lengths};
    const contact::Cylinder<double> cylinder{{p, q}, std::abs(s.x())};
    const contact::Triangle<double> triangle{q, r, s};
    const contact::ConvexHull<double> hull{{p, q, r, s}};
    const contact::Lozenge<double> lozenge{p, r, s, 1};
    check_ends(box, triangle);
    check_ends(hull, box);
    check_ends(lozenge, triangle);
    check_ends(ellipsoid, cylinder);
    check_ends(cylinder, hull);
    check_ends(triangle, ellipsoid);
    check_ends(contact::Sphere<double>{any(), 1}, box);
    check_ends(contact::Capsule<double>{{any(), p}, 1}, hull);
  }
}

TEST_CASE("bodies of which nothing is finite are infinitely far apart, without closest points") {
  const contact::Sphere<double> ball{Point::Zero(), 1};
  for (const double bad : {nan, infinity, -infinity}) {
    const contact::Sphere<double> nowhere{Point(1, bad, 2), 1};
    for (const auto& found : {gjk(ball, nowhere), gjk(nowhere, ball), gjk(nowhere, nowhere)}) {
      CHECK(found.distance == infinity);
      CHECK(found.count == 0);
    }
    const contact::Capsule<double> capsule{{Point(0, bad, 0), Point(1, 2, 3)}, 1};
    check_ends(ball, capsule);
    check_ends(capsule, ball);
  }
}

TEST_CASE("equal and degenerate bodies have the distance 0 or that of their points") {
  const Point at{1, 2, 3};
  const contact::Sphere<double> ball{at, 1};
  CHECK(gjk(ball, ball).distance == 0);
  const contact::Triangle<double> point{at, at, at}, segment{at, Point(2, 4, 6), Point(3, 6, 9)};
  CHECK(gjk(point, segment).distance == 0);
  CHECK(gjk(point, contact::Sphere<double>{Point(1, 2, 7), 0}).distance == 4);
  const contact::OrientedBox<double> flat{at, contact::Matrix3<double>::Identity(), Point(1, 0, 1)};
  CHECK(gjk(flat, flat).distance <= 64 * u);
  CHECK(gjk(contact::Cylinder<double>{{at, at}, 0}, ball).distance == 0);
}

TEST_CASE("floats have the distance of cores to within a few of their u") {
  Random random(11);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto in_float = [&random] {
      return generators::rounded<float>(random_poses::any_point(random, 3));
    };
    contact::Triangle<float> a{}, b{};
    for (auto* v : {&a.a, &a.b, &a.c, &b.a, &b.b, &b.c}) *v = in_float();
    const auto in_double = [](const contact::Triangle<float>& t) {
      return contact::Triangle<double>{t.a.cast<double>(), t.b.cast<double>(), t.c.cast<double>()};
    };
    const double exact = gjk(in_double(a), in_double(b)).distance;
    REQUIRE(std::abs(static_cast<double>(gjk(a, b).distance) - exact) <= 64 * 0x1p-24 * 3);
  }
}

TEST_CASE("no coordinate of a result is −0") {
  const contact::Sphere<double> a{Point(-0.0, 1, -0.0), 1}, b{Point(0, 1, -2), 1};
  for (const auto& found : {gjk(a, b), gjk(b, a), gjk(a, a)}) {
    for (int i = 0; i < 3; ++i) {
      CHECK_FALSE((found.between(i) == 0 && std::signbit(found.between(i))));
    }
    CHECK_FALSE(std::signbit(found.distance));
    CHECK_FALSE(std::signbit(found.lower));
  }
}

TEST_CASE("each step has a simplex that is closer to the origin than the one before") {
  Random random(12);
  for (int i = 0; i < generators::tried(500); ++i) {
    const auto drawn = pair_families::pair(random, Kind::box, Kind::box, Family::random);
    const auto& a = std::get<contact::OrientedBox<double>>(drawn.a);
    const auto& b = std::get<contact::OrientedBox<double>>(drawn.b);
    const auto steps = gjk_steps(a, b);
    const GjkResult<double> found = gjk(a, b);
    REQUIRE_FALSE(steps.empty());
    double before = infinity;
    for (const auto& step : steps) {
      REQUIRE(step.count >= 1);
      REQUIRE(step.count <= 3);
      REQUIRE(step.closest.norm() < before);
      before = step.closest.norm();
      // The next vertex is the farthest towards the origin.
      for (int k = 0; k < step.count; ++k) {
        const Point& w = step.vertices[static_cast<std::size_t>(k)];
        REQUIRE(step.next.dot(step.closest) <= w.dot(step.closest) + 64 * u * 64);
      }
    }
    if (found.distance > 1e-12) {
      REQUIRE(std::abs(steps.back().closest.norm() - found.distance) <= 4 * u * found.distance);
    }
  }
}

}  // namespace
}  // namespace gjk_test
