/// @file
/// A scene step by step: a pipeline of stages, composed from a plan. It has no stage of an effect
/// that is off.
#pragma once

#include <memory>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact {

namespace detail {

inline bool is_on(const Plan& plan, Effect effect) { return decision_on(plan, effect).on; }

}  // namespace detail

/// The stepped run of a scene. Every checked scene has one: all pairs of shapes have a narrow
/// phase.
/// @param plan of the scene; if it is event-driven, a step is a frame
std::unique_ptr<SceneRun> make_stepped_run(const Scene& scene, const Plan& plan);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stepped_run.cpp"
#include "../../src/stepped_setup.cpp"
#endif
