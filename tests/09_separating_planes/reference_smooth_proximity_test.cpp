// Cylinders and ellipsoids: what is proved is true, and what stays undecided is within bounds of a
// few u. (Pairs of all kinds and families: reference_pairs_smooth_test.cpp.)
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/proximity.hpp>
#include <cstddef>
#include <variant>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "random_poses.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace smooth_proximity_test {
namespace {

using contact::certified_proximity;
using contact::CertifiedProximity;
using contact::Cylinder;
using contact::Ellipsoid;
using contact::Proximity;
using contact::Sphere;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Surd;
using oracle::Vector;
using pair_checks::case_of;
using pair_families::Family;
using pair_families::Pair;
using Point = contact::Vector3<double>;

/// The width of the bounds of undecided pairs that is allowed, as a share of the sizes.
constexpr double widest = 0x1p-44;

TEST_CASE("what stays undecided is within bounds of a few u of the sizes") {
  int undecided = 0, all = 0;
  pair_checks::each_pair(940, tried(6), pair_checks::smooth, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const CertifiedProximity found = certified_proximity(a, b);
      ++all;
      if (found.state != Proximity::undecided) return;
      ++undecided;
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      const double size = pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b);
      CHECK(found.low <= 0);
      CHECK(found.high >= 0);
      CHECK(found.high - found.low <= widest * size);
      const bool clear = family == Family::random || family == Family::deep;
      CHECK_FALSE(clear);
    });
  });
  CHECK(undecided < all / 3);
}

/// A ball as an ellipsoid.
Ellipsoid<double> ball(const Sphere<double>& sphere, const contact::Matrix3<double>& axes) {
  return {sphere.centre, axes, Point(sphere.radius, sphere.radius, sphere.radius)};
}

/// Whether an answer agrees with the sign and the value of a signed distance.
void check(const CertifiedProximity& found, const Surd& distance) {
  const auto at_most = [&](double x) {
    return std::isinf(x) || oracle::compare({oracle::exact(x), 0, 0}, distance) <= 0;
  };
  const auto at_least = [&](double x) {
    return std::isinf(x) || oracle::compare({oracle::exact(x), 0, 0}, distance) >= 0;
  };
  if (found.state != Proximity::undecided) {
    CHECK(found.state == case_of(oracle::sign(distance)));
    if (found.state != Proximity::disjoint) return;
  }
  CHECK(at_most(found.low));
  CHECK(at_least(found.high));
}

TEST_CASE("ellipsoids that are balls agree with spheres") {
  Random random(941);
  int decided = 0;
  const int count = tried(312);
  for (int i = 0; i < count; ++i) {
    const auto family = pair_families::all[static_cast<std::size_t>(i) % 13];
    using pair_bodies::Kind;
    const Pair pair = pair_families::pair(random, Kind::sphere, Kind::sphere, family);
    const auto& a = std::get<Sphere<double>>(pair.a);
    const auto& b = std::get<Sphere<double>>(pair.b);
    const Vector between = oracle::exact(a.centre) - oracle::exact(b.centre);
    const Surd distance{-oracle::exact(a.radius) - oracle::exact(b.radius), 1,
                        between.dot(between)};
    const auto axes = contact::Matrix3<double>(contact::Matrix3<double>::Identity());
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    const CertifiedProximity both = certified_proximity(ball(a, axes), ball(b, axes));
    check(both, distance);
    check(certified_proximity(ball(a, axes), b), distance);
    check(certified_proximity(a, ball(b, axes)), distance);
    if (both.state != Proximity::undecided) ++decided;
  }
  CHECK(decided > count / 2);
}

TEST_CASE("a cylinder along z and a sphere agree with the distance of its axis and caps") {
  Random random(942);
  std::array<int, 4> seen{};
  for (int i = 0; i < tried(2000); ++i) {
    const auto number = [&](double low, double high) {
      return i % 2 == 0 ? double(random.integer(int(low), int(high))) : random.uniform(low, high);
    };
    const double half = number(1, 4), wide = number(1, 4);
    const Cylinder<double> a{{Point(0, 0, -half), Point(0, 0, half)}, wide};
    const double x = number(-6, 6), y = number(-6, 6), z = number(-8, 8);
    Sphere<double> b{Point(x, y, z), number(0, 4)};
    // Beyond the wall, the caps or both.
    const double off = std::sqrt(x * x + y * y);
    const bool by_caps =
        oracle::exact(x) * oracle::exact(x) + oracle::exact(y) * oracle::exact(y) <=
        oracle::exact(wide) * oracle::exact(wide);
    const bool by_wall = std::abs(z) <= half;
    if (!by_caps && !by_wall) continue;  // two roots
    if (i % 4 == 1) b.radius = by_wall ? off - wide : std::abs(z) - half;
    if (!(b.radius >= 0)) continue;
    const Rational past_cap = oracle::exact(std::abs(z)) - oracle::exact(half);
    const Rational r = oracle::exact(b.radius);
    Surd distance{past_cap - r, 0, 0};
    if (!by_caps) {
      distance = {-oracle::exact(wide) - r, 1,
                  oracle::exact(x) * oracle::exact(x) + oracle::exact(y) * oracle::exact(y)};
    }
    const CertifiedProximity found = certified_proximity(a, b);
    ++seen[static_cast<std::size_t>(found.state)];
    INFO(half << " " << wide << " " << x << " " << y << " " << z << " " << b.radius);
    if (by_caps && by_wall) {  // the centre is inside
      const bool point_on_surface = b.radius == 0 && found.state != Proximity::overlapping;
      CHECK((found.state == Proximity::overlapping || point_on_surface));
    } else {
      check(found, distance);
    }
  }
  for (const int count : seen) CHECK(count > 0);
}

TEST_CASE("a cylinder that stands on a box touches it, with a plane and a common point") {
  const contact::OrientedBox<double> box{Point(0, 0, -1), contact::Matrix3<double>::Identity(),
                                         Point(4, 4, 1)};
  const auto standing = [](double height) {
    return Cylinder<double>{{Point(1, 1, height), Point(1, 1, height + 3)}, 2};
  };
  const CertifiedProximity found = certified_proximity(standing(0), box);
  CHECK(found.state == Proximity::touching);
  CHECK(separates_weakly(found.plane, standing(0), box));
  CHECK(meeting_proved(found.common, standing(0), box));
  CHECK(certified_proximity(standing(0x1p-60), box).state == Proximity::disjoint);
  CHECK(certified_proximity(standing(-0x1p-40), box).state == Proximity::overlapping);
}

TEST_CASE("what bounds prove to be inside is inside, and close to the surface they prove it") {
  Random random(944);
  int proved = 0, close = 0;
  const int count = tried(6000);
  for (int i = 0; i < count; ++i) {
    const auto kind = i % 2 == 0 ? pair_bodies::Kind::cylinder : pair_bodies::Kind::ellipsoid;
    const auto family = pair_families::all[static_cast<std::size_t>(i / 2) % 13];
    const pair_bodies::Body body = pair_families::pair(random, kind, kind, family).a;
    std::visit(
        [&](const auto& b) {
          const Point inner = contact::inner_point(b);
          const Point p = contact::support(b, random_poses::direction(random));
          const double pull = std::ldexp(random.uniform(-1, 1), random.integer(-54, 0));
          const Point q = p + (inner - p) * pull;
          const bool inside = contact::detail::certainly_inside(b, q);
          INFO(pair_checks::text_of(body) << " " << q.transpose());
          if (inside) CHECK(pair_proofs::inside(body, oracle::exact(q)) > 0);
          if (inside) ++proved;
          if (inside && pull < 0x1p-40) ++close;
          const auto member = contact::detail::pulled_inside(b, p, inner, 0);
          CHECK(member.vertex == -1);
          CHECK(pair_proofs::inside(body, oracle::exact(member.point)) >= 0);
        },
        body);
  }
  CHECK(proved > count / 4);
  CHECK(close > 0);
}

TEST_CASE("equal bodies overlap") {
  Random random(943);
  for (int i = 0; i < tried(200); ++i) {
    const auto kind = i % 2 == 0 ? pair_bodies::Kind::cylinder : pair_bodies::Kind::ellipsoid;
    const Pair pair = pair_families::pair(random, kind, kind, Family::equal);
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto&) {
      const CertifiedProximity found = certified_proximity(a, a);
      INFO(pair_checks::text_of(pair.a));
      CHECK(found.state == Proximity::overlapping);
      CHECK(overlap_proved(found.common, a, a));
    });
  }
}

TEST_CASE("cylinders and ellipsoids without volume are never decided wrongly") {
  const contact::Triangle<double> flat{Point(-9, -9, 0), Point(9, -9, 0), Point(0, 9, 0)};
  // A segment as a cylinder of radius 0, through the triangle, touching and above.
  const auto segment = [](double from, double to) {
    return Cylinder<double>{{Point(0, 0, from), Point(0, 0, to)}, 0};
  };
  CHECK(certified_proximity(segment(1, 2), flat).state == Proximity::disjoint);
  CHECK(certified_proximity(segment(0, 2), flat).state != Proximity::disjoint);
  CHECK(certified_proximity(segment(0, 2), flat).state != Proximity::overlapping);
  CHECK(certified_proximity(segment(-1, 1), flat).state != Proximity::disjoint);
  const Ellipsoid<double> disc{Point::Zero(), contact::Matrix3<double>::Identity(), Point(1, 1, 0)};
  CHECK(certified_proximity(disc, flat).state != Proximity::disjoint);
  CHECK(certified_proximity(disc, flat).state != Proximity::overlapping);
  CHECK(certified_proximity(disc, Sphere<double>{Point(0, 0, 2), 1}).state == Proximity::disjoint);
}

}  // namespace
}  // namespace smooth_proximity_test
