#pragma once

// The run of the page's scene player. In a file of its own, because runs are compiled for speed,
// and reading and reporting for size.

#include <memory>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact::scenes {

/// The run that a plan decides on, with the least composition.
/// @throws std::invalid_argument if neither kind of run is possible
std::unique_ptr<SceneRun> player_run(const Scene& scene, const Plan& plan);

}  // namespace contact::scenes
