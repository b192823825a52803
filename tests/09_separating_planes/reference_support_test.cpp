// Vertices and supports of bodies: the farthest vertex against fractions, smooth supports against
// their closed forms.
#include <09_separating_planes/pair_families.hpp>
#include <09_separating_planes/random_poses.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/gjk_cores.hpp>
#include <contact/support.hpp>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <variant>

namespace support_test {
namespace {

using contact::ConvexBody;
using contact::Exact;
using contact::PolytopeCore;
using contact::SmoothBody;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using pair_bodies::Kind;
using Point = contact::Vector3<double>;

constexpr double u = 0x1p-53;

static_assert(PolytopeCore<contact::Sphere<double>> && PolytopeCore<contact::ConvexHull<float>>);
static_assert(SmoothBody<contact::Cylinder<float>> && !PolytopeCore<contact::Ellipsoid<double>>);
static_assert(!ConvexBody<contact::HalfSpace<double>>);

/// A body of a kind, somewhere, of sizes from 0.2 m to 2 m.
pair_bodies::Body any_body(Random& random, Kind kind) {
  const pair_bodies::Frame frame = pair_families::detail::any_frame(random);
  return pair_families::detail::body(random, kind, frame);
}

/// Vertex i from the stored numbers, in fractions.
template <class Body>
Vector exact_corner(const Body& body, int i) {
  if constexpr (std::is_same_v<Body, contact::OrientedBox<double>>) {
    Vector v = oracle::exact(body.centre);
    for (int k = 0; k < 3; ++k) {
      const Vector axis = oracle::exact(Point(body.axes.col(k)));
      const Rational half = oracle::exact(body.half_lengths(k)) * ((i >> k & 1) != 0 ? 1 : -1);
      v = v + Vector(axis * half);
    }
    return v;
  } else if constexpr (std::is_same_v<Body, contact::Lozenge<double>>) {
    Vector v = oracle::exact(body.corner);
    if ((i & 1) != 0) v = v + oracle::exact(body.first_edge);
    if ((i & 2) != 0) v = v + oracle::exact(body.second_edge);
    return v;
  } else {
    return oracle::exact(Point(contact::vertex(body, i)));
  }
}

template <class Check>
void for_polytopes(std::uint64_t seed, int count, const Check& check) {
  Random random(seed);
  for (const Kind kind : pair_bodies::polytope_kinds) {
    for (int i = 0; i < generators::tried(count); ++i) {
      std::visit(
          [&](const auto& body) {
            if constexpr (PolytopeCore<std::decay_t<decltype(body)>>) check(random, body);
          },
          any_body(random, kind));
    }
  }
}

TEST_CASE("an exact vertex is that of the stored numbers, and a vertex is close to it") {
  for_polytopes(1, 200, [](Random&, const auto& body) {
    for (int i = 0; i < contact::vertex_count(body); ++i) {
      const Vector expected = exact_corner(body, i);
      const contact::Vector3<Exact> exact = contact::exact_vertex(body, i);
      const Point near = contact::vertex(body, i);
      for (int k = 0; k < 3; ++k) {
        // As a fraction, from a high and a low part: a product of doubles and sums has more digits.
        const double high = rounded<double>(exact(k));
        const double low = rounded<double>(exact(k) - Exact(high));
        const double rest = rounded<double>(exact(k) - Exact(high) - Exact(low));
        REQUIRE(oracle::exact(high) + oracle::exact(low) + oracle::exact(rest) == expected(k));
        REQUIRE(oracle::error(near(k), expected(k)) <= 8 * u * 8);
      }
    }
  });
}

TEST_CASE("the exact support vertex is the farthest, and the rounded one to within rounding") {
  for_polytopes(2, 400, [](Random& random, const auto& body) {
    const Point n = random_poses::direction(random);
    const int found = contact::support_vertex(body, n);
    const int exact = contact::exact_support_vertex(body, contact::exact_vector<double>(n));
    const Vector direction = oracle::exact(n);
    Rational most = direction.dot(exact_corner(body, 0));
    for (int i = 1; i < contact::vertex_count(body); ++i) {
      const Rational along = direction.dot(exact_corner(body, i));
      if (most < along) most = along;
    }
    REQUIRE(direction.dot(exact_corner(body, exact)) == most);
    REQUIRE(oracle::nearest(most - direction.dot(exact_corner(body, found))) <= 32 * u * 8);
    REQUIRE(contact::support(body, n) == Point(contact::vertex(body, found)));
  });
}

TEST_CASE("a point far from the origin does not round the support of an edge or a box") {
  // n · v is the same in double for both ends: only the difference tells them apart.
  const Point start{0x1p53, 0, 0}, n{1, 0, 0x1p-30};
  const contact::Capsule<double> capsule{{start, Point(start + Point(0, 0, 1))}, 1};
  CHECK(n.dot(capsule.core.start) == n.dot(capsule.core.end));
  CHECK(contact::support_vertex(capsule, n) == 1);
  CHECK(contact::support_vertex(capsule, -n) == 0);
  const contact::Triangle<double> triangle{start, start, capsule.core.end};
  CHECK(contact::support_vertex(triangle, n) == 2);
  const contact::Lozenge<double> lozenge{start, Point(0, 0, 1), Point(0, 1, 0), 0};
  CHECK(contact::support_vertex(lozenge, n) == 1);
  contact::OrientedBox<double> box;
  box.centre = start;
  box.half_lengths = Point(1, 1, 1);
  CHECK(contact::support_vertex(box, n) == 5);
}

TEST_CASE("of vertices that are equally far the first is the support vertex") {
  const Point zero = Point::Zero();
  const contact::Triangle<double> triangle{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}};
  CHECK(contact::support_vertex(triangle, Point(1, 0, 0)) == 0);
  CHECK(contact::support_vertex(triangle, zero) == 0);
  const contact::ConvexHull<double> hull{{{1, 0, 0}, {0, 1, 0}, {0, 1, 5}}};
  CHECK(contact::support_vertex(hull, Point(0, 1, 0)) == 1);
  CHECK(contact::support_vertex(hull, zero) == 0);
}

/// n · x with an error of a few u, and its closed form for a smooth body.
double closed_form(const contact::Ellipsoid<double>& body, const Point& n) {
  const Point image(n.dot(Point(body.axes.col(0))) * body.half_lengths(0),
                    n.dot(Point(body.axes.col(1))) * body.half_lengths(1),
                    n.dot(Point(body.axes.col(2))) * body.half_lengths(2));
  return n.dot(body.centre) + image.norm();
}
double closed_form(const contact::Cylinder<double>& body, const Point& n) {
  const Point e = body.core.end - body.core.start;
  return std::max(n.dot(body.core.start), n.dot(body.core.end)) +
         body.radius * n.cross(e).norm() / e.norm();
}

TEST_CASE("the support of a smooth body is on its surface and as far as the closed form says") {
  Random random(3);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Point n = random_poses::direction(random);
    const auto check = [&](const auto& body) {
      const Point found = contact::support(body, n);
      REQUIRE(std::abs(n.dot(found) - closed_form(body, n)) <= 64 * u * 8);
      // A direction of any length gives the same point, and no point exceeds its own support.
      REQUIRE((contact::support(body, Point(n * 0x1p-500)) - found).norm() <= 64 * u * 8);
      REQUIRE((contact::support(body, Point(n * 0x1p900)) - found).norm() <= 64 * u * 8);
      const Point other = random_poses::direction(random);
      REQUIRE(other.dot(found) <= closed_form(body, other) + 64 * u * 8);
    };
    check(std::get<contact::Ellipsoid<double>>(any_body(random, Kind::ellipsoid)));
    check(std::get<contact::Cylinder<double>>(any_body(random, Kind::cylinder)));
  }
}

TEST_CASE("along its core a cylinder's support is the centre of a cap, and for 0 a point of it") {
  const contact::Cylinder<double> body{{{0, 0, -1}, {0, 0, 2}}, 3};
  CHECK(contact::support(body, Point(0, 0, 5)) == Point(0, 0, 2));
  CHECK(contact::support(body, Point(0, 0, -5)) == Point(0, 0, -1));
  CHECK(contact::support(body, Point(0, 0, 0)) == Point(0, 0, -1));
  CHECK(contact::support(body, Point(2, 0, 0)) == Point(3, 0, -1));
}

TEST_CASE("the support of a cylinder almost along its core is on the cap") {
  Random random(5);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const auto cylinder =
        std::get<contact::Cylinder<double>>(any_body(random, pair_bodies::Kind::cylinder));
    const Point core = cylinder.core.end - cylinder.core.start;
    const Point axis = core / core.norm();
    const Point aside = random_poses::direction(random).cross(axis);
    const Point n = axis + aside * std::ldexp(1.0, -random.integer(10, 60));
    const Point from_cap = contact::support(cylinder, n) - cylinder.core.end;
    INFO("case " << i);
    REQUIRE(std::abs(axis.dot(from_cap)) <= 64 * u);
    REQUIRE(from_cap.norm() <= cylinder.radius + 64 * u);
    const Point of_gjk =
        contact::gjk_detail::GjkCore<contact::Cylinder<double>>(cylinder).farthest(n).offset;
    REQUIRE(std::abs(axis.dot(of_gjk)) <= 64 * u);
  }
}

TEST_CASE("every body has its inner point between its supports along any direction") {
  Random random(4);
  for (const Kind kind : pair_bodies::all_kinds) {
    for (int i = 0; i < generators::tried(300); ++i) {
      const Point n = random_poses::direction(random);
      std::visit(
          [&](const auto& body) {
            const double at = n.dot(contact::inner_point(body)), room = 64 * u * 8;
            REQUIRE(at <= n.dot(contact::support(body, n)) + room);
            REQUIRE(at >= n.dot(contact::support(body, -n)) - room);
          },
          any_body(random, kind));
    }
  }
}

TEST_CASE("the radius of a body is that beyond its core, and 0 for a body without one") {
  CHECK(contact::radius_of(contact::Sphere<double>{Point::Zero(), 2}) == 2);
  CHECK(contact::radius_of(contact::ConvexHull<double>{{Point::Zero()}, 0.5}) == 0.5);
  CHECK(contact::radius_of(contact::Cylinder<double>{{Point::Zero(), Point::Ones()}, 2}) == 0);
  CHECK(contact::radius_of(contact::Triangle<float>{}) == 0);
}

}  // namespace
}  // namespace support_test
