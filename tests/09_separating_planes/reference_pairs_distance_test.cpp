// Signed distances of bodies of all kinds: distance, normal and points belong together, are right
// and do not depend on which body is named first. u is the unit roundoff.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/signed_distance.hpp>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "pair_truth.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using generators::tried;
using pair_bodies::Body;
using pair_bodies::V;
using pair_families::Family;
using pair_families::Pair;
using SignedDistance = contact::SignedDistance<double>;

namespace {

/// By how much a distance of two bodies may be off: 64 u of the magnitudes of all coordinates; with
/// a cylinder or an ellipsoid 2^-40 of them.
double room_of(const Pair& pair) {
  const bool smooth = pair_bodies::is_smooth(pair_bodies::kind_of(pair.a)) ||
                      pair_bodies::is_smooth(pair_bodies::kind_of(pair.b));
  return (smooth ? 0x1p-40 : 0x1p-47) *
         (pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b));
}
SignedDistance distance_of(const Body& a, const Body& b) {
  return pair_bodies::with(
      a, b, [](const auto& x, const auto& y) { return contact::signed_distance(x, y); });
}
bool any_pair(pair_bodies::Kind a, pair_bodies::Kind b) { return a <= b; }

/// Bodies of similar sizes; and where one is smooth, well apart: of those that almost touch or
/// overlap, the points are less accurate than the distance.
bool is_measured(const Pair& pair, Family family, const SignedDistance& found) {
  if (family == Family::thin || family == Family::large) return false;
  const bool smooth = pair_bodies::is_smooth(pair_bodies::kind_of(pair.a)) ||
                      pair_bodies::is_smooth(pair_bodies::kind_of(pair.b));
  const double size = pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b);
  return smooth ? found.distance > 0x1p-10 * size : family != Family::deep;
}

bool has_negative_zero(const V& v) {
  for (int i = 0; i < 3; ++i) {
    if (v(i) == 0 && std::signbit(v(i))) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("signed distances of cores with radii are right to a few u") {
  pair_checks::each_pair(
      971, tried(6), pair_checks::polytopes, [](const Pair& pair, Family family) {
        const SignedDistance found = distance_of(pair.a, pair.b);
        INFO(name(family) << "\n" << pair_checks::text_of(pair));
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          CHECK(oracle::error(found.distance, pair_truth::truth(a, b).distance) <= room_of(pair));
        });
      });
}

TEST_CASE("distance, normal and points of bodies of similar sizes belong together") {
  constexpr double u = 0x1p-53;
  pair_checks::each_pair(972, tried(3), any_pair, [&](const Pair& pair, Family family) {
    const SignedDistance found = distance_of(pair.a, pair.b);
    if (!is_measured(pair, family, found)) return;
    const double room = room_of(pair);
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    CHECK(std::abs(found.normal.dot(found.normal) - 1) <= 16 * u);
    const V between = found.on_a - found.on_b - found.distance * found.normal;
    CHECK(between.cwiseAbs().maxCoeff() <= room);
    CHECK(pair_proofs::distance_from(pair.a, found.on_a) <= room);
    CHECK(pair_proofs::distance_from(pair.b, found.on_b) <= room);
    CHECK_FALSE(std::signbit(found.distance == 0 ? found.distance : 1.0));
    CHECK_FALSE(has_negative_zero(found.normal));
    CHECK_FALSE(has_negative_zero(found.on_a));
    CHECK_FALSE(has_negative_zero(found.on_b));
  });
}

TEST_CASE("exchanging two bodies of any kinds exchanges the points and negates the normal") {
  pair_checks::each_pair(973, tried(3), any_pair, [](const Pair& pair, Family family) {
    if (family == Family::equal) return;  // nothing tells which of two equal bodies comes first
    const SignedDistance found = distance_of(pair.a, pair.b);
    const SignedDistance back = distance_of(pair.b, pair.a);
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    CHECK(back.distance == found.distance);
    CHECK(back.normal == -found.normal);
    CHECK(back.on_a == found.on_b);
    CHECK(back.on_b == found.on_a);
  });
}

TEST_CASE("moving a body of similar size along the normal by the distance makes the two touch") {
  // Along the normal, no gap is larger than the distance, and the gap is the distance: so the plane
  // between the two separates them after the move, and no other separates them by more than room.
  pair_checks::each_pair(974, tried(3), any_pair, [](const Pair& pair, Family family) {
    const SignedDistance found = distance_of(pair.a, pair.b);
    if (!is_measured(pair, family, found)) return;
    const double room = 2 * room_of(pair);
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    const double gap = pair_proofs::gap_along(pair.a, pair.b, found.normal);
    CHECK(std::abs(gap - found.distance) <= room);
    const Body moved = pair_bodies::moved(pair.a, V(found.normal * -found.distance));
    pair_bodies::with_polytopes(moved, pair.b, [&](const auto& a, const auto& b) {
      CHECK(oracle::error(0, pair_truth::truth(a, b).distance) <= room);
    });
  });
}
