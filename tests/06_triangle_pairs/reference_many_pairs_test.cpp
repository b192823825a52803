// Many pairs of triangles of every family: against integers, and against exact arithmetic.
#include <06_triangle_pairs/pair_families.hpp>
#include <06_triangle_pairs/pair_truth.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/triangles_meet.hpp>
#include <cstdint>
#include <limits>
#include <map>
#include <support/generators.hpp>

namespace many_pairs_test {
namespace {

using contact::triangles_meet;
using contact::triangles_meet_unfiltered;
using generators::Random;
using pair_families::Family;
using pair_families::Pair;

/// The other triangle first, its vertices one further, those of the first reversed.
template <class S>
Pair<S> reordered(const Pair<S>& pair) {
  const auto& [s, t] = pair;
  return {{t.b, t.c, t.a}, {s.c, s.b, s.a}};
}

/// Requires the same answer for the pair in two orders and as floats or doubles.
template <class S>
void require_meet(const Pair<S>& pair, bool meet) {
  const Pair<S> other = reordered(pair);
  if (triangles_meet(pair.first, pair.second) != meet ||
      triangles_meet(other.first, other.second) != meet) {
    FAIL("triangles_meet says " << !meet << " of " << pair.first.a.transpose() << ", "
                                << pair.first.b.transpose() << ", " << pair.first.c.transpose()
                                << " and " << pair.second.a.transpose() << ", "
                                << pair.second.b.transpose() << ", " << pair.second.c.transpose());
  }
}

/// How many pairs of each answer a family must have at the least, in a thousand.
struct Share {
  int meet = 100, apart = 100;
};
Share min_share(Family family) {
  switch (family) {
    case Family::vertex_on_vertex:
    case Family::vertex_on_edge:
    case Family::vertex_on_face:
    case Family::edge_on_edge:
    case Family::shared_edge:
    case Family::coplanar_overlapping:
    case Family::coplanar_touching:
    case Family::coplanar_inside:
      return {1000, 0};
    case Family::coplanar_apart:
      return {0, 1000};
    default:
      return {};
  }
}
void check_share(std::map<bool, int>& seen, Family family, int count) {
  const Share least = min_share(family);
  CHECK(seen[true] >= count / 1000 * least.meet);
  CHECK(seen[false] >= count / 1000 * least.apart);
}

TEST_CASE("a million decisions of each family are those of integers") {
  // 250,000 pairs, half of them of floats; each in two orders, floats also as doubles and doubles
  // also times a power of two.
  for (const Family family : pair_families::all) {
    INFO(pair_families::name(family));
    Random random(1 + static_cast<std::uint64_t>(family));
    std::map<bool, int> seen;
    const int count = generators::tried(125000);
    for (int i = 0; i < count; ++i) {
      const Pair<float> floats = pair_families::pair<float>(random, family);
      const bool meet = pair_truth::meet_in_integers(floats.first, floats.second);
      ++seen[meet];
      require_meet(floats, meet);
      require_meet(pair_families::in<double>(floats), meet);
      const Pair<double> doubles = pair_families::pair<double>(random, family);
      const bool also = pair_truth::meet_in_integers(doubles.first, doubles.second);
      require_meet(doubles, also);
      require_meet(pair_families::scaled(doubles, 64 - i % 128), also);
    }
    check_share(seen, family, count);
  }
}

template <class S>
void check_rounded(Family family, std::uint64_t seed, int count) {
  INFO(pair_families::name(family) << ", " << sizeof(S) << " bytes");
  Random random(seed + static_cast<std::uint64_t>(family));
  for (int i = 0; i < count; ++i) {
    const Pair<S> pair = pair_families::rounded_pair<S>(random, family);
    require_meet(pair, pair_truth::meet_exactly(pair.first, pair.second));
  }
}
TEST_CASE("of pairs without whole numbers, ten thousand decisions of each family are exact") {
  for (const Family family : pair_families::all) {
    check_rounded<double>(family, 100, generators::tried(2500));
    check_rounded<float>(family, 200, generators::tried(2500));
  }
}

TEST_CASE("pairs at the ends of the range of doubles and of floats are decided without error") {
  const auto check = [](auto drawn, int exponent, bool meet) {
    require_meet(pair_families::scaled(drawn, exponent), meet);
  };
  for (const Family family : pair_families::all) {
    INFO(pair_families::name(family));
    Random random(300 + static_cast<std::uint64_t>(family));
    for (int i = 0; i < generators::tried(500); ++i) {
      const Pair<double> doubles = pair_families::pair<double>(random, family);
      const bool meet = pair_truth::meet_in_integers(doubles.first, doubles.second);
      check(doubles, -1074, meet);
      check(doubles, -700 + i % 400, meet);
      check(doubles, 1023 - 53, meet);
      const Pair<float> floats = pair_families::pair<float>(random, family);
      const bool also = pair_truth::meet_in_integers(floats.first, floats.second);
      check(floats, -149, also);
      check(floats, 127 - 24, also);
    }
  }
}

TEST_CASE("a power of two of its own for each axis changes no decision") {
  for (const Family family : pair_families::all) {
    INFO(pair_families::name(family));
    Random random(350 + static_cast<std::uint64_t>(family));
    for (int i = 0; i < generators::tried(1000); ++i) {
      Pair<double> pair = pair_families::pair<double>(random, family);
      const bool meet = pair_truth::meet_in_integers(pair.first, pair.second);
      for (int k = 0; k < 3; ++k) {
        const int exponent = i % 2 == 0 ? random.integer(-60, 60) : random.integer(-1000, 900);
        for (auto* t : {&pair.first, &pair.second}) {
          for (auto* v : {&t->a, &t->b, &t->c}) (*v)[k] = std::ldexp((*v)[k], exponent);
        }
      }
      require_meet(pair, meet);
    }
  }
}

TEST_CASE("any bit patterns are decided as exact arithmetic without a filter decides them") {
  Random random(400);
  for (int i = 0; i < generators::tried(1500); ++i) {
    Pair<double> pair;
    for (auto* t : {&pair.first, &pair.second}) {
      *t = {generators::any_vector(random), generators::any_vector(random),
            generators::any_vector(random)};
    }
    if (i % 3 == 0) pair.second.b = pair.first.b;
    if (i % 7 == 0) pair.second.c = pair.second.a;
    const bool meet = pair_truth::meet_exactly(pair.first, pair.second);
    require_meet(pair, meet);
    REQUIRE(triangles_meet_unfiltered(pair.first, pair.second) == meet);
  }
}

TEST_CASE("in no family a triangle that is not finite meets anything") {
  const Pair<double> pair{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
  REQUIRE(triangles_meet(pair.first, pair.second));
  for (const double bad :
       {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
        std::numeric_limits<double>::quiet_NaN()}) {
    for (int k = 0; k < 3; ++k) {
      Pair<double> broken = pair;
      broken.second.a[k] = bad;
      require_meet(broken, false);
      CHECK_FALSE(triangles_meet_unfiltered(broken.first, broken.second));
    }
  }
}

}  // namespace
}  // namespace many_pairs_test
