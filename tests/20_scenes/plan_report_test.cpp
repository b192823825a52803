// What a plan says of a condition, and how much work it is to plan many bodies.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/plan/plan_report.hpp>
#include <limits>
#include <string>

#include "plan_scenes.hpp"

using contact::Effect;
using contact::Inequality;
using contact::Relation;
using contact::scenes::condition_text;
using plan_scenes::ball;
using plan_scenes::empty;
using plan_scenes::Point;
using plan_scenes::Scene;
using plan_scenes::wall;

namespace {

/// Balls over a level floor, in a cube of so many along each edge.
Scene lattice(int edge) {
  Scene scene = empty(0.5, 0.25, 1, 1e-2);
  scene.gravity = {0, 0, -10};
  wall(scene, Point::UnitZ(), 0);
  for (int i = 0; i < edge * edge * edge; ++i)
    ball(scene, 0.5, 1,
         {1.25 * (i % edge), 1.25 * (i / edge % edge), 1 + 1.25 * (i / edge / edge)});
  return scene;
}

}  // namespace

TEST_CASE("a condition is said as a sentence that is true of the scene") {
  Inequality gravity{"gravity along z", 10, Relation::equal, 0, "none", "m/s²"};
  CHECK(condition_text(gravity) == "gravity along z is 10 m/s²");
  gravity.left = 0;
  CHECK(condition_text(gravity) == "no gravity along z");

  Inequality bodies{"moving bodies", 1, Relation::equal, 0, "none", ""};
  CHECK(condition_text(bodies) == "1 body can move");
  bodies.left = 12;
  CHECK(condition_text(bodies) == "12 bodies can move");

  Inequality fall{
      "fall in the whole duration, ½ g T²", 5, Relation::at_most, 0.5, "tolerance", "m"};
  CHECK(condition_text(fall) == "the fall ½ g T² is 5 m > 0.5 m");
  fall.right = 5;
  CHECK(condition_text(fall) == "the fall ½ g T² is 5 m ≤ 5 m");

  Inequality rest{"duration", 4, Relation::less, 5, "earliest time at which a ball can rest", "s"};
  CHECK(condition_text(rest) == "no ball rests before t = 5 s");
  rest.right = std::numeric_limits<double>::infinity();
  CHECK(condition_text(rest) == "no ball ever comes to rest");
}

TEST_CASE("a condition of a rule that has no sentence is said by its own words") {
  Inequality unknown{"moons", 2, Relation::equal, 0, "none", ""};
  CHECK(condition_text(unknown) == "moons: 2, not 0");
  unknown.relation = Relation::less;
  CHECK(condition_text(unknown) == "moons: 2 ≥ 0");
}

TEST_CASE("each hypothesis of a proof has a sentence, whether it holds or fails") {
  for (const contact::Hypothesis& one : contact::proof_hypotheses()) {
    if (one.id.starts_with("mirror/")) continue;  // the rule names the axis in the condition
    CAPTURE(one.id);
    const double right = one.relation == Relation::equal ? 0 : 1;
    const std::string own = std::string(one.condition) + ": ";
    const std::string fails = condition_text(contact::required(one.id, 3, right, {}));
    const std::string held = condition_text(contact::required(one.id, 0, right, {}));
    CHECK_FALSE(fails.starts_with(own));
    CHECK_FALSE(held.starts_with(own));
    CHECK(held != fails);
  }
}

TEST_CASE("of the proofs that fail, a summary names the one that lacks least") {
  Scene scene = empty(1, 0, 1, 1e-6);
  ball(scene, 0.5, 1, {0, 0, 0}, {1, 2, 0});
  ball(scene, 0.5, 1, {4, 0, 0}, {0, 0, 0.25});
  // Across x and y something moves and the centres differ; across z something only moves.
  const contact::Decision decision = plan_scenes::decision(scene, Effect::third_dimension);
  REQUIRE(decision.on);
  CHECK(contact::scenes::reason_text(decision).find("along z") != std::string::npos);
}

TEST_CASE("to plan a body of a crowd takes no more comparisons in a larger crowd") {
  const auto each = [](int edge) {
    const Scene scene = lattice(edge);
    const contact::SceneBounds bounds = contact::scene_bounds(scene);
    REQUIRE(bounds.crowded);
    CHECK(bounds.floors.size() == 1);
    return static_cast<double>(bounds.compared) / static_cast<double>(bounds.movers);
  };
  const double few = each(8);
  const double many = each(20);
  CHECK(few > 2);  // each with the floor, and with balls beside it
  // In a tree of boxes a search is deeper by the logarithm of their number.
  CHECK(many < 2 * few);
  CHECK(many < 100);
}
