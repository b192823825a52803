// Decisions about two bodies that are a core and a radius, of all kinds, against exact numbers, and
// the proofs that come with them.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <contact/proximity.hpp>
#include <cstddef>

#include "pair_checks.hpp"
#include "pair_families.hpp"
#include "pair_truth.hpp"
#include "shape_oracle.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Proximity;
using generators::tried;
using pair_checks::case_of;
using pair_families::Family;
using pair_families::Pair;

TEST_CASE("the oracle of features agrees with the oracle of active sets") {
  // Of two segments, and of a segment and a box: the latter tries all sets of active bounds.
  generators::Random random(950);
  int apart = 0;
  for (int i = 0; i < tried(260); ++i) {
    const Family family = pair_families::all[static_cast<std::size_t>(i) % 13];
    const auto other = i % 2 == 0 ? pair_bodies::Kind::capsule : pair_bodies::Kind::box;
    const Pair pair = pair_families::pair(random, pair_bodies::Kind::capsule, other, family);
    const auto& a = std::get<contact::Capsule<double>>(pair.a);
    oracle::Rational radii = oracle::exact(a.radius);
    shape_oracle::Zonotope second;
    if (const auto* b = std::get_if<contact::OrientedBox<double>>(&pair.b)) {
      second = shape_oracle::zonotope(shape_oracle::exact(*b));
    } else {
      const auto& c = std::get<contact::Capsule<double>>(pair.b);
      second = shape_oracle::zonotope(oracle::exact(c.core));
      radii += oracle::exact(c.radius);
    }
    const oracle::Rational squared = shape_oracle::min_squared(
        difference(shape_oracle::zonotope(oracle::exact(a.core)), second));
    pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& x, const auto& y) {
      const auto truth = pair_truth::truth(x, y);
      CHECK(truth.sign == oracle::sign(oracle::Rational(squared - radii * radii)));
      if (squared == 0) return;
      ++apart;
      CHECK(oracle::compare(truth.distance, oracle::Surd{-radii, 1, squared}) == 0);
    });
  }
  CHECK(apart > tried(100));
}

TEST_CASE("all pairs of cores with radii: three cases, never wrong, also with the bodies swapped") {
  std::array<int, 3> seen{};
  pair_checks::each_pair(
      951, tried(8), pair_checks::polytopes, [&](const Pair& pair, Family family) {
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          const int sign = pair_truth::truth(a, b).sign;
          ++seen[static_cast<std::size_t>(sign + 1)];
          INFO(name(family) << "\n" << pair_checks::text_of(pair));
          CHECK(contact::proximity(a, b) == case_of(sign));
          CHECK(contact::proximity(b, a) == case_of(sign));
          CHECK(contact::certified_proximity(a, b).state == case_of(sign));
        });
      });
  CHECK(seen[0] > tried(700));
  CHECK(seen[1] > tried(100));
  CHECK(seen[2] > tried(700));
}

TEST_CASE("each answer about cores with radii carries a proof, and its bounds are bounds") {
  pair_checks::each_pair(
      952, tried(2), pair_checks::polytopes, [&](const Pair& pair, Family family) {
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          const auto answer = contact::certified_proximity(a, b);
          INFO(name(family) << "\n" << pair_checks::text_of(pair));
          CHECK(pair_checks::fault_of(pair.a, pair.b, answer).empty());
          if (answer.state == Proximity::disjoint) {
            CHECK(contact::separates(answer.plane, a, b));
          } else if (answer.state == Proximity::touching) {
            CHECK(contact::separates_weakly(answer.plane, a, b));
            CHECK(contact::meeting_proved(answer.common, a, b));
          } else {
            CHECK(contact::overlap_proved(answer.common, a, b));
            return;
          }
          const auto truth = pair_truth::truth(a, b);
          CHECK(oracle::compare(truth.distance, oracle::Surd{oracle::exact(answer.low), 0, 0}) >=
                0);
          if (!std::isfinite(answer.high)) return;
          CHECK(oracle::compare(truth.distance, oracle::Surd{oracle::exact(answer.high), 0, 0}) <=
                0);
        });
      });
}

TEST_CASE("no witness changes an answer about cores with radii, and each answer has a proof") {
  // The witness is that of another pair of the same kinds, so it is often stale.
  pair_checks::each_pair(
      953, tried(2), pair_checks::polytopes, [&](const Pair& pair, Family family) {
        pair_bodies::with_polytopes(pair.a, pair.b, [&](const auto& a, const auto& b) {
          const auto right = contact::certified_proximity(a, b).state;
          INFO(name(family) << "\n" << pair_checks::text_of(pair));
          contact::ProximityWitness witness;
          contact::certified_proximity_with_witness(b, a, witness);
          for (int again = 0; again < 2; ++again) {
            const auto answer = contact::certified_proximity_with_witness(a, b, witness);
            CHECK(answer.state == right);
            CHECK(pair_checks::fault_of(pair.a, pair.b, answer).empty());
          }
        });
      });
}
