#pragma once

// How a plan is printed: as a table for readers, as JSON for programs.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <contact/plan/plan.hpp>
#include <contact/scene/scene.hpp>

#include "plan_measure.hpp"
#include "terminal.hpp"

namespace contact::cli {

/// A number with as many digits as a reader wants: four, or all if it is whole and short.
std::string plan_number(double x);

/// An inequality with both sides in words: "fall in the whole duration: 44.1 m > 0.01 m (tolerance
/// of a place)". A condition that fails is written with the sign that holds.
std::string inequality_text(const Inequality& condition);

/// The sum of the errors that a plan accepts, beside the tolerance: a sentence.
std::string accepted_text(const Plan& plan);

/// The table: effect, on or off, what decided, the error accepted, the cost saved.
/// @param measured what effects cost; empty if nobody asked
std::string plan_text(const Scene& scene, const Plan& plan,
                      const std::vector<MeasuredEffect>& measured, const Style& style);

/// The same as JSON, contact-plan/1. Numbers that are infinite are null.
nlohmann::json plan_json(const Scene& scene, const Plan& plan,
                         const std::vector<MeasuredEffect>& measured = {});

}  // namespace contact::cli
