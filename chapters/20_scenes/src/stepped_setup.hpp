#pragma once

// From a scene and its plan to what every step needs: which stages it has, and what they are given.

#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact::detail {

/// A stage, and what it is called.
struct NamedStage {
  SceneStage is;
  StepStage run = nullptr;
};

/// The stages of each part of a step, in their order, and those after a step.
struct StepPipeline {
  std::vector<NamedStage> part;
  std::vector<NamedStage> after;
};

/// What does not change during a run.
SteppedSetup stepped_setup(const Scene& scene, const Plan& plan);
/// The stages that the plan's effects call for.
StepPipeline step_pipeline(const Plan& plan, const SteppedSetup& setup);

}  // namespace contact::detail
