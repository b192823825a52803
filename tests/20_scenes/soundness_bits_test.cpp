// A plan leaves out only what it may: the run that it decides on, compared with runs with more
// effects. Where a decision rests only on a proof of inactivity the bits must be the same.
#include <catch2/catch_test_macros.hpp>
#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_make.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <memory>

#include "soundness.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Scene;
using generators::Random;
using generators::tried;
using soundness::random_balls;
using soundness::scenes_of_the_book;

namespace {

/// The run of a scene of hard balls with every effect, needed or not.
std::unique_ptr<contact::HardSphereRun> with_all_effects(const Scene& scene) {
  return contact::make_hard_spheres(contact::hard_sphere_setup(scene).setup,
                                    contact::HardSphereComposition());
}

/// Whether the least composition of a scene of hard balls has the bits of all effects, at eight
/// times and in its count of hits.
bool least_has_the_bits_of_all(const Scene& scene, double end) {
  const auto least = contact::make_hard_spheres(contact::hard_sphere_setup(scene).setup);
  const auto all = with_all_effects(scene);
  for (int k = 1; k <= 8; ++k) {
    least->advance(end * k / 8);
    all->advance(end * k / 8);
    if (least->counts().hits != all->counts().hits) return false;
    for (std::size_t i = 0; i < least->moving(); ++i) {
      if (least->position(i) != all->position(i)) return false;
      if (least->velocity(i) != all->velocity(i)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("hard balls of the book's scenes have the bits of all effects") {
  int runs = 0;
  for (const Scene& scene : scenes_of_the_book()) {
    if (contact::hard_sphere_refusal(scene)) continue;
    if (!contact::decision_on(contact::plan_scene(scene), Effect::event_driven).on) continue;
    CAPTURE(scene.name);
    const double end = scene.bodies.size() > 1000 ? scene.duration / 16 : scene.duration;
    CHECK(least_has_the_bits_of_all(scene, end));
    ++runs;
  }
  CHECK(runs >= 8);
}

TEST_CASE("hard balls of random scenes have the bits of all effects") {
  Random random(20);
  for (int trial = 0; trial < tried(3000); ++trial) {
    CAPTURE(trial);
    REQUIRE(least_has_the_bits_of_all(random_balls(random), 2));
  }
}
