// The depth of penetration against all faces of the difference, in integers.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/penetration.hpp>
#include <contact/signed_distance.hpp>
#include <limits>

#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "support/generators.hpp"

namespace penetration_test {

using generators::Random;
using generators::tried;
using pair_bodies::Kind;
using pair_families::Family;
using V = contact::Vector3<double>;

namespace {

constexpr double u = 0x1p-53;

double size_of(const pair_families::Pair& pair) {
  return pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b);
}

}  // namespace

TEST_CASE("the depth of polytopes is that of the nearest face of the difference") {
  Random random(951);
  int deep = 0;
  for (const Kind kind_a : {Kind::box, Kind::triangle, Kind::lozenge, Kind::hull}) {
    for (const Kind kind_b : {Kind::box, Kind::triangle, Kind::lozenge, Kind::hull}) {
      for (int i = 0; i < tried(104); ++i) {
        const auto family = pair_families::all[static_cast<std::size_t>(i) % 13];
        const auto pair = pair_families::pair(random, kind_a, kind_b, family);
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          const auto truth = pair_truth::truth(a, b);
          const double right =
              oracle::nearest(truth.distance) + contact::radius_of(a) + contact::radius_of(b);
          const double room = 64 * u * size_of(pair);
          if (right > -room) return;
          ++deep;
          const auto found = contact::penetration(a, b);
          CHECK(std::abs(found.depth + right) <= room);
          const V off = found.on_a - found.on_b + found.normal * found.depth;
          CHECK(off.cwiseAbs().maxCoeff() <= 4 * room);
        });
      }
    }
  }
  CHECK(deep > tried(100));
}

TEST_CASE("the depth of smooth bodies is that of a plane of support, up to the stated excess") {
  Random random(952);
  int deep = 0;
  for (const Kind smooth : {Kind::cylinder, Kind::ellipsoid}) {
    for (const Kind kind : pair_bodies::all_kinds) {
      for (int i = 0; i < tried(24); ++i) {
        const Family family = i % 2 == 0 ? Family::random : Family::deep;
        const auto pair = pair_families::pair(random, kind, smooth, family);
        pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
          const auto found = contact::signed_distance(a, b);
          const double room = 256 * u * size_of(pair);
          const double along = pair_proofs::gap_along(pair.a, pair.b, found.normal);
          CHECK(std::abs(found.distance - along) <= 0x1p-30 * size_of(pair));
          if (found.distance > 0) return;
          ++deep;
          // No direction that is tried at random separates by less.
          for (int k = 0; k < 20; ++k) {
            const V n = random_poses::direction(random);
            CHECK(pair_proofs::gap_along(pair.a, pair.b, n) <=
                  found.distance + 0x1p-20 * size_of(pair) + room);
          }
        });
      }
    }
  }
  CHECK(deep > tried(100));
}

TEST_CASE("two balls as ellipsoids: depth, normal and points in closed form") {
  Random random(953);
  for (int i = 0; i < tried(200); ++i) {
    const V c = random_poses::direction(random) * random.uniform(0.1, 1);
    const contact::Matrix3<double> axes = random_poses::turn(random);
    const contact::Ellipsoid<double> a{c, axes, V(1, 1, 1)};
    const contact::Ellipsoid<double> b{V(0, 0, 0), axes, V(0.5, 0.5, 0.5)};
    const auto found = contact::signed_distance(a, b);
    CHECK(std::abs(found.distance - (c.norm() - 1.5)) <= 1e-11);
    CHECK((found.normal - c.normalized()).norm() <= 1e-4);
    CHECK((found.on_b - c.normalized() * 0.5).norm() <= 1e-4);
  }
}

TEST_CASE("differences in a plane, on a line or at a point have depth 0") {
  const contact::Triangle<double> one{V(0, 0, 1), V(4, 0, 1), V(0, 4, 1)};
  const contact::Triangle<double> other{V(1, 1, 1), V(5, 1, 1), V(1, 5, 1)};
  const auto flat = contact::penetration(one, other);
  CHECK(flat.depth == 0);
  CHECK(std::abs(flat.normal.z()) == 1);
  const contact::Triangle<double> line{V(0, 0, 0), V(1, 1, 0), V(3, 3, 0)};
  const auto along = contact::penetration(line, line);
  CHECK(along.depth == 0);
  CHECK(std::abs(along.normal.dot(V(1, 1, 0))) <= 2 * u);
  const contact::Triangle<double> point{V(1, 2, 3), V(1, 2, 3), V(1, 2, 3)};
  const auto same = contact::signed_distance(point, point);
  CHECK(same.distance == 0);
  CHECK(std::abs(same.normal.norm() - 1) <= 2 * u);
}

TEST_CASE("a distance to a body that is not finite is NaN") {
  const contact::Triangle<double> good{V(0, 0, 1), V(4, 0, 1), V(0, 4, 1)};
  contact::Triangle<double> bad = good;
  bad.b.x() = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(contact::signed_distance(good, bad).distance));
  CHECK(contact::signed_distance(bad, good).normal == V(0, 0, 0));
}

}  // namespace penetration_test
