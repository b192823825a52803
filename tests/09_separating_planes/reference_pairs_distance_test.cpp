// Signed distances of bodies of all kinds: they are right, and do not depend on which body is named
// first. u is the unit roundoff.
#include <catch2/catch_test_macros.hpp>
#include <contact/signed_distance.hpp>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_truth.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using generators::tried;
using pair_bodies::Body;
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
