// The runs by which an exercise's test measures what is conserved: that they can tell, for many
// seeds, in scenes whose answer is known from textbooks.
#include <catch2/catch_test_macros.hpp>

#include <22_horizon/kept_runs.hpp>

namespace {

using kept_runs::Changes;
using kept_runs::V3;

constexpr double kept = 1e-10, changed = 1e-6;

Changes measured(const kept_runs::Scene& scene, std::uint64_t seed) {
  generators::Random random(seed);
  return kept_runs::changes(scene, 12, random);
}

TEST_CASE("an elastic gas in empty space keeps all but its order") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Changes most = measured({V3::Zero(), {}, true, false, false}, seed);
    CHECK(most.energy < kept);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(most.momentum[k] < kept);
      CHECK(most.angular_momentum[k] < kept);
    }
    CHECK(most.order == 1);
  }
}

TEST_CASE("friction and loss take energy, and neither momentum nor angular momentum") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const bool elastic : {false, true}) {
      const Changes most = measured({V3::Zero(), {}, elastic, elastic, false}, seed);
      CHECK(most.energy > changed);
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(most.momentum[k] < kept);
        CHECK(most.angular_momentum[k] < kept);
      }
    }
  }
}

TEST_CASE("above a floor the horizontal momentum and the vertical angular momentum are kept") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const bool lossless : {false, true}) {
      const Changes most =
          measured({V3(0, 0, -5), {V3(0, 0, 1)}, lossless, !lossless, false}, seed);
      CHECK((lossless ? most.energy < kept : most.energy > changed));
      CHECK(most.momentum[0] < kept);
      CHECK(most.momentum[1] < kept);
      CHECK(most.momentum[2] > changed);
      CHECK(most.angular_momentum[0] > changed);
      CHECK(most.angular_momentum[1] > changed);
      CHECK(most.angular_momentum[2] < kept);
    }
  }
}

TEST_CASE("a wall changes the momentum along its normal and the angular momentum about others") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Changes most =
        measured({V3::Zero(), {V3(1, 0, 0), V3(0, 0.6, 0.8)}, true, false, false}, seed);
    CHECK(most.energy < kept);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(most.momentum[k] > changed);
      CHECK(most.angular_momentum[k] > changed);
    }
  }
}

TEST_CASE("on a line order and angular momentum are kept, and friction takes nothing") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const bool elastic : {false, true}) {
      const Changes most =
          measured({V3(0, 0, -3), {V3(0, 0, 1), V3(0, 0, -1)}, elastic, true, true}, seed);
      CHECK((elastic ? most.energy < kept : most.energy > changed));
      CHECK(most.momentum[2] > changed);
      for (std::size_t k = 0; k < 3; ++k) CHECK(most.angular_momentum[k] < kept);
      CHECK(most.order == 0);
    }
  }
}

}  // namespace
