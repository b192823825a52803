// Decisions about pairs with a cylinder or an ellipsoid: what is proved is true, and what is
// undecided is so close to touching that the bounds show it.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/proximity.hpp>
#include <contact/signed_distance.hpp>
#include <cstddef>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_proofs.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Proximity;
using generators::tried;
using pair_checks::case_of;
using pair_families::Family;
using pair_families::Pair;

namespace {

/// Whether a family's pairs are far from touching, so that each must be decided.
bool is_clear(Family family) {
  return family == Family::random || family == Family::deep || family == Family::equal;
}

}  // namespace

TEST_CASE(
    "each decision about cylinders and ellipsoids carries a proof, none contradicts another") {
  int decided = 0, all = 0;
  pair_checks::each_pair(961, tried(5), pair_checks::smooth, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const auto answer = contact::certified_proximity(a, b);
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      CHECK(pair_checks::fault_of(pair.a, pair.b, answer).empty());
      ++all;
      decided += answer.state == Proximity::undecided ? 0 : 1;
      const auto known = pair_proofs::proved(pair.a, pair.b, oracle::exact(pair.normal),
                                             oracle::exact(pair.point));
      if (known && answer.state != Proximity::undecided) CHECK(answer.state == case_of(*known));
      const auto swapped = contact::certified_proximity(b, a);
      CHECK(pair_checks::fault_of(pair.b, pair.a, swapped).empty());
      const Proximity state = contact::proximity(a, b);
      if (known && state != Proximity::undecided) CHECK(state == case_of(*known));
      if (answer.state != Proximity::undecided) CHECK(state == answer.state);
    });
  });
  CHECK(decided > all * 2 / 3);
}

TEST_CASE("cylinders and ellipsoids far from touching are decided") {
  pair_checks::each_pair(962, tried(3), pair_checks::smooth, [&](const Pair& pair, Family family) {
    if (!is_clear(family)) return;
    INFO(name(family) << "\n" << pair_checks::text_of(pair));
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      CHECK(contact::proximity(a, b) != Proximity::undecided);
    });
  });
}

TEST_CASE(
    "the bounds of the distance of cylinders and ellipsoids are bounds, and close if undecided") {
  pair_checks::each_pair(963, tried(3), pair_checks::smooth, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const auto answer = contact::certified_proximity(a, b);
      if (answer.state == Proximity::overlapping) return;
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      CHECK(answer.low <= answer.high);
      const double size = pair_bodies::size_of(pair.a) + pair_bodies::size_of(pair.b);
      if (answer.state == Proximity::undecided) CHECK(answer.high - answer.low <= 0x1p-40 * size);
      // A gap along any direction is a lower bound of the distance, two points are an upper one.
      const double room = 0x1p-50 * size;
      const double gap =
          pair_proofs::gap_along(pair.a, pair.b, contact::signed_distance(a, b).normal);
      CHECK(gap <= answer.high + room);
    });
  });
}

TEST_CASE("a witness of cylinders and ellipsoids proves nothing that is false") {
  pair_checks::each_pair(964, tried(2), pair_checks::smooth, [&](const Pair& pair, Family family) {
    pair_bodies::with(pair.a, pair.b, [&](const auto& a, const auto& b) {
      const auto right = contact::certified_proximity(a, b).state;
      INFO(name(family) << "\n" << pair_checks::text_of(pair));
      contact::ProximityWitness witness;
      contact::certified_proximity_with_witness(b, a, witness);
      for (int again = 0; again < 2; ++again) {
        const auto answer = contact::certified_proximity_with_witness(a, b, witness);
        CHECK(pair_checks::fault_of(pair.a, pair.b, answer).empty());
        if (right != Proximity::undecided && answer.state != Proximity::undecided) {
          CHECK(answer.state == right);
        }
      }
    });
  });
}

TEST_CASE("a body of any kind and a half-space: three cases, never wrong") {
  generators::Random random(965);
  std::array<int, 3> seen{};
  for (const auto kind : pair_bodies::all_kinds) {
    for (const Family family : pair_families::all) {
      for (int i = 0; i < tried(24); ++i) {
        const auto [body, half_space] = pair_families::with_half_space(random, kind, family);
        const auto& plane = half_space.boundary;
        const oracle::Vector n = oracle::exact(plane.normal);
        const oracle::Surd lowest = -pair_proofs::support(body, oracle::Vector(-n));
        const int sign = oracle::sign(lowest + oracle::Rational(-oracle::exact(plane.offset)));
        ++seen[static_cast<std::size_t>(sign + 1)];
        INFO(name(family) << "\n" << pair_checks::text_of(body));
        std::visit(
            [&, &h = half_space](const auto& b) {
              CHECK(contact::proximity(b, h) == case_of(sign));
              CHECK(contact::proximity(h, b) == case_of(sign));
              CHECK(contact::certified_proximity(b, h).state == case_of(sign));
            },
            body);
      }
    }
  }
  CHECK(seen[0] > tried(300));
  CHECK(seen[1] > tried(100));
  CHECK(seen[2] > tried(300));
}
