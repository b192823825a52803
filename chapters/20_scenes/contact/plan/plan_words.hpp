/// @file
/// Options of a command that change a plan: a step, and effects that are forced on or off.
#pragma once

#include <string>
#include <vector>

#include <contact/plan/plan_types.hpp>

namespace contact::scenes {

/// As typed.
struct PlanWords {
  std::vector<std::string> with;     ///< names of effects
  std::vector<std::string> without;  ///< names of effects
  std::string step;                  ///< s; empty: the plan's
};

/// The options that they mean.
/// @throws std::invalid_argument for an unknown effect, or an invalid step
PlanOptions plan_options(const PlanWords& words);

/// A number of seconds as typed after an option.
/// @param zero whether 0 is allowed
/// @throws std::invalid_argument with the option's name and what is allowed
double seconds_of(const std::string& option, const std::string& text, bool zero);

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_words.cpp"
#endif
