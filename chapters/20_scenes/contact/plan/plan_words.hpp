/// @file
/// What somebody types to change a plan: a step, and effects that are forced on or off.
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

/// What they ask for.
/// @throws std::invalid_argument for an effect that is none, or a step that is none
PlanOptions plan_options(const PlanWords& words);

/// A number of seconds as typed after an option.
/// @param zero whether 0 is one
/// @throws std::invalid_argument that names the option and what it may be
double seconds_of(const std::string& option, const std::string& text, bool zero);

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_words.cpp"
#endif
