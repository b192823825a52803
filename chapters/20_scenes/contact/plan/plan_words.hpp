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

/// The largest number of steps or frames of a run. At a microsecond a step it takes eleven days.
inline constexpr double max_steps = 1e12;

/// Refuses a run that could not come to its end.
/// @param until s
/// @param every time between two frames of output, s; 0: there are none
/// @throws std::invalid_argument if the time is longer than a scene's may be, or has more steps or
/// frames than max_steps; it says what to do
void require_possible_run(double until, double every, const Plan& plan);

}  // namespace contact::scenes

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_words.cpp"
#endif
