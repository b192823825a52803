// The same drop in time steps: the height of the third bounce, and the number of impacts in 3 s, by
// rule and step size.
#include <algorithm>
#include <contact/fixed_step_bounce.hpp>
#include <cstdio>

using contact::StepRule;

int main() {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.8);
  const double third = (contact::impact_time(ball, 3) + contact::impact_time(ball, 4)) / 2;
  std::printf("exact: third bounce %.4f m, %g impacts in 3 s\n",
              contact::bounce_at(ball, third).height, contact::bounces_by(ball, 3.0));
  std::printf(
      "steps/s  flip below     on the floor  lecture's loop  step's end     at the impact\n");
  for (const int rate : {30, 60, 240, 960}) {
    std::printf("%-7d", rate);
    for (const StepRule rule : {StepRule::flip_below, StepRule::clamp, StepRule::new_velocity,
                                StepRule::end_velocity, StepRule::impact_velocity}) {
      contact::BounceState<double> state{1, 0, 0, false};
      double highest = 0;
      for (int i = 0; i < 3 * rate; ++i) {
        state = contact::bounce_step(state, ball, 1.0 / rate, rule);
        if (state.bounces == 3) highest = std::max(highest, state.height);
      }
      std::printf("  %.4f m, %3g", highest, state.bounces);
    }
    std::printf("\n");
  }
}
