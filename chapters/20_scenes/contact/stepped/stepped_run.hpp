/// @file
/// A scene step by step: a pipeline of stages, composed from a plan. It has no stage of an effect
/// that is off.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact {

/// Why a scene cannot be run step by step, or empty if it can: today every checked scene can,
/// because all pairs of shapes have a narrow phase.
/// @param plan of the scene
std::optional<std::string> stepped_refusal(const Scene& scene, const Plan& plan);

namespace detail {

inline bool is_on(const Plan& plan, Effect effect) { return decision_on(plan, effect).on; }

}  // namespace detail

/// The stepped run of a scene.
/// @param plan of the scene; if it is event-driven, a step is a frame
/// @throws std::invalid_argument with what stepped_refusal() says
std::unique_ptr<SceneRun> make_stepped_run(const Scene& scene, const Plan& plan);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stepped_run.cpp"
#include "../../src/stepped_setup.cpp"
#endif
