// What is right is computed in integers. The first questions of a test each bring one mistake to
// light that no question before did, so that the mistake is known by it.
#include "keep_the_witness.hpp"

#include <limits>

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <09_separating_planes/witness_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using exercise::Answer;
using exercise::Kept;
using exercise::Step;
using witness_with_mistakes::Begin;
using witness_with_mistakes::edge_separates;
using witness_with_mistakes::Exchange;
using witness_with_mistakes::Polygon;
using witness_with_mistakes::Result;
using witness_with_mistakes::Returned;
using witness_with_mistakes::Separates;
using witness_with_mistakes::Use;
using witness_with_mistakes::Ways;
using Polygons = std::vector<Polygon>;
using Pairs = std::vector<std::array<int, 2>>;

constexpr double kFar = 1000000;

int edges(const Polygon& polygon) { return static_cast<int>(polygon.size()); }

/// Whether the edge with this number separates the polygons.
bool is_separating(const Polygon& a, const Polygon& b, int number) {
  const int m = edges(a);
  if (number < 0 || number >= m + edges(b)) return false;
  return number < m ? edge_separates(a, static_cast<std::size_t>(number), b)
                    : edge_separates(b, static_cast<std::size_t>(number - m), a);
}

void check_pair(const Polygon& a, const Polygon& b, int witness) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return witness_with_mistakes::test_pair(a, b, witness, ways); };
  };
  ask("Are the polygons apart, and by which edge?")
      .given("a", a)
      .given("b", b)
      .given("witness", witness)
      .suspect("vertex-on-the-line-is-beyond", with({.separates = Separates::if_touching}))
      .suspect("some-vertex-beyond-the-edge", with({.separates = Separates::if_some_to_the_right}))
      .suspect("edge-normal-inwards", with({.separates = Separates::if_all_to_the_left}))
      .suspect("edges-of-one-polygon", with({.a_alone = true}))
      .suspect("own-number-in-b", with({.returned = Returned::own_number_in_b}))
      .suspect("last-edge-named", with({.returned = Returned::last_that_separates}))
      .suspect("all-edges-tested", with({.all_tested = true}))
      .suspect("separating-edge-not-counted", with({.last_uncounted = true}))
      .suspect("witness-ignored", with({.use = Use::ignored}))
      .suspect("witness-of-b-in-a", with({.use = Use::of_a_alone}))
      .suspect("witness-lost", with({.returned = Returned::nothing_if_kept}))
      .suspect_if("witness-believed",
                  [&](const Answer& got) {
                    return got.apart && got.witness == witness && witness >= 0 &&
                           witness < edges(a) + edges(b) && !is_separating(a, b, witness);
                  })
      .suspect("witness-alone", with({.use = Use::alone}))
      .suspect("witness-tested-twice", with({.use = Use::tested_twice}))
      .suspect("search-from-the-witness", with({.use = Use::from_it}))
      .suspect("neighbours-of-the-witness", with({.use = Use::neighbours}))
      .suspect("stale-witness-kept", with({.returned = Returned::kept_if_meeting}))
      .suspect("number-modulo-edges", with({.use = Use::modulo}))
      .suspect("no-edge-counted", with({.use = Use::counted}))
      .answer([&] { return exercise::test_pair(a, b, witness); })
      .equals(witness_with_mistakes::test_pair(a, b, witness));
}

void check_exchanged(int witness, int edges_of_a, int edges_of_b) {
  const auto with = [&](Exchange how) {
    return
        [&, how] { return witness_with_mistakes::exchanged(witness, edges_of_a, edges_of_b, how); };
  };
  ask("Which number has the edge if B comes first?")
      .given("witness", witness)
      .given("edges_of_a", edges_of_a)
      .given("edges_of_b", edges_of_b)
      .suspect("witness-not-renumbered", with(Exchange::not_at_all))
      .suspect("own-edges-added", with(Exchange::by_own_edges))
      .suspect("none-becomes-an-edge", with(Exchange::none_as_edge))
      .suspect("added-for-both", with(Exchange::added_to_both))
      .answer([&] { return exercise::exchanged(witness, edges_of_a, edges_of_b); })
      .equals(witness_with_mistakes::exchanged(witness, edges_of_a, edges_of_b));
}

void check_step(const Polygons& polygons, const Pairs& near, const std::vector<Kept>& kept) {
  const auto with = [&](Begin begin, Result result = Result::rightly) {
    return [&, begin, result] {
      return witness_with_mistakes::test_pairs(polygons, near, kept, begin, result);
    };
  };
  ask("Which pairs meet, and what is kept of the others?")
      .given("polygons", polygons)
      .given("near", near)
      .given("kept", kept)
      .suspect("witness-ignored", with(Begin::not_at_all))
      .suspect("witness-by-position", with(Begin::by_position))
      .suspect("one-witness-for-all", with(Begin::from_the_last_pair))
      .suspect("pair-in-one-order", with(Begin::in_one_order))
      .suspect("witness-not-renumbered", with(Begin::not_renumbered))
      .suspect("edge-counts-exchanged", with(Begin::counts_exchanged))
      .suspect("old-pairs-kept", with(Begin::rightly, Result::old_pairs_too))
      .suspect("meeting-pairs-kept", with(Begin::rightly, Result::meeting_kept))
      .suspect("kept-in-the-old-order", with(Begin::rightly, Result::old_order))
      .suspect("old-witness-stored", with(Begin::rightly, Result::old_witness))
      .suspect("last-pair-counted", with(Begin::rightly, Result::last_count))
      .answer([&] { return exercise::test_pairs(polygons, near, kept); })
      .equals(witness_with_mistakes::test_pairs(polygons, near, kept));
}

/// Its edges 0 to 3 are below, to the right, above and to the left.
Polygon box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}
Polygon square() { return box(0, 0, 4, 4); }
/// Separated from the square by its edge 0 alone.
Polygon triangle() { return {{2, 9}, {9, 2}, {9, 9}}; }
/// Its right angle is to the upper right of the square; its edges 0 and 2 separate.
Polygon corner() { return {{7, 7}, {12, 7}, {7, 12}}; }
Polygon large() {
  return {{-kFar, -kFar}, {kFar - 1, 1 - kFar}, {kFar, kFar}, {3 - kFar, kFar - 2}};
}

/// Polygons around the square, which is the first: to the upper right, to the upper left, over it,
/// and a triangle to the upper right.
Polygons several() {
  return {square(), box(7, 7, 3, 3), box(-9, 7, 4, 4), box(3, 1, 5, 2), corner()};
}

bool is_polygon(const Polygon& polygon) {
  for (const Eigen::Vector2d& v : polygon) {
    if (v != v.array().round().matrix() || v.cwiseAbs().maxCoeff() > kFar) return false;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = 2; j < polygon.size(); ++j) {
      if (witness_with_mistakes::side(witness_with_mistakes::vertex(polygon, i),
                                      witness_with_mistakes::vertex(polygon, i + 1),
                                      witness_with_mistakes::vertex(polygon, i + j)) <= 0)
        return false;
    }
  }
  return polygon.size() >= 3;
}

/// A polygon with at most this many vertices, within the size from a point, by taking off what is
/// not convex of random points in the order of their angles.
Polygon random_polygon(generators::Random& random, int limit, const Eigen::Vector2d& from,
                       double size) {
  while (true) {
    Polygon polygon;
    const int count = random.integer(3, limit);
    for (int i = 0; i < count; ++i) {
      const double angle = 6.28 * (i + random.uniform(0.0, 0.8)) / count;
      const double radius = size * random.uniform(0.5, 1.0);
      polygon.push_back(
          (from + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))).array().round());
    }
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3; ++i) {
      Polygon less = polygon;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
      if (!is_polygon(polygon)) polygon = less;
    }
    if (is_polygon(polygon)) return polygon;
  }
}

}  // namespace

TEST_CASE("the edges are tested in order until one separates") {
  check_pair(square(), box(7, 1, 3, 2), -1);
  check_pair(square(), triangle(), -1);
  check_pair(triangle(), square(), -1);
  check_pair(square(), box(3, 1, 5, 2), -1);
  check_pair(box(1, 1, 2, 2), square(), -1);
  check_pair(square(), box(1, 1, 2, 2), -1);
  check_pair(box(-2, 1, 8, 2), box(1, -2, 2, 8), -1);
  check_pair(square(), box(1, -9, 3, 2), -1);
  check_pair(square(), box(-9, 1, 2, 2), -1);
  check_pair(square(), large(), -1);
  check_pair(large(), box(kFar - 5, -kFar, 5, 2), -1);
  check_pair({{0, 0}, {kFar, kFar - 1}, {0, kFar}}, {{2, 0}, {kFar, 1}, {kFar, kFar - 2}}, -1);
}

TEST_CASE("polygons that touch are not apart") {
  check_pair(square(), box(4, 1, 3, 2), -1);
  check_pair(square(), box(4, 4, 3, 3), -1);
  check_pair(square(), {{2, 4}, {5, 9}, {-1, 9}}, -1);
  check_pair({{2, 6}, {6, 2}, {6, 6}}, square(), -1);
  check_pair(square(), box(6, 4, 3, 3), -1);
  check_pair({{0, 0}, {kFar, kFar - 1}, {0, kFar}}, {{0, 0}, {kFar, 1}, {kFar, kFar - 1}}, -1);
}

TEST_CASE("a kept edge that still separates is the only one tested") {
  check_pair(square(), box(7, 7, 3, 3), 2);
  check_pair(square(), box(7, 7, 3, 3), 7);
  check_pair(square(), box(7, 7, 3, 3), 4);
  check_pair(square(), triangle(), 4);
  check_pair(triangle(), square(), 0);
  check_pair(square(), corner(), 6);
  check_pair(corner(), square(), 2);
}

TEST_CASE("a kept edge that no longer separates is not believed") {
  check_pair(square(), box(7, 1, 3, 2), 3);
  check_pair(square(), box(7, 1, 3, 2), 0);
  check_pair(square(), box(3, 1, 5, 2), 1);
  check_pair(square(), box(3, 1, 5, 2), 6);
  check_pair(square(), triangle(), 2);
  check_pair(square(), triangle(), 6);
  check_pair(square(), box(4, 1, 3, 2), 1);
  check_pair(square(), box(4, 1, 3, 2), 7);
  check_pair(triangle(), square(), 4);
}

TEST_CASE("a number that no edge has is none") {
  constexpr int kLargest = std::numeric_limits<int>::max();
  check_pair(square(), box(7, 1, 3, 2), 15);
  check_pair(square(), box(7, 1, 3, 2), -7);
  check_pair(square(), box(7, 1, 3, 2), 8);
  check_pair(square(), box(7, 1, 3, 2), 9);
  check_pair(square(), box(7, 1, 3, 2), kLargest);
  check_pair(square(), box(7, 1, 3, 2), -kLargest);
  check_pair(square(), triangle(), 7);
  check_pair(square(), box(3, 1, 5, 2), 8);
  check_pair(square(), box(3, 1, 5, 2), kLargest);
}

TEST_CASE("whether the polygons are apart does not depend on what was kept") {
  for (const Polygon& b : {box(7, 1, 3, 2), box(7, 7, 3, 3), box(3, 1, 5, 2), box(4, 1, 3, 2),
                           triangle(), corner(), large()}) {
    for (int witness = -2; witness <= 9; ++witness) {
      check_pair(square(), b, witness);
      check_pair(b, square(), witness);
    }
  }
}

TEST_CASE("an edge has another number in the other order") {
  check_exchanged(2, 4, 3);
  check_exchanged(5, 4, 3);
  check_exchanged(-1, 4, 3);
  check_exchanged(0, 4, 3);
  check_exchanged(3, 4, 3);
  check_exchanged(4, 4, 3);
  check_exchanged(6, 4, 3);
  check_exchanged(7, 4, 3);
  check_exchanged(-2, 4, 3);
  check_exchanged(2, 3, 9);
  check_exchanged(3, 3, 9);
  check_exchanged(11, 3, 9);
  check_exchanged(12, 3, 9);
  check_exchanged(std::numeric_limits<int>::max(), 3, 9);
  check_exchanged(std::numeric_limits<int>::min(), 3, 9);
}

TEST_CASE("each pair begins with the edge that was kept for it") {
  check_step(several(), {{0, 2}, {0, 1}}, {{0, 1, 7}, {0, 2, 3}});
  check_step(several(), {{0, 3}, {0, 1}}, {{0, 3, 1}, {0, 1, 7}});
  check_step(several(), {{0, 1}, {0, 2}, {1, 2}}, {});
  check_step(several(), {{1, 2}, {0, 2}}, {{0, 2, 5}, {1, 2, 3}});
  check_step(several(), {}, {});
}

TEST_CASE("what a step finds replaces what was kept") {
  check_step(several(), {{0, 1}}, {{0, 1, 0}});
  check_step(several(), {{0, 4}, {0, 2}}, {{0, 2, 1}, {0, 4, 5}});
  check_step(several(), {{0, 3}}, {{0, 3, 1}});
}

TEST_CASE("a pair may have been kept in the other order") {
  check_step(several(), {{1, 0}}, {{0, 1, 7}});
  check_step(several(), {{4, 0}}, {{0, 4, 6}});
  check_step(several(), {{0, 4}}, {{4, 0, 5}});
  check_step(several(), {{2, 0}, {0, 1}, {4, 2}}, {{0, 1, 2}, {2, 4, 1}, {0, 2, 3}});
  check_step(several(), {{3, 0}}, {{0, 3, 1}});
}

TEST_CASE("a pair that is not near any more is forgotten") {
  check_step(several(), {{0, 1}}, {{0, 2, 3}, {0, 1, 7}});
  check_step(several(), {}, {{0, 2, 3}, {0, 1, 7}});
  check_step(several(), {{1, 2}}, {{0, 2, 3}, {0, 1, 7}});
}

TEST_CASE("random steps agree with integers") {
  generators::Random random(seed(0));
  const auto judged = [](const Polygon& a, const Polygon& b, int) {
    return is_polygon(a) && is_polygon(b);
  };
  for (int asked = 0; asked < 150; ++asked) {
    const double size = asked % 3 == 0 ? 400000 : 6;
    const auto shift = [&] {
      const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
      return Eigen::Vector2d(size * Eigen::Vector2d(x, y));
    };
    Polygons polygons;
    for (int i = 0; i < 4; ++i) polygons.push_back(random_polygon(random, 8, shift(), 0.8 * size));
    const int witness = random.integer(-1, edges(polygons[0]) + edges(polygons[1]));
    shrinkable(check_pair, judged, polygons[0], polygons[1], witness);
    Pairs near;
    std::vector<Kept> kept;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        const bool other_order = random.integer(0, 1) == 1, is_near = random.integer(0, 3) > 0;
        const int number = random.integer(0, edges(polygons[static_cast<std::size_t>(i)]) +
                                                 edges(polygons[static_cast<std::size_t>(j)]) - 1);
        if (is_near) near.push_back({i, j});
        if (random.integer(0, 3) > 0)
          kept.push_back({other_order ? j : i, other_order ? i : j, number});
      }
    }
    check_step(polygons, near, kept);
  }
}
