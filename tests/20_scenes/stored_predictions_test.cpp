// Hard balls: what can be looked at of their predictions, and one event at a time.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/hard_spheres.hpp>
#include <cstddef>
#include <vector>

#include "hard_setups.hpp"
#include "support/generators.hpp"

using contact::HardSphereEffects;
using contact::HardSpherePrediction;
using contact::HardSpheres;
using contact::HardSphereSetup;
using contact::Vector3;
using generators::Random;
using hard_setups::Log;
using hard_setups::random_setup;

namespace {

constexpr HardSphereEffects with_cells{3, false, false, false, true};
constexpr HardSphereEffects all_pairs{3, false, false, false, false};
constexpr std::size_t balls = 40;

template <HardSphereEffects E>
void check_same_bits(const HardSpheres<E>& a, const HardSpheres<E>& b) {
  const auto of_a = a.checkpoint();
  const auto of_b = b.checkpoint();
  for (std::size_t i = 0; i < balls; ++i) {
    REQUIRE(of_a.balls[i].position == of_b.balls[i].position);
    REQUIRE(of_a.balls[i].velocity == of_b.balls[i].velocity);
    REQUIRE(of_a.balls[i].time == of_b.balls[i].time);
    REQUIRE(of_a.balls[i].last == of_b.balls[i].last);
  }
}

/// Calls f(run, prediction, counts before, log of the event) for some hundreds of single events.
template <HardSphereEffects E, class F>
void each_event(std::uint64_t seed, const F& f) {
  Random random(seed);
  for (int n = 0; n < 6; ++n) {
    HardSpheres<E> run(random_setup(random, balls, true, 0));
    for (int event = 0; event < 300; ++event) {
      const HardSpherePrediction next = run.prediction(run.queue().first());
      const auto before = run.counts();
      const std::size_t first = run.queue().first();
      Log log;
      REQUIRE(run.advance_one_event(&log));
      f(run, first, next, before, log);
    }
  }
}

}  // namespace

TEST_CASE("events one at a time give the same bits as a run without a stop") {
  Random random(91);
  for (int n = 0; n < 6; ++n) {
    const HardSphereSetup setup = random_setup(random, balls, true, 0);
    HardSpheres<with_cells> singly(setup);
    for (int event = 0; event < 500; ++event) REQUIRE(singly.advance_one_event());
    HardSpheres<with_cells> at_once(setup);
    at_once.advance(singly.now());
    REQUIRE(singly.counts().hits == at_once.counts().hits);
    REQUIRE(singly.counts().crossings == at_once.counts().crossings);
    REQUIRE(singly.counts().stale == at_once.counts().stale);
    REQUIRE(singly.counts().stale > 0);
    check_same_bits(singly, at_once);
  }
}

TEST_CASE("simultaneous events are processed one at a time too") {
  // Two pairs, mirror images of one another.
  HardSphereSetup setup;
  for (const double y : {0.0, 4.0}) {
    setup.balls.push_back(hard_setups::ball({0, y, 0}, {1, 0, 0}));
    setup.balls.push_back(hard_setups::ball({2, y, 0}, {-1, 0, 0}));
  }
  HardSpheres<all_pairs> run(setup);
  Log log;
  REQUIRE(run.advance_one_event(&log));
  CHECK(log.hits.size() == 1);
  CHECK(log.hits[0].ball == 0);
  REQUIRE(run.advance_one_event(&log));
  CHECK(log.hits.size() == 2);
  CHECK(log.hits[1].ball == 2);
  CHECK(log.hits[1].time == log.hits[0].time);
  CHECK_FALSE(run.advance_one_event(&log));
}

TEST_CASE("the first ball's prediction says which event comes next, and when") {
  int hits = 0;
  int crossings = 0;
  int voids = 0;
  each_event<with_cells>(92, [&](const auto& run, std::size_t first, const auto& next,
                                 const auto& before, const Log& log) {
    const auto after = run.counts();
    REQUIRE(run.now() == next.time);
    REQUIRE(after.crossings - before.crossings == (next.crossing ? 1 : 0));
    REQUIRE(after.stale - before.stale == (!next.crossing && next.is_void ? 1 : 0));
    REQUIRE(log.hits.size() == (!next.crossing && !next.is_void ? 1 : 0));
    crossings += next.crossing;
    voids += !next.crossing && next.is_void;
    if (log.hits.empty()) return;
    ++hits;
    const auto self = static_cast<std::int32_t>(first);
    const auto two = std::minmax(self, next.partner);
    REQUIRE(log.hits[0].time == next.hit_time);
    REQUIRE(log.hits[0].ball == static_cast<std::size_t>(two.first));
    REQUIRE(log.hits[0].partner == static_cast<std::size_t>(two.second));
  });
  CHECK(hits > 0);
  CHECK(crossings > 0);
  CHECK(voids > 0);
}

TEST_CASE("a prediction becomes void when its partner is hit, and at no other time") {
  Random random(93);
  int made = 0;
  for (int n = 0; n < 6; ++n) {
    HardSpheres<all_pairs> run(random_setup(random, balls, true, 0));
    for (int event = 0; event < 300; ++event) {
      std::vector<HardSpherePrediction> before;
      for (std::size_t i = 0; i < balls; ++i) before.push_back(run.prediction(i));
      const std::size_t first = run.queue().first();
      Log log;
      REQUIRE(run.advance_one_event(&log));
      const auto was_hit = [&log](std::size_t i) {
        return !log.hits.empty() && (log.hits[0].ball == i || log.hits[0].partner == i);
      };
      for (std::size_t i = 0; i < balls; ++i) {
        // Those that were hit, and the owner of a discarded prediction, have new ones.
        const bool is_new = was_hit(i) || (log.hits.empty() && i == first);
        // A hit changes no wall.
        const auto partner = static_cast<std::size_t>(before[i].partner);
        const bool partner_was_hit = partner < balls && was_hit(partner);
        const bool should = !is_new && (before[i].is_void || partner_was_hit);
        REQUIRE(run.prediction(i).is_void == should);
        made += should && !before[i].is_void;
      }
    }
  }
  CHECK(made > 0);
}

TEST_CASE("each node of the tournament names the earliest event below it") {
  each_event<with_cells>(
      94, [](const auto& run, std::size_t, const auto&, const auto&, const Log&) {
        const contact::EarliestQueue& queue = run.queue();
        REQUIRE(queue.leaves() == 64);
        for (std::size_t node = 1; node < 2 * queue.leaves(); ++node) {
          std::size_t low = node;
          std::size_t high = node;
          for (; low < queue.leaves(); low *= 2) high = 2 * high + 1;
          std::int32_t wanted = -1;
          for (std::size_t i = low - queue.leaves(); i <= high - queue.leaves() && i < balls; ++i) {
            const bool earlier =
                wanted < 0 ||
                run.prediction(i).time < run.prediction(static_cast<std::size_t>(wanted)).time;
            if (earlier) wanted = static_cast<std::int32_t>(i);
          }
          const std::int32_t winner = queue.winner(node);
          REQUIRE((winner < 0) == (wanted < 0));
          // Of a pair that predicts the same hit either may win, by their indices.
          if (winner >= 0)
            REQUIRE(run.prediction(static_cast<std::size_t>(winner)).time ==
                    run.prediction(static_cast<std::size_t>(wanted)).time);
        }
      });
}

TEST_CASE("a ball is in the cell where it is listed, up to rounding") {
  each_event<with_cells>(
      95, [](const auto& run, std::size_t, const auto&, const auto&, const Log&) {
        const auto& cells = run.cells();
        for (std::size_t i = 0; i < balls; ++i) {
          for (int k = 0; k < 3; ++k) {
            const auto cell = static_cast<double>(cells.cell(i)[static_cast<std::size_t>(k)]);
            REQUIRE(cell >= 0);
            REQUIRE(cell < static_cast<double>(cells.count(k)));
            const double inside = run.position(i)(k) - cells.origin()(k) - cell * cells.width();
            REQUIRE(inside >= -1e-12);
            REQUIRE(inside <= cells.width() + 1e-12);
          }
        }
      });
}

TEST_CASE("balls at rest have no next event") {
  HardSphereSetup setup;
  setup.balls.push_back(hard_setups::ball({0, 0, 0}, {0, 0, 0}));
  setup.balls.push_back(hard_setups::ball({2, 0, 0}, {0, 0, 0}));
  HardSpheres<with_cells> run(setup);
  CHECK(run.prediction(0).time == contact::never);
  CHECK(run.prediction(0).partner == -1);
  CHECK_FALSE(run.prediction(0).crossing);
  CHECK_FALSE(run.advance_one_event());
  CHECK(run.now() == 0);
}
