// What a plan says where its answer is one of several, or an estimate: the scenes in which it once
// said "proven" or "on the safe side", with their numbers.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_runs.hpp>
#include <string>

#include "plan_scenes.hpp"

using contact::Decision;
using contact::Effect;
using contact::Plan;
using contact::PlanOptions;
using contact::Scene;
using plan_scenes::ball;
using plan_scenes::decision;
using plan_scenes::empty;
using plan_scenes::Point;

namespace {

/// Five balls, of which four touch in a row; the fifth comes with 1 m/s after `gap` metres.
Scene cradle(double between) {
  Scene scene = empty(1, 0, 2, 1e-9);
  scene.gravity.setZero();
  ball(scene, 0.5, 1, {-1, 0, 0}, {1, 0, 0});
  for (int k = 1; k <= 4; ++k) ball(scene, 0.5, 1, {k + (k - 1) * between, 0, 0});
  return scene;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// The notice on until when the tolerance holds.
std::string notice_of(const Plan& plan) {
  for (const std::string& notice : plan.notices)
    if (notice.starts_with("The tolerance holds up to")) return notice;
  return {};
}

void velocities_are(const Scene& scene, const PlanOptions& options,
                    const std::array<double, 5>& right) {
  const auto run = plan_scenes::run_of(scene, options);
  run->advance(scene.duration);
  for (std::size_t k = 0; k < 5; ++k) {
    CAPTURE(k);
    CHECK(std::abs(run->velocity(k).x() - right[k]) <= 1e-9);
  }
}

}  // namespace

TEST_CASE("hypotheses: a cradle of touching balls has two answers, and the decision says which") {
  const Scene scene = cradle(0);
  const Decision several = decision(scene, Effect::several_contacts);
  const Decision events = decision(scene, Effect::event_driven);
  CHECK_FALSE(events.on);
  CHECK(says(several.why, "one impulse for all contacts at once"));
  CHECK(says(several.why, "may depend on that"));
  CHECK(says(events.why, "an order that the scene does not give"));
  velocities_are(scene, {}, {-0.6, 0.4, 0.4, 0.4, 0.4});

  PlanOptions forced;
  forced.overrides.with = {Effect::event_driven};
  CHECK(says(decision(scene, Effect::several_contacts, forced).why,
             "one after the other, in an order that the scene does not give"));
  velocities_are(scene, forced, {0, 0, 0, 0, 1});
}

TEST_CASE("hypotheses: a cradle with gaps has one answer, and no decision speaks of an order") {
  const Scene scene = cradle(0.25);
  CHECK_FALSE(says(decision(scene, Effect::several_contacts).why, "order"));
  CHECK_FALSE(says(decision(scene, Effect::event_driven).why, "order"));
  velocities_are(scene, {}, {0, 0, 0, 0, 1});
}

TEST_CASE("hypotheses: a ball that reaches two at the same instant is one of several answers") {
  Scene scene = empty(1, 0, 4, 1e-9);
  scene.gravity.setZero();
  ball(scene, 0.5, 1, {-3, 0, 0}, {1, 0, 0});
  ball(scene, 0.5, 1, {0, 0.75, 0});
  ball(scene, 0.5, 1, {0, -0.75, 0});
  CHECK(says(decision(scene, Effect::several_contacts).why, "order"));
  scene.bodies[1].position.x() = 0.25;
  CHECK_FALSE(says(decision(scene, Effect::several_contacts).why, "order"));
}

TEST_CASE("hypotheses: only for two balls that meet once the horizon is called a bound") {
  Scene two = empty(1, 0, 1000, 1e-9);
  two.gravity.setZero();
  ball(two, 0.5, 0, Point::Zero());
  ball(two, 0.5, 1, {-2, 1 - 4 * 0x1p-53, 0}, {1, 0, 0});
  CHECK(says(notice_of(contact::plan_scene(two)), "by a bound"));
  ball(two, 0.5, 0, {20, 3, 0});
  const std::string several = notice_of(contact::plan_scene(two));
  CHECK(says(several, "by an estimate for typical hits, not a bound"));
  CHECK_FALSE(says(several, "safe side"));
}
