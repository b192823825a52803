// The lecture's other numbers: a step of 1 s, and the ball meets the floor after 0.5 s of it. It is
// dropped with gravity 0.5 and loses nothing. The result of each rule.
#include <contact/fixed_step_bounce.hpp>
#include <cstdio>

using contact::StepRule;

void print(const char* rule, const contact::BounceState<double>& state) {
  std::printf("%-15s %.4f m  %+.4f m/s\n", rule, state.height, state.velocity);
}

int main() {
  const auto ball = contact::bouncing_ball(0.0625, 0.0, 0.5, 1.0);
  std::printf("impact at %g s\n", contact::first_impact_time(ball));
  print("exact", contact::bounce_at(ball, 1.0));
  print("lecture's loop", contact::bounce_in_steps(ball, 1.0, 1, StepRule::new_velocity));
  print("step's end", contact::bounce_in_steps(ball, 1.0, 1, StepRule::end_velocity));
  print("at the impact", contact::bounce_in_steps(ball, 1.0, 1, StepRule::impact_velocity));
}
