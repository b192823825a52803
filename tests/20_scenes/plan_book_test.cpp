// The plans of the book's scenes: the effects that each needs and does not need, by what is known
// of the scene, not by what a plan once said.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <filesystem>
#include <string>
#include <vector>

using contact::Decision;
using contact::Effect;
using contact::Plan;
using contact::Scene;

namespace {

std::filesystem::path folder() {
  return std::filesystem::path(CONTACT_SOURCE_DIR) / "chapters" / "20_scenes" / "scenes";
}

Scene scene_of_book(const std::string& name) {
  return contact::scenes::read_scene(folder() / (name + ".json"));
}

/// The effects that a scene needs and does not need, for a reason that a reader can give.
struct Known {
  std::string name;
  std::vector<Effect> on;
  std::vector<Effect> off;
};

const std::vector<Known>& known_scenes() {
  static const std::vector<Known> known{
      // Vertically onto a floor with 4/5 of its speed; the last bounce comes after 4.5 s.
      {"bouncing_ball",
       {Effect::gravity, Effect::restitution, Effect::event_driven},
       {Effect::rotation, Effect::gyroscopic_term, Effect::friction, Effect::resting,
        Effect::sleeping, Effect::several_contacts, Effect::penalty_contact,
        Effect::third_dimension, Effect::second_dimension, Effect::broad_phase, Effect::horizon,
        Effect::step_size}},
      {"high_drop",
       {Effect::gravity, Effect::restitution, Effect::event_driven},
       {Effect::rotation, Effect::resting, Effect::second_dimension, Effect::horizon}},
      // Flat, smooth and elastic: no gravity, no third dimension; sixteen lenses.
      {"billiards_break",
       {Effect::second_dimension, Effect::restitution, Effect::event_driven, Effect::horizon,
        Effect::several_contacts},
       {Effect::gravity, Effect::rotation, Effect::friction, Effect::third_dimension,
        Effect::resting, Effect::penalty_contact}},
      // 15 m in a frame against a wall of 1 cm; all on a line.
      {"bullet_and_wall",
       {Effect::continuous_detection, Effect::restitution, Effect::step_size},
       {Effect::gravity, Effect::rotation, Effect::friction, Effect::second_dimension,
        Effect::event_driven, Effect::resting}},
      // Boxes exactly on top of each other: two mirrors, so nothing slides and nothing rotates.
      {"stack_of_ten",
       {Effect::gravity, Effect::resting, Effect::sleeping, Effect::several_contacts},
       {Effect::rotation, Effect::gyroscopic_term, Effect::friction, Effect::restitution,
        Effect::second_dimension, Effect::event_driven}},
      // Nothing touches anything; a box that turns over.
      {"tennis_racket",
       {Effect::rotation, Effect::gyroscopic_term},
       {Effect::gravity, Effect::friction, Effect::restitution, Effect::continuous_detection,
        Effect::resting, Effect::horizon, Effect::event_driven}},
      {"precessing_plate",
       {Effect::rotation, Effect::gyroscopic_term, Effect::double_precision},
       {Effect::gravity, Effect::event_driven}},
      // They fall side by side, with a tolerance of a millimetre.
      {"hail",
       {Effect::gravity, Effect::event_driven},
       {Effect::rotation, Effect::second_dimension, Effect::double_precision, Effect::broad_phase}},
      // A spring instead of an impact.
      {"penalty_trampoline",
       {Effect::gravity, Effect::penalty_contact, Effect::step_size},
       {Effect::restitution, Effect::resting, Effect::rotation, Effect::second_dimension,
        Effect::event_driven}},
      {"elastic_spheres",
       {Effect::gravity, Effect::restitution, Effect::broad_phase, Effect::third_dimension,
        Effect::event_driven, Effect::horizon, Effect::double_precision},
       {Effect::rotation, Effect::friction, Effect::resting, Effect::sleeping,
        Effect::penalty_contact}},
      {"gas_in_a_box",
       {Effect::restitution, Effect::event_driven, Effect::horizon},
       {Effect::gravity, Effect::rotation, Effect::friction, Effect::resting}},
      // Friction rotates ten thousand balls that come to rest.
      {"ball_pit",
       {Effect::gravity, Effect::rotation, Effect::friction, Effect::restitution,
        Effect::broad_phase, Effect::several_contacts, Effect::resting, Effect::sleeping},
       {Effect::gyroscopic_term, Effect::penalty_contact, Effect::event_driven}},
      // Two balls on a line meet once.
      {"head_on",
       {Effect::restitution, Effect::event_driven},
       {Effect::gravity, Effect::second_dimension, Effect::several_contacts, Effect::horizon}},
      // Both hits fall on one instant, and the two that are hit touch each other.
      {"three_at_once",
       {Effect::several_contacts, Effect::restitution, Effect::step_size},
       {Effect::gravity, Effect::rotation, Effect::event_driven, Effect::third_dimension}},
      {"truck_and_car", {}, {Effect::gravity, Effect::restitution, Effect::rotation}},
      // All in the plane of the row.
      {"dominoes",
       {Effect::rotation, Effect::friction, Effect::second_dimension},
       {Effect::third_dimension, Effect::gyroscopic_term, Effect::event_driven}},
      {"sliding_block", {Effect::gravity, Effect::friction}, {Effect::third_dimension}},
      {"sliding_then_rolling",
       {Effect::gravity, Effect::friction, Effect::rotation},
       {Effect::third_dimension, Effect::gyroscopic_term}},
      // It lands after the scene's end. A regular tetrahedron's moments of inertia are equal.
      {"thrown_stone",
       {Effect::gravity, Effect::rotation, Effect::event_driven, Effect::double_precision},
       {Effect::gyroscopic_term, Effect::friction, Effect::restitution,
        Effect::continuous_detection, Effect::resting}},
  };
  return known;
}

}  // namespace

TEST_CASE("the book's scenes need the effects that are known of them") {
  for (const Known& known : known_scenes()) {
    const Plan plan = contact::plan_scene(scene_of_book(known.name));
    for (const Effect effect : known.on) {
      INFO(known.name << ": " << contact::effect_name(effect));
      CHECK(contact::decision_on(plan, effect).on);
    }
    for (const Effect effect : known.off) {
      INFO(known.name << ": " << contact::effect_name(effect) << ": "
                      << contact::decision_on(plan, effect).why);
      CHECK_FALSE(contact::decision_on(plan, effect).on);
    }
  }
}

TEST_CASE("every scene of the book has a plan whose proofs hold") {
  for (const auto& file : contact::scenes::scenes_in(folder())) {
    INFO(file.filename().string());
    const Scene scene = contact::scenes::read_scene(file);
    const Plan plan = contact::plan_scene(scene);
    REQUIRE(plan.decisions.size() == contact::all_effects.size());
    for (const Decision& decision : plan.decisions) {
      INFO(contact::effect_name(decision.effect));
      if (decision.effect == Effect::event_driven) {
        CHECK(decision.on == decision.proven);
      } else if (contact::can_be_switched(decision.effect)) {
        CHECK(decision.on == !decision.proven);
      }
      for (const auto& condition : decision.because) {
        if (decision.proven) CHECK(contact::holds(condition));
        CHECK_FALSE(condition.left_is.empty());
        CHECK_FALSE(condition.right_is.empty());
      }
      // The error accepted is never more than the scene's tolerance. Resting, sleeping, and a
      // crowd's steps may have no bound; then the plan says so.
      if (!std::isfinite(decision.error)) {
        CHECK((decision.effect == Effect::resting || decision.effect == Effect::sleeping ||
               decision.effect == Effect::step_size));
        CHECK(std::isinf(plan.error));
      } else
        CHECK(decision.error <= scene.tolerance.position.value_or(0));
    }
    CHECK((plan.step > 0) == !contact::decision_on(plan, Effect::event_driven).on);
  }
}

TEST_CASE("a bullet in steps of a frame tunnels through its wall, and the plan says by how much") {
  const Scene scene = scene_of_book("bullet_and_wall");
  contact::PlanOptions options;
  options.step = 1.0 / 60;
  const Plan plan = contact::plan_scene(scene, options);
  const Decision& decision = contact::decision_on(plan, Effect::continuous_detection);
  CHECK(decision.on);
  const auto& passing = decision.because.at(0);
  CHECK(passing.left >= 900.0 / 60);
  CHECK(passing.left <= 900.0 / 60 * (1 + 1e-9));
  CHECK(passing.right <= 2 * (0.005 + 0.004));
  CHECK_FALSE(contact::holds(passing));
}
