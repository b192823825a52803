/// @file
/// Scenes at the edge of a rule: one condition of a proof fails, and no other.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <contact/plan/plan.hpp>
#include <limits>
#include <vector>

#include "plan_scenes.hpp"
#include "support/oracle.hpp"

namespace plan_scenes {

using contact::Decision;
using contact::Proof;

/// No number is a bound.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The smallest positive number.
inline constexpr double least = std::numeric_limits<double>::denorm_min();

/// Where a free ball of a scene is after a time, exactly.
inline oracle::Vector flight(const Scene& scene, std::size_t i, const oracle::Rational& t) {
  const auto& body = scene.bodies[i];
  return oracle::ballistic(oracle::exact(body.position), oracle::exact(body.velocity),
                           oracle::exact(scene.gravity), t);
}

inline contact::PlanOptions stepped(double h) {
  contact::PlanOptions options;
  options.step = h;
  return options;
}

/// Whether the proof of a rule holds but for one condition, and so would hold if that one were
/// weakened.
inline bool only_lacks(const Decision& decision, std::size_t proof, std::size_t condition) {
  const Proof& tried = decision.tried.at(proof);
  for (std::size_t k = 0; k < tried.conditions.size(); ++k) {
    const auto& one = tried.conditions[k];
    INFO(one.left_is << ": " << one.left << " against " << one.right << ", " << one.right_is);
    CHECK(contact::holds(one) == (k != condition));
    if (contact::holds(one) != (k != condition)) return false;
  }
  return condition < tried.conditions.size();
}

/// The decision of the rule with one condition left out of one proof.
inline Decision weakened(const Decision& decision, std::size_t proof, std::size_t condition) {
  std::vector<Proof> proofs = decision.tried;
  auto& conditions = proofs.at(proof).conditions;
  conditions[condition].relation = contact::Relation::at_most;
  conditions[condition].right = std::numeric_limits<double>::infinity();
  return contact::decide(decision.effect, proofs, "");
}

/// Holds a scene at an edge: the effect stays, and would go if the condition were weaker.
inline void at_edge(const Scene& scene, Effect effect, std::size_t proof, std::size_t condition,
                    const contact::PlanOptions& options = {}) {
  INFO("effect " << contact::effect_name(effect) << ", proof " << proof << ", condition "
                 << condition);
  const Decision made = decision(scene, effect, options);
  const bool safe = effect != Effect::event_driven;
  CHECK(made.on == safe);
  CHECK_FALSE(made.proven);
  REQUIRE(proof < made.tried.size());
  CHECK(only_lacks(made, proof, condition));
  CHECK(weakened(made, proof, condition).proven);
}

inline void off(const Scene& scene, Effect effect, const contact::PlanOptions& options = {}) {
  INFO("effect " << contact::effect_name(effect));
  const Decision made = decision(scene, effect, options);
  CHECK(made.proven);
  CHECK(made.on == (effect == Effect::event_driven));
  for (const auto& condition : made.because) CHECK(contact::holds(condition));
}

inline Scene free_ball(double g, double duration, double tolerance) {
  Scene scene = empty(1, 0, duration, tolerance);
  scene.gravity = {0, 0, -g};
  ball(scene, 0.5, 1, Point::Zero(), {1, 2, 0});
  return scene;
}

/// Balls of radius ½ on a level table, side by side and moving.
inline Scene table(double friction = 0) {
  Scene scene = empty(1, friction, 2, 1e-6);
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), 0);
  ball(scene, 0.5, 1, {0, 0, 0.5}, {1, 0.25, 0});
  ball(scene, 0.5, 1, {2, 0, 0.5});
  return scene;
}

inline Scene dropped(double e, double height, double duration, double tolerance = 1e-6) {
  Scene scene = empty(e, 0, duration, tolerance);
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), 0);
  ball(scene, 0.5, 1, {0, 0, 0.5 + height});
  return scene;
}

/// More balls than are tested one by one, in rows of `row`, in the plane of x and y; the last moves
/// back towards the one before it.
inline Scene crowd(int row) {
  Scene scene = empty(1, 0, 0.5, 1e-6);
  for (int i = 0; i < 300; ++i) ball(scene, 0.25, 1, {1.0 * (i % row), 1.0 * (i / row), 0});
  scene.bodies.back().velocity.x() = -2;
  return scene;
}

/// The largest error of late or missed hits, by the rule on continuous detection.
inline double said_of_late_hits(const Scene& scene, double step) {
  return decision(scene, Effect::continuous_detection, stepped(step))
      .tried.at(1)
      .conditions.at(1)
      .left;
}

}  // namespace plan_scenes
