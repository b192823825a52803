/// @file
/// A stage: the bounces of impacts that were taken all at once.
#pragma once

#include <contact/contact_solver.hpp>
#include <contact/step_solver.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

// [bounces-stage]
/// Of impacts that were taken all at once: now that they touch, they leave as restitution says.
inline void solve_bounces(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  bool any = false;
  for (const BodyContact<double>& contact : part.bounces) any = any || contact.least_velocity > 0;
  if (!any) return;
  detail::solve_now(setup, state, part.bounces);
}
// [/bounces-stage]

}  // namespace contact
