#pragma once

// The options of a command that changes a plan, and what was typed for them.

#include <string>

#include <contact/plan/plan_words.hpp>

#include "../command_line.hpp"

namespace contact::cli {

/// Adds --with, --without and --step to a command.
void add_plan_words(Command command, scenes::PlanWords& words);

/// scenes::plan_options(), whose error is that of the command line.
/// @throws grading::UnknownName for an effect that is none, or a step that is none
PlanOptions typed_plan_options(const scenes::PlanWords& words);

/// scenes::seconds_of(), whose error is that of the command line.
/// @throws grading::UnknownName that names the option and what it may be
double seconds_of(const std::string& option, const std::string& text, bool zero);

}  // namespace contact::cli
