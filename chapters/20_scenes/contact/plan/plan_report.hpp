/// @file
/// Output of a plan: a table for readers, JSON for programs. Needs nlohmann's json.hpp.
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

/// How long a run agrees with its twin, which starts an ulp away.
struct MeasuredHorizon {
  double time = 0;     ///< of the last comparison, s
  double apart = 0;    ///< largest distance between two positions then, m
  double allowed = 0;  ///< the tolerance, or without one the least radius of moving bodies, m
  /// Whether they have diverged by more than that.
  [[nodiscard]] bool diverged() const { return apart > allowed; }
};

/// The measured cost of one effect: of the run with it switched; for the horizon, of the run beside
/// its twin.
struct MeasuredEffect {
  Effect effect = Effect::gravity;         ///< which
  std::optional<MeasuredHorizon> horizon;  ///< for the horizon, instead of the rest
  bool same_stages = false;       ///< the run has the same stages: there is nothing to measure
  double planned_seconds = 0;     ///< processor time for a second of the scene, as planned
  double other_seconds = 0;       ///< the same with the effect switched
  std::size_t planned_bytes = 0;  ///< of one moving body's state
  std::size_t other_bytes = 0;    ///< the same with the effect switched
};

/// How a table is formatted: a terminal has colours, and a line width.
struct TableStyle {
  /// A change of a text.
  using Change = std::function<std::string(std::string_view)>;
  Change bold;  ///< of a heading
  Change dim;   ///< of the columns' names
  Change good;  ///< of an effect that is off, which costs nothing
  Change warn;  ///< of an effect that is on
  /// A text and its minimum width in columns.
  std::function<std::string(std::string_view, std::size_t)> padded;
  /// A text, the indentation of each line in columns, and the maximum width.
  std::function<std::string(std::string_view, std::size_t, std::size_t)> wrapped;
};

/// A number for readers: four digits, or all if it is whole and short.
std::string plan_number(double x);

/// An inequality with both sides in words: "fall in the whole duration: 44.1 m > 0.01 m (tolerance
/// of a position)". A condition that fails is written with the sign that holds.
std::string inequality_text(const Inequality& condition);

/// The sum of the errors that a plan accepts, beside the tolerance: a sentence.
std::string accepted_text(const Plan& plan);

/// "Measured: 0.52 ms of processor time a second as planned, 0.81 ms with it (1.6 times), ...".
std::string measured_text(const MeasuredEffect& measured, bool on);

/// The table: effect, on or off, what decided, the error accepted, the cost saved.
/// @param measured measured costs of effects; empty if nothing was measured
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
