#pragma once

// The options of a command that changes a plan, as typed.

#include <string>

#include <contact/plan/plan_words.hpp>

#include "../command_line.hpp"

namespace contact::cli {

/// Adds --with, --without and --step to a command.
void add_plan_words(Command command, scenes::PlanWords& words);

/// scenes::plan_options(), with its error as that of the command line.
/// @throws grading::UnknownName for an unknown effect, or an invalid step
PlanOptions typed_plan_options(const scenes::PlanWords& words);

/// scenes::require_possible_run(), with its error as that of the command line.
/// @throws grading::UnknownName for a time beyond any use, with what to do
void require_possible_run(double until, double every, const Plan& plan);

/// scenes::seconds_of(), with its error as that of the command line.
/// @throws grading::UnknownName with the option's name and what is allowed
double seconds_of(const std::string& option, const std::string& text, bool zero);

}  // namespace contact::cli
