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

/// A condition as a short sentence that is true of the scene, whether the condition holds or fails:
/// "gravity along z is 10 m/s²", "no gravity along z". A condition of unknown words is said by
/// these.
std::string condition_text(const Inequality& condition);

/// The same with both sides in words where two numbers are compared: "fall in the whole duration:
/// 44.1 m > 0.01 m (tolerance of a position)". A condition that fails is written with the sign that
/// holds.
std::string inequality_text(const Inequality& condition);

/// What decided, in a few words: of an effect that is off the theorem or one number of its proof,
/// of an effect that is on what the proof lacks that lacks least.
std::string reason_text(const Decision& decision);

/// The sum of the errors that a plan accepts, beside the tolerance: a sentence.
std::string accepted_text(const Plan& plan);

/// "Measured: 0.52 ms of processor time a second as planned, 0.81 ms with it (1.6 times), ...".
std::string measured_text(const MeasuredEffect& measured, bool on);

/// The summary: a line for each effect with on or off, what decided, and the error accepted. At
/// most 25 lines of 80 columns; what does not fit is cut, and ends with an ellipsis.
std::string plan_summary(const Scene& scene, const Plan& plan, const TableStyle& style);

/// The long form, in 80 columns: for each effect on or off, the theorem, its conditions with their
/// numbers, the error accepted, the cost saved.
/// @param measured measured costs of effects; empty if nothing was measured
/// @param only the one effect to explain; empty: all, with the plan's notices
std::string plan_text(const Scene& scene, const Plan& plan,
                      const std::vector<MeasuredEffect>& measured, const TableStyle& style,
                      std::optional<Effect> only = std::nullopt);

/// The same as JSON, contact-plan/1. Numbers that are infinite are null.
nlohmann::json plan_json(const Scene& scene, const Plan& plan,
                         const std::vector<MeasuredEffect>& measured = {});

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_json.cpp"
#include "../../src/plan_phrases.cpp"
#include "../../src/plan_text.cpp"
#endif
