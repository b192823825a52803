#pragma once

// What a command line says of a plan: a step, and effects that are forced on or off.

#include <string>
#include <vector>

#include <contact/plan/plan_types.hpp>

#include "command_line.hpp"

namespace contact::cli {

/// As typed.
struct PlanWords {
  std::vector<std::string> with;
  std::vector<std::string> without;
  std::string step;  ///< s; empty: the plan's
};

/// Adds --with, --without and --step to a command.
void add_plan_words(Command command, PlanWords& words);

/// What they ask for.
/// @throws grading::UnknownName for an effect that is none, or a step that is none
PlanOptions plan_options(const PlanWords& words);

/// A number of seconds as typed after an option.
/// @param zero whether 0 is one
/// @throws grading::UnknownName that names the option and what it may be
double seconds_of(const std::string& option, const std::string& text, bool zero);

}  // namespace contact::cli
