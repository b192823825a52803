/// @file
/// Runs of scenes with any composition of hard balls. Without the chapter's library all of these
/// are compiled here, which takes a minute: link it, or pass to make_scene_run() those that you
/// need.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include <contact/events/hard_sphere_run.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact::scenes {

/// make_scene_run() with make_hard_spheres().
std::unique_ptr<SceneRun> make_run(
    const Scene& scene, const Plan& plan,
    std::uint64_t event_budget = std::numeric_limits<std::uint64_t>::max());

/// The effects of which a run of hard balls is composed; empty if it goes step by step.
std::optional<HardSphereEffects> hard_sphere_effects(const SceneRun& run);

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/scene_runs.cpp"
#endif
