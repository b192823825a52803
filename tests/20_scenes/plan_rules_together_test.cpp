// Rules in combination: errors share one tolerance, an override has the last word, and every effect
// has a decision.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_costs.hpp>
#include <limits>
#include <string>
#include <vector>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Scene;
using oracle::exact;
using oracle::Rational;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::only_lacks;
using plan_scenes::Point;
using plan_scenes::stepped;
using plan_scenes::table;
using plan_scenes::wall;

namespace {

/// A box that tumbles a little and falls a little, far from everything.
Scene tumbling_fall(double tolerance) {
  Scene scene = empty(1, 0, 0.5, tolerance);
  scene.gravity = {0, 0, -0x1p-10};
  box(scene, {1, 2, 3}, 1, {3, 2, 1}, {1, 0, 0}).angular_velocity = {0.00125, 0.0025, 0.00375};
  return scene;
}

/// The bounds of its three errors: gyroscopic, fall, rounding in float.
std::array<double, 3> errors_of_fall() {
  const contact::Plan plan = contact::plan_scene(tumbling_fall(1));
  return {contact::decision_on(plan, Effect::gyroscopic_term).error,
          contact::decision_on(plan, Effect::gravity).error,
          contact::decision_on(plan, Effect::double_precision).error};
}

}  // namespace

TEST_CASE(
    "the tolerance holds for the sum of all errors: each rule takes from the rest of the budget") {
  const auto [aside, fall, rounding] = errors_of_fall();
  REQUIRE(rounding < aside);
  REQUIRE(aside < fall);
  const auto left_out = [&](double tolerance) {
    const contact::Plan plan = contact::plan_scene(tumbling_fall(tolerance));
    CHECK(plan.tolerance == tolerance);
    CHECK(plan.error <= tolerance);
    std::vector<Effect> effects;
    Rational sum = 0;
    for (const Decision& decision : plan.decisions) {
      if (!(decision.error > 0)) continue;
      effects.push_back(decision.effect);
      sum += exact(decision.error);
    }
    CHECK(sum <= exact(tolerance));
    CHECK(abs(sum - exact(plan.error)) <= exact(plan.error * 0x1p-50));
    return effects;
  };
  using Effects = std::vector<Effect>;
  const double little = 1e-12;
  CHECK(left_out((aside + fall + rounding) * (1 + little)) ==
        Effects{Effect::gravity, Effect::gyroscopic_term, Effect::double_precision});
  // Each fits by itself, and any two, but not all three: float was considered last.
  CHECK(left_out((aside + fall + rounding) * (1 - little)) ==
        Effects{Effect::gravity, Effect::gyroscopic_term});
  // The rest after the gyroscopic term is less than the fall, and enough for float.
  CHECK(left_out((aside + fall) * (1 - little)) ==
        Effects{Effect::gyroscopic_term, Effect::double_precision});
  CHECK(left_out((aside + rounding) * (1 - little)) == Effects{Effect::gyroscopic_term});
  // Where an angular velocity changes float has no bound.
  CHECK(left_out(aside * (1 - little)).empty());
  const Decision gravity =
      plan_scenes::decision(tumbling_fall((aside + fall) * (1 - little)), Effect::gravity);
  CHECK(gravity.tried.back().conditions.at(1).right_is == "rest of the error budget");
  CHECK(only_lacks(gravity, gravity.tried.size() - 1, 1));
}

TEST_CASE("the errors of a run in steps share the tolerance: bounces a half, sleep a half") {
  Scene scene = dropped(0.5, 2, 10, 1e-4);
  scene.materials[0].friction = 0.5;
  scene.bodies[1].velocity.x() = 1;
  const contact::Plan plan = contact::plan_scene(scene);
  const Decision& resting = contact::decision_on(plan, Effect::resting);
  const Decision& sleeping = contact::decision_on(plan, Effect::sleeping);
  REQUIRE(resting.on);
  REQUIRE(sleeping.on);
  // Bounces of half the tolerance are left out: a rebound at e v rises e² of that.
  CHECK(plan.rest_height == 0.5e-4);
  CHECK(contact::holds(resting.because.back()));
  CHECK(std::abs(resting.because.back().left / 0.125e-4 - 1) <= 1e-12);
  CHECK(std::abs(plan.sleep_speed * 10 * 10 / 0.5 / 0.5e-4 - 1) <= 1e-12);
  // The ball has friction while it lies, so its path depends on when it lies: no number is a bound.
  CHECK(std::isinf(resting.error));
  CHECK(std::isinf(sleeping.error));
  CHECK(std::isinf(plan.error));
  // Smooth, it moves along its floor as if it bounced.
  Scene smooth = scene;
  smooth.materials[0].friction = 0;
  const contact::Plan gliding = contact::plan_scene(smooth, stepped(0.01));
  CHECK(contact::decision_on(gliding, Effect::resting).error == resting.because.back().left);
  CHECK(contact::decision_on(gliding, Effect::sleeping).error == 0.5e-4);
  CHECK(gliding.error > 0.6e-4);
  CHECK(gliding.error <= 1e-4);
  // A step is shorter than that bounce: then bounces that fit into one are left out, g h²/8 high.
  const contact::Plan fine = contact::plan_scene(smooth, stepped(1e-4));
  CHECK(std::abs(contact::decision_on(fine, Effect::resting).error / 0.25e-8 - 1) <= 1e-12);
  // No rebound, so no bounce.
  scene.materials[0].restitution = 0;
  CHECK(plan_scenes::decision(scene, Effect::resting).error == 0);
  // A body that never rests bounces however slow it is.
  CHECK(contact::plan_scene(dropped(1, 2, 3), stepped(0.01)).rest_height == 0);
  // No position error is allowed: bounces that rounding hides, and no sleep of moving bodies.
  scene = dropped(0.5, 2, 10, 0);
  scene.materials[0].friction = 0.5;
  const contact::Plan strict = contact::plan_scene(scene);
  CHECK(strict.error == 0);
  CHECK(strict.sleep_speed == 0);
  CHECK(strict.rest_height > 0);
  CHECK(strict.rest_height <= 2.5 * 0x1p-53 * (1 + 1e-12));
}

TEST_CASE(
    "bounces that steps leave out have a bound where a smooth ball lies alone, and only there") {
  const auto error = [](const Scene& scene) {
    return plan_scenes::decision(scene, Effect::resting, stepped(0.01)).error;
  };
  const auto sleeping = [](const Scene& scene) {
    return plan_scenes::decision(scene, Effect::sleeping, stepped(0.01)).error;
  };
  const double endless = std::numeric_limits<double>::infinity();
  const Scene alone = dropped(0.5, 2, 10, 1e-4);
  const double bounce = error(alone);
  CHECK(bounce > 0);
  CHECK(bounce <= 0.125e-4 * (1 + 1e-12));
  // A wall perpendicular to the floor, however the ball hits it, changes nothing along the floor's
  // normal.
  Scene walled = alone;
  wall(walled, Point::UnitX(), -5);
  CHECK(error(walled) == bounce);
  CHECK(sleeping(walled) == 0.5e-4);
  // Obliquely it does, from below as from above; so does a rough one, and a second ball.
  for (const Point& slant : {Point(0.6, 0, 0.8), Point(0.6, 0, -0.8)}) {
    Scene wedge = alone;
    wall(wedge, slant, -5);
    CHECK(error(wedge) == endless);
    CHECK(sleeping(wedge) == endless);
  }
  Scene rough = walled;
  rough.materials[0].friction = 0.5;
  CHECK(error(rough) == endless);
  Scene two = alone;
  ball(two, 0.5, 1, {3, 0, 2}, {-1, 0, 0});
  CHECK(error(two) == endless);
  CHECK(std::isinf(contact::plan_scene(two, stepped(0.01)).error));
  // Without a floor nothing lies on anything: nothing is left out, and nothing sleeps.
  Scene falling = two;
  falling.bodies.erase(falling.bodies.begin());
  ball(falling, 0.5, 1, {-3, 0, 2}, {1, 0, 0});
  const auto plan = contact::plan_scene(falling, stepped(0.01));
  CHECK(contact::decision_on(plan, Effect::resting).on);
  CHECK(plan.rest_height == 0);
  CHECK(plan.sleep_speed == 0);
  CHECK(plan.error == 0);
  // Nor between vertical walls.
  Scene shaft = alone;
  std::get<contact::HalfSpaceShape>(shaft.bodies[0].shape) = {Point::UnitX(), -5};
  CHECK(error(shaft) == 0);
}

TEST_CASE("an override changes the sum: none is accepted, or there is no bound") {
  const auto [aside, fall, rounding] = errors_of_fall();
  const Scene scene = tumbling_fall(1);
  contact::PlanOptions options;
  options.overrides.with = {Effect::gravity};
  const double rest = contact::plan_scene(scene, options).error;
  CHECK(std::abs(rest - (aside + rounding)) <= 0x1p-50 * rest);
  options.overrides.with.clear();
  options.overrides.without = {Effect::rotation};
  CHECK(std::isinf(contact::plan_scene(scene, options).error));
  // To leave bodies awake, or to go in steps, makes no error.
  options.overrides.without = {Effect::sleeping, Effect::event_driven, Effect::broad_phase};
  CHECK(contact::plan_scene(scene, options).error <= 1);
}

TEST_CASE("an override has the last word, and both are kept") {
  contact::PlanOptions options;
  options.overrides.with = {Effect::rotation};
  options.overrides.without = {Effect::gravity};
  const contact::Plan plan = contact::plan_scene(dropped(0.5, 2, 3), options);
  const Decision& rotation = contact::decision_on(plan, Effect::rotation);
  CHECK(rotation.on);
  CHECK_FALSE(rotation.planned);
  CHECK(rotation.overridden);
  const Decision& gravity = contact::decision_on(plan, Effect::gravity);
  CHECK_FALSE(gravity.on);
  CHECK(gravity.planned);
  bool said = false;
  for (const std::string& notice : plan.notices)
    said = said || notice.find("Without gravity") != std::string::npos;
  CHECK(said);
  CHECK_FALSE(contact::decision_on(plan, Effect::friction).overridden);

  options.overrides.with = {Effect::horizon};
  CHECK_THROWS_AS(contact::plan_scene(dropped(0.5, 2, 3), options), std::invalid_argument);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(contact::plan_scene(dropped(0.5, 2, 3), stepped(bad)), std::invalid_argument);
}

TEST_CASE("an override that changes nothing in the run is reported") {
  const auto told = [](const Scene& scene, const contact::PlanOptions& options) {
    std::string all;
    for (const std::string& notice : contact::plan_scene(scene, options).notices) all += notice;
    return all;
  };
  const auto idle = "Forced, but changes nothing in this run: ";
  contact::PlanOptions without;
  without.overrides.without = {Effect::continuous_detection};
  CHECK(told(table(), without).starts_with(idle + std::string("continuous-detection. Without")));
  CHECK(told(table(), without).find("no bound") == std::string::npos);
  contact::PlanOptions with;
  with.overrides.with = {Effect::rotation, Effect::third_dimension};
  CHECK(told(table(), with).starts_with(idle + std::string("rotation, third-dimension. ")));
  // In steps these are stages, or coordinates.
  with.step = without.step = 0.01;
  CHECK(told(table(), with).find(idle) == std::string::npos);
  CHECK(told(table(), without).find(idle) == std::string::npos);
  contact::PlanOptions in_float;
  in_float.step = 0.01;
  in_float.overrides.without = {Effect::double_precision};
  CHECK(told(table(), in_float).find(idle + std::string("double-precision.")) != std::string::npos);
}

TEST_CASE("every effect has a decision in its position, and a name that leads back to it") {
  const contact::Plan plan = contact::plan_scene(table());
  REQUIRE(plan.decisions.size() == contact::all_effects.size());
  for (std::size_t i = 0; i < plan.decisions.size(); ++i) {
    CHECK(plan.decisions[i].effect == contact::all_effects[i]);
    CHECK(contact::effect_named(contact::effect_name(plan.decisions[i].effect)) ==
          plan.decisions[i].effect);
    CHECK_FALSE(plan.decisions[i].why.empty());
    for (const auto& condition : plan.decisions[i].because) {
      CHECK_FALSE(condition.left_is.empty());
      CHECK_FALSE(condition.right_is.empty());
    }
  }
  CHECK_FALSE(contact::effect_named("gravitas"));
}

TEST_CASE("a scene in which nothing moves needs nothing") {
  Scene scene = empty(0.5, 0.5, 1, 1e-6);
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), 0);
  const contact::Plan plan = contact::plan_scene(scene);
  for (const Decision& decision : plan.decisions) {
    if (decision.effect == Effect::event_driven) continue;
    INFO(contact::effect_name(decision.effect));
    CHECK_FALSE(decision.on);
  }
}

TEST_CASE("a tolerance of the order of events allows no error of a position") {
  // The second one lands a hundredth of a second earlier, in the same step.
  Scene scene = plan_scenes::empty(1, 0.5, 0.6, 0.5);
  scene.gravity = {0, 0, -9.8125};
  plan_scenes::wall(scene, {0, 0, 1}, 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 1.03125}, {1, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {1000, 0, 1}, {1, 0, 0});
  REQUIRE_FALSE(plan_scenes::is_on(scene, Effect::continuous_detection));
  scene.tolerance.event_order = true;
  CHECK(plan_scenes::is_on(scene, Effect::continuous_detection));
}
