/// @file
/// From a scene and its plan to the run that simulates it.
#pragma once

#include <memory>

#include <contact/hard_sphere_scene_run.hpp>
#include <contact/plan_types.hpp>
#include <contact/scene.hpp>
#include <contact/scene_run.hpp>
#include <contact/stepped_run.hpp>

namespace contact {

// [make-scene-run]
/// The run that a plan decides on: from event to event where the plan says so and the scene is one
/// of hard, smooth balls; step by step otherwise, with the stages that are on.
/// @param scene checked; what names and shapes it has, its run keeps
/// @param plan as plan_scene() makes it, overrides included
/// @param compose what makes a run of hard balls
/// @throws std::invalid_argument with what stepped_refusal() says, if neither can run it
inline std::unique_ptr<SceneRun> make_scene_run(const Scene& scene, const Plan& plan,
                                                ComposeHardSpheres compose) {
  if (decision_on(plan, Effect::event_driven).on && !hard_sphere_refusal(scene))
    return std::make_unique<HardSphereSceneRun>(scene, compose);
  return make_stepped_run(scene, plan);
}
// [/make-scene-run]

}  // namespace contact
