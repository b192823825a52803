// From a scene to a setup, and from a setup to the least composition: what is left out, why, and
// that it makes no difference.
#include <catch2/catch_test_macros.hpp>
#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_make.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <stdexcept>
#include <string>

#include "support/generators.hpp"

using contact::compose_hard_spheres;
using contact::HardSphereEffects;
using contact::HardSphereSetup;
using contact::make_hard_spheres;
using contact::Vector3;
using generators::Random;

namespace {

contact::SceneBody ball(const char* name, const Vector3<double>& x, const Vector3<double>& v) {
  contact::SceneBody body;
  body.name = name;
  body.shape = contact::BallShape{0.5};
  body.mass = 1;
  body.position = x;
  body.velocity = v;
  return body;
}

contact::Scene scene() {
  contact::Scene made;
  made.name = "test";
  made.gravity = {0, 0, -10};
  made.materials = {{"ivory", 0.9, 0, std::nullopt, 0}, {"steel", 1, 0.5, std::nullopt, 0}};
  contact::SceneBody floor;
  floor.name = "floor";
  floor.shape = contact::HalfSpaceShape{};
  floor.moves = false;
  made.bodies = {ball("one", {0, 0, 2}, {0, 0, 0}), floor, ball("two", {3, 0, 2}, {0, 0, 1})};
  made.duration = 1;
  return made;
}

}  // namespace

TEST_CASE("only the effects that a setup needs are on") {
  HardSphereSetup setup;
  setup.balls = {{{1, 2, 3}, {0, 0, 0}, 0.5, 1, 0, true}, {{1, 5, 3}, {0, -1, 0}, 0.5, 1, 0, true}};
  CHECK(compose_hard_spheres(setup).effects == HardSphereEffects{1, false, false, false, false});
  CHECK(compose_hard_spheres(setup).axes[0] == 1);
  setup.gravity = {0, 0, -1};
  CHECK(compose_hard_spheres(setup).effects == HardSphereEffects{2, true, false, false, false});
  setup.balls[0].radius = 0.25;
  CHECK(compose_hard_spheres(setup).effects.sizes);
  setup.balls[0].radius = 0.5;
  setup.balls[0].mass = 3;
  CHECK(compose_hard_spheres(setup).effects.sizes);
  setup.restitution = {0.5};
  CHECK(compose_hard_spheres(setup).effects.restitution);
  // An oblique wall deflects balls out of the plane.
  setup.walls = {{Vector3<double>(0.6, 0.8, 0), -20, 0}};
  CHECK(compose_hard_spheres(setup).effects.dimension == 3);
}

TEST_CASE("the least composition gives the bits of all effects, in all 48") {
  Random random(1);
  for (int dimension = 1; dimension <= 3; ++dimension) {
    for (int number = 0; number < 16; ++number) {
      HardSphereSetup setup;
      const bool gravity = (number & 1) != 0;
      const bool radii = (number & 2) != 0;
      const bool masses = (number & 4) != 0;
      for (int i = 0; i < 8; ++i) {
        contact::HardBall ball;
        ball.radius = radii ? random.uniform(0.2, 0.5) : 0.5;
        ball.mass = masses ? random.uniform(0.5, 2) : 1.5;
        const int place[3] = {dimension == 1 ? i : i % 2, dimension == 3 ? i / 2 % 2 : i / 2,
                              i / 4};
        for (int k = 0; k < 3; ++k) {
          ball.position(k) = k < dimension ? 0.75 + 1.5 * place[k] : 0.75;
          if (k < dimension) ball.velocity(k) = random.uniform(-2, 2);
        }
        setup.balls.push_back(ball);
      }
      for (int k = 0; k < 3; ++k) {
        setup.walls.push_back({Vector3<double>::Unit(k), 0, 0});
        setup.walls.push_back({-Vector3<double>::Unit(k), -16, 0});
      }
      if (gravity) setup.gravity(dimension - 1) = -3;
      if ((number & 8) != 0) setup.restitution = {0.95};
      auto composition = compose_hard_spheres(setup);
      REQUIRE(composition.effects ==
              HardSphereEffects{dimension, gravity, radii || masses, (number & 8) != 0, false});
      contact::HardSphereComposition all;
      const auto full = make_hard_spheres(setup, all);
      full->advance(5);
      REQUIRE(full->counts().hits > 5);
      for (const bool grid : {false, true}) {
        composition.effects.grid = grid;
        const auto least = make_hard_spheres(setup, composition);
        least->advance(5);
        REQUIRE(least->counts().hits == full->counts().hits);
        REQUIRE(least->bytes_per_state() <= full->bytes_per_state());
        for (std::size_t i = 0; i < setup.balls.size(); ++i) {
          REQUIRE(least->position(i) == full->position(i));
          REQUIRE(least->velocity(i) == full->velocity(i));
        }
      }
    }
  }
}

TEST_CASE("a scene of balls and half-spaces becomes a setup, and says which body is which") {
  const auto made = contact::hard_sphere_setup(scene());
  CHECK(made.setup.balls.size() == 2);
  CHECK(made.setup.walls.size() == 1);
  CHECK(made.ball_body == std::vector<std::size_t>{0, 2});
  CHECK(made.wall_body == std::vector<std::size_t>{1});
  CHECK(made.setup.restitution == std::vector<double>{0.9, 0.9, 0.9, 1});
  CHECK(made.setup.cutoff == 0x1p-20);
  auto elastic = scene();
  elastic.materials[0].restitution = 1;
  CHECK(contact::hard_sphere_setup(elastic).setup.cutoff == 0x1p-30);
}

TEST_CASE("a scene that is not one of hard, smooth balls is rejected with the reason") {
  const auto refusal = [](auto change) {
    contact::Scene changed = scene();
    change(changed);
    return contact::hard_sphere_refusal(changed).value_or("");
  };
  CHECK(refusal([](auto&) {}).empty());
  CHECK(refusal([](auto& s) {
          s.bodies[2].shape = contact::BoxShape{{1, 1, 1}};
        }) == "bodies[2] (two) is neither a ball nor a half-space");
  CHECK(refusal([](auto& s) { s.materials[0].friction = 0.25; }) ==
        "bodies[0] (one) and bodies[1] (floor) have friction: their coefficient is 0.25");
  // The smoother decides: a rough floor alone does not matter.
  CHECK(refusal([](auto& s) { s.bodies[1].material = 1; }).empty());
  CHECK(refusal([](auto& s) { s.materials[0].stiffness = 100; }) ==
        "bodies[0] (one) and bodies[1] (floor) are compliant: their stiffness is 50 N/m");
  CHECK(refusal([](auto& s) {
          s.bodies[0].moves = false;
          s.bodies[2].moves = false;
        }) == "no ball moves");
  auto boxed = scene();
  boxed.bodies[0].shape = contact::BoxShape{{1, 1, 1}};
  CHECK_THROWS_AS(contact::hard_sphere_setup(boxed), std::invalid_argument);
}
