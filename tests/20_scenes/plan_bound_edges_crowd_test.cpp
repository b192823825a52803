// The bounds of crowds at their edges: each scene was made for one term of a bound.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/scene/scene_solids.hpp>
#include <string>
#include <vector>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Scene;
using contact::SceneBounds;
using generators::tried;
using plan_scenes::at_edge;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::decision;
using plan_scenes::empty;
using plan_scenes::off;
using plan_scenes::Point;
using plan_scenes::stepped;
using plan_scenes::wall;

namespace {

/// More bodies than are tested one by one: 254 balls of ½ m in rows, and three others. All but the
/// first two of the balls are at rest.
Scene unlike_crowd() {
  Scene scene = empty(1, 0, 1, 1e-6);
  scene.materials = {{"hard", 0.5, 0.25, {}, 0},
                     {"lively", 1, 0, {}, 0},
                     {"soft", 1, 0, 1e4, 3},
                     {"softer", 1, 0, 1e3, 0}};
  for (int i = 0; i < 254; ++i)
    ball(scene, 0.5, 2, {3.0 * (i % 16), 3.0 * (i / 16), 0}).material = 1;
  scene.bodies[0].material = 0;
  scene.bodies[0].velocity = {1, 0, 0};
  scene.bodies[1].material = 0;
  scene.bodies[1].velocity = {-1, 0, 0};
  scene.bodies[2].material = 2;
  scene.bodies[3].material = 3;
  return scene;
}

}  // namespace

TEST_CASE("a crowd's bound is as bad as the worst of its pairs, whichever it is") {
  for (const int where : {0, 100, 253}) {
    CAPTURE(where);
    Scene scene = unlike_crowd();
    if (where == 100) {  // materials in another order
      std::swap(scene.materials[0], scene.materials[1]);
      for (auto& body : scene.bodies) body.material ^= body.material < 2 ? 1U : 0U;
    }
    const auto k = static_cast<std::size_t>(where);
    // A thin and light body, which rotates most easily.
    scene.bodies[k].shape = contact::CapsuleShape{0.0625, 0.4};
    scene.bodies[k].mass = 0.125;
    scene.bodies[k].inertia = contact::solid_inertia(scene.bodies[k].shape, 0.125);
    ball(scene, 0.5, 2, {60, 0, 0}).material = 1;
    ball(scene, 0.0625, 2, {63, 0, 0}).material = 1;
    ball(scene, 0.5, 2, {66, 0, 0}).material = 1;
    wall(scene, Point::UnitZ(), -1);
    scene.bodies.back().material = 3;
    box(scene, {0.25, 1, 1}, 0, {90, 0, 0});
    const SceneBounds bounds = contact::scene_bounds(scene);
    REQUIRE(bounds.crowded);
    REQUIRE(bounds.pairs.size() == 3);
    double kinetic = 0;
    for (const auto& body : scene.bodies)
      kinetic += body.moves ? body.mass * body.velocity.squaredNorm() : 0;
    for (const auto& pair : bounds.pairs) {
      bool soft = false;
      bool hard = false;
      for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
          const auto& one = scene.bodies[a];
          const auto& other = scene.bodies[b];
          if (a == b || !one.moves || (pair.both_move ? !other.moves : b != pair.b)) continue;
          const auto made = contact::pair_material(scene.materials[one.material],
                                                   scene.materials[other.material]);
          REQUIRE(pair.friction >= made.friction);
          soft = soft || made.stiffness;
          hard = hard || !made.stiffness;
          if (made.stiffness) {
            REQUIRE(pair.stiffness >= *made.stiffness);
            REQUIRE(pair.damping >= made.damping);
          } else {
            REQUIRE(pair.min_restitution <= made.restitution);
            REQUIRE(pair.max_restitution >= made.restitution);
          }
          const double core = contact::inner_radius(one.shape) + contact::inner_radius(other.shape);
          REQUIRE(pair.core <= core);
          const bool round = contact::is_ball(one) && (contact::is_ball(other) || pair.half_space);
          REQUIRE((!pair.round || round));
          const double w = bounds.bodies[a].surface_inverse_mass +
                           (other.moves ? bounds.bodies[b].surface_inverse_mass : 0);
          REQUIRE(pair.closing >= std::sqrt(kinetic * w) * (1 - 1e-9));
          const double inverse_mass = 1 / one.mass + (other.moves ? 1 / other.mass : 0);
          REQUIRE(pair.inverse_mass >= inverse_mass);
        }
      }
      CHECK(pair.soft == soft);
      CHECK(pair.hard == hard);
    }
    CHECK(contact::plan_scene(scene).pairs == 257 * 256 / 2 + 257 + 257);
    CHECK(contact::plan_scene(scene).speed >= std::sqrt(kinetic / 0.125) * (1 - 1e-9));
  }
}

TEST_CASE("a crowd's decisions follow from the worst of its pairs") {
  Scene scene = unlike_crowd();
  for (int k = 0; k < 8; ++k) ball(scene, 0.5, 2, {60.0 + 3 * k, 0, 0}).material = 1;
  CHECK(plan_scenes::is_on(scene, Effect::friction));
  CHECK(plan_scenes::is_on(scene, Effect::penalty_contact));
  CHECK(plan_scenes::is_on(scene, Effect::several_contacts));
  CHECK_FALSE(plan_scenes::is_on(scene, Effect::event_driven));
  // ω of the stiffest pair, two of 10⁴ N/m in a row: the soft ball and a hard one.
  CHECK(contact::plan_scene(scene, stepped(1)).spring_substep <=
        1 / (128 * std::sqrt(1e4 * (0.5 + 0.5))) * (1 + 1e-12));
  // Without gravity, elastic, smooth: one compliant body is enough to go in steps, and so is one
  // that is inelastic.
  Scene mixed = scene;
  mixed.materials[0] = {"dull", 0, 0, {}, 0};
  for (auto& body : mixed.bodies) body.material = 1;
  off(mixed, Effect::event_driven);
  mixed.bodies[100].material = 2;
  at_edge(mixed, Effect::event_driven, 0, 2);
  mixed.bodies[100].material = 0;
  at_edge(mixed, Effect::event_driven, 0, 5);
  // Pairs of a crowd are not tested for their first meeting: it may be at once.
  CHECK(decision(mixed, Effect::horizon).because.at(0).right == 0);
  // Only hard balls, most of them elastic: one that is not is enough to come to rest.
  for (auto& body : scene.bodies) body.material = 1;
  scene.materials[0] = {"dull", 0, 0, {}, 0};
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), -1);
  scene.bodies.back().material = 1;
  off(scene, Effect::resting);
  off(scene, Effect::event_driven);
  scene.bodies[100].material = 0;
  CHECK(plan_scenes::is_on(scene, Effect::resting));
  CHECK_FALSE(plan_scenes::is_on(scene, Effect::event_driven));
  CHECK(plan_scenes::is_on(scene, Effect::restitution));  // not all are dull
}

TEST_CASE("tunnelling: in a crowd the plan names the thin body") {
  Scene scene = unlike_crowd();
  for (int k = 0; k < 8; ++k) ball(scene, 0.5, 2, {60.0 + 3 * k, 0, 0});
  const auto passing = [&] {
    return decision(scene, Effect::continuous_detection, stepped(0.01))
        .tried.at(1)
        .conditions.at(0);
  };
  CHECK(passing().left_is == "approach of any two moving bodies in a step");
  const auto& plate = box(scene, {0x1p-10, 1, 1}, 0, {100, 0, 0});
  const std::string words = "any moving body and " + plate.name;
  CHECK(passing().left_is == "approach of " + words + " in a step");
  CHECK(passing().right <= 2 * (0.5 + 0x1p-10));
  CHECK_FALSE(contact::scene_bounds(scene).pairs.back().round);
}

TEST_CASE("a crowd starts apart only if no body touches another, or the floor") {
  const auto rests = [](const Scene& scene) { return plan_scenes::is_on(scene, Effect::resting); };
  const auto crowd = [](const std::vector<Point>& more, double radius) {
    Scene scene = empty(1, 0, 1, 1e-6);
    scene.gravity = {0, 0, -8};
    wall(scene, Point::UnitZ(), -1);
    for (int i = 0; i < 260; ++i)
      ball(scene, i == 17 ? radius : 0.25, 1, {2.0 * (i % 20), 2.0 * (i / 20), 0});
    for (const Point& at : more) ball(scene, 0.25, 1, at);
    return scene;
  };
  CHECK_FALSE(rests(crowd({}, 0.25)));
  // Two that touch, on either side of each other and of any cell's edge.
  for (const double from : {60.1, 60.2, 60.3, 60.4}) {
    CHECK(rests(crowd({{from, 0, 5}, {from + 0.5, 0, 5}}, 0.25)));
    CHECK(rests(crowd({{from + 0.5, 0, 5}, {from, 0, 5}}, 0.25)));
    CHECK(rests(crowd({{0, from + 0.5, 5}, {0, from, 5}}, 0.25)));
    CHECK(rests(crowd({{0, 0, from + 0.5}, {0, 0, from}}, 0.25)));
    CHECK_FALSE(rests(crowd({{from, 0, 5}, {from + 0.5001, 0, 5}}, 0.25)));
  }
  // One that is larger than the others, beside one that it touches.
  CHECK_FALSE(rests(crowd({{34, 1.26, 0}}, 0.9)));
  CHECK(rests(crowd({{34, 1.15, 0}}, 0.9)));
  // One that lies on the floor.
  CHECK(rests(crowd({{60, 0, -0.75}}, 0.25)));
  CHECK_FALSE(rests(crowd({{60, 0, std::nextafter(-0.75, 0)}}, 0.25)));
}
