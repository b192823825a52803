// Nothing is lost (k = 1), so every peak should be 1 m. The peaks of sixty seconds at 60 steps a
// second.
#include <algorithm>
#include <contact/fixed_step_bounce.hpp>
#include <cstdio>
#include <vector>

using contact::StepRule;

void show(const char* name, StepRule rule) {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 1.0);
  contact::BounceState<double> state{1, 0, 0, false};
  std::vector<double> tops;
  for (int i = 0; i < 3600; ++i) {
    const double before = state.bounces;
    state = contact::bounce_step(state, ball, 1.0 / 60, rule);
    if (state.bounces > before) tops.push_back(0);
    if (!tops.empty()) tops.back() = std::max(tops.back(), state.height);
  }
  std::printf("%-22s", name);
  for (std::size_t i = 0; i < 5; ++i) std::printf(" %.3f", tops[i]);
  std::printf(" ... %.3f m\n", tops[tops.size() - 2]);
}

int main() {
  show("on the floor", StepRule::clamp);
  show("the lecture's loop", StepRule::new_velocity);
  show("step's end", StepRule::end_velocity);
  show("at the impact", StepRule::impact_velocity);
}
