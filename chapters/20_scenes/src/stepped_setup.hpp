#pragma once

// From a scene and its plan to the data of every step: its stages, and their input.

#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact::detail {

/// A stage, and its name.
struct NamedStage {
  SceneStage is;
  StepStage run = nullptr;
};

/// The stages of each substep, in their order, and those after a step.
struct StepPipeline {
  std::vector<NamedStage> substep;
  std::vector<NamedStage> after;
};

/// The data that do not change during a run.
SteppedSetup stepped_setup(const Scene& scene, const Plan& plan);
/// The stages that the plan's effects need.
StepPipeline step_pipeline(const Plan& plan, const SteppedSetup& setup);

}  // namespace contact::detail
