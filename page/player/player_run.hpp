#pragma once

// The run of the page's scene player. Apart from the rest, because a run is compiled for speed, and
// what reads and tells for size.

#include <memory>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact::scenes {

/// The run that a plan decides on, with the least composition.
/// @throws std::invalid_argument if nothing can run it
std::unique_ptr<SceneRun> player_run(const Scene& scene, const Plan& plan);

}  // namespace contact::scenes
