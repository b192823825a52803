/// @file
/// How a plan is told: as a table for readers, as JSON for programs. Needs nlohmann's json.hpp.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <nlohmann/json.hpp>

namespace contact::scenes {

/// How long a run stays with its twin, which begins an ulp away.
struct MeasuredHorizon {
  double time = 0;     ///< when they were last compared, s
  double apart = 0;    ///< how far the farthest two places were apart then, m
  double allowed = 0;  ///< the tolerance, or without one the least radius of what moves, m
  /// Whether they are farther apart than that.
  [[nodiscard]] bool parted() const { return apart > allowed; }
};

/// What one effect costs, measured by a run with it the other way round; of the horizon, the run
/// beside its twin.
struct MeasuredEffect {
  Effect effect = Effect::gravity;         ///< which
  std::optional<MeasuredHorizon> horizon;  ///< nothing more is measured then
  bool same_stages = false;       ///< the run is composed alike: there is nothing to measure
  std::string refused;            ///< why there is no such run; empty if there is one
  double planned_seconds = 0;     ///< of the processor for a second of the scene, as planned
  double other_seconds = 0;       ///< the same the other way round
  std::size_t planned_bytes = 0;  ///< of one moving body's state
  std::size_t other_bytes = 0;    ///< the same the other way round
};

/// How a table is set: a terminal has colours, and lines of a width.
struct TableStyle {
  /// What is made of a text.
  using Change = std::function<std::string(std::string_view)>;
  Change bold;  ///< of a heading
  Change dim;   ///< of the columns' names
  Change good;  ///< of an effect that is off, which costs nothing
  Change warn;  ///< of an effect that is on
  /// A text and how many columns it has at least.
  std::function<std::string(std::string_view, std::size_t)> padded;
  /// A text, by how many columns each of its lines is indented, and how wide lines are at most.
  std::function<std::string(std::string_view, std::size_t, std::size_t)> wrapped;
};

/// A number with as many digits as a reader wants: four, or all if it is whole and short.
std::string plan_number(double x);

/// An inequality with both sides in words: "fall in the whole duration: 44.1 m > 0.01 m (tolerance
/// of a place)". A condition that fails is written with the sign that holds.
std::string inequality_text(const Inequality& condition);

/// The sum of the errors that a plan accepts, beside the tolerance: a sentence.
std::string accepted_text(const Plan& plan);

/// "Measured: 0.52 ms a second as planned, 0.81 ms with it (1.6 times), ...".
std::string measured_text(const MeasuredEffect& measured, bool on);

/// The table: effect, on or off, what decided, the error accepted, the cost saved.
/// @param measured what effects cost; empty if nothing was measured
std::string plan_text(const Scene& scene, const Plan& plan,
                      const std::vector<MeasuredEffect>& measured, const TableStyle& style);

/// The same as JSON, contact-plan/1. Numbers that are infinite are null.
nlohmann::json plan_json(const Scene& scene, const Plan& plan,
                         const std::vector<MeasuredEffect>& measured = {});

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_json.cpp"
#include "../../src/plan_text.cpp"
#endif
