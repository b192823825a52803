// Cores that almost meet: distance, direction and points must be as right as elsewhere.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/signed_distance.hpp>
#include <variant>

#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "random_poses.hpp"
#include "reference.hpp"
#include "support/generators.hpp"

namespace near_cores_test {

using contact::Capsule;
using contact::OrientedBox;
using generators::Random;
using generators::tried;
using pair_bodies::Kind;
using random_poses::direction;
using reference::V;

namespace {

constexpr double u = 0x1p-53;

/// A's and B's answer, moved by the distance along the normal: how far the bodies then are from
/// touching.
template <class A, class B>
double off_touching(const A& a, const B& b) {
  const auto found = contact::signed_distance(a, b);
  const pair_bodies::Body moved =
      pair_bodies::moved(pair_bodies::Body(a), V(-found.normal * found.distance));
  return std::abs(oracle::nearest(pair_truth::truth(std::get<A>(moved), b).distance));
}
/// The same for body kinds with a radius whose cores are at a distance of 10⁻¹⁴ to 10⁻⁹.
double check_near(Random& random, Kind kind_a, Kind kind_b) {
  const auto drawn = pair_families::pair(random, kind_a, kind_b, pair_families::Family::touching);
  double worst = 0;
  pair_bodies::with_polytopes(drawn.a, drawn.b, [&](auto a, const auto& b) {
    const double gap = std::pow(10.0, -random.uniform(9, 14));
    // The cores touch if both bodies move together by their radii.
    const double radii = contact::radius_of(a) + contact::radius_of(b);
    auto near = pair_bodies::moved(pair_bodies::Body(a), V(-drawn.normal * (radii - gap)));
    const auto& first = std::get<std::decay_t<decltype(a)>>(near);
    const double size = pair_bodies::size_of(near) + pair_bodies::size_of(pair_bodies::Body(b));
    worst = off_touching(first, b) / size;
    const auto found = contact::signed_distance(first, b);
    const auto truth = pair_truth::truth(first, b);
    CHECK(std::abs(found.distance - oracle::nearest(truth.distance)) <= 64 * u * size);
    CHECK(V(found.on_a - found.on_b - found.normal * found.distance).norm() <= 128 * u * size);
  });
  return worst;
}

}  // namespace

TEST_CASE("a capsule whose core almost meets a box has the right normal") {
  OrientedBox<double> box;
  box.centre = V(0.3, 0.2, 0.1);
  contact::Quaternion<double> q{0.9, V(0.3, -0.2, 0.1)};
  box.axes = contact::matrix_of(contact::normalised(q));
  box.half_lengths = V(1, 1, 1);
  const Capsule<double> capsule{{V(-0.58347234886935229, -0.93501751138258093, 0.13862049092363818),
                                 V(-0.75741910186604366, -0.1497576314563826, 0.72306499013840264)},
                                0.25};
  const auto found = contact::signed_distance(capsule, box);
  CHECK(std::abs(found.distance + 0.25) <= 1e-12);
  CHECK(off_touching(capsule, box) <= 1e-12);
}

TEST_CASE("cores of any kinds that almost meet: the translation separates, as it should") {
  // Before, the direction was the difference of two nearly equal points: off by up to 7 %.
  Random random(941);
  for (const Kind a : pair_bodies::polytope_kinds) {
    for (const Kind b : pair_bodies::polytope_kinds) {
      double worst = 0;
      for (int i = 0; i < tried(16); ++i) worst = std::max(worst, check_near(random, a, b));
      CAPTURE(pair_bodies::name(a), pair_bodies::name(b));
      CHECK(worst <= 256 * u);
    }
  }
}

TEST_CASE("crossing segments at a small angle are moved apart perpendicularly to both") {
  Random random(942);
  for (int i = 0; i < tried(2000); ++i) {
    const V middle = random_poses::any_point(random, 2);
    const V d = direction(random);
    const double angle = std::ldexp(random.uniform(1, 2), -random.integer(4, 40));
    const V e = d + direction(random) * angle;
    const Capsule<double> a{{V(middle - d), V(middle + d)}, 0.5};
    const Capsule<double> b{{V(middle - e), V(middle + e)}, 0.25};
    const auto found = contact::signed_distance(a, b);
    CHECK(std::abs(found.distance + 0.75) <= 1e-14);
    CHECK(std::abs(found.normal.dot(a.core.end - a.core.start)) <= 1e-8);
    CHECK(std::abs(found.normal.dot(b.core.end - b.core.start)) <= 1e-8);
  }
}

TEST_CASE("exchanged bodies have the opposite normal and exchanged points, and nothing is -0") {
  Random random(943);
  for (const Kind kind_a : pair_bodies::all_kinds) {
    for (const Kind kind_b : pair_bodies::all_kinds) {
      for (int i = 0; i < tried(26); ++i) {
        const auto family = pair_families::all[static_cast<std::size_t>(i) % 13];
        if (family == pair_families::Family::equal && kind_a == kind_b) continue;
        const auto drawn = pair_families::pair(random, kind_a, kind_b, family);
        pair_bodies::with(drawn.a, drawn.b, [](const auto& a, const auto& b) {
          const auto one = contact::signed_distance(a, b);
          const auto other = contact::signed_distance(b, a);
          CHECK(one.distance == other.distance);
          CHECK(one.normal == -other.normal);
          CHECK(one.on_a == other.on_b);
          CHECK(one.on_b == other.on_a);
          CHECK(std::abs(one.normal.norm() - 1) <= 8 * u);
          for (const V& v : {one.normal, one.on_a, one.on_b, other.normal}) {
            for (int k = 0; k < 3; ++k) CHECK_FALSE((v(k) == 0 && std::signbit(v(k))));
          }
          CHECK_FALSE((one.distance == 0 && std::signbit(one.distance)));
        });
      }
    }
  }
}

}  // namespace near_cores_test
