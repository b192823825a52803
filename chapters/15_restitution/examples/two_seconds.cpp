// The lecture's own numbers: gravity (0, -0.5, 0), two seconds a frame. A ball is dropped from
// 10 m and loses nothing.
#include <contact/fixed_step_bounce.hpp>
#include <cstdio>

int main() {
  const auto ball = contact::bouncing_ball(10.0, 0.0, 0.5, 1.0);
  contact::BounceState<double> loop{10, 0, 0, false};
  std::printf("time  lecture's loop  exact\n");
  for (int frame = 1; frame <= 12; ++frame) {
    loop = contact::bounce_step(loop, ball, 2.0, contact::StepRule::new_velocity);
    std::printf("%2d s  %7.3f m       %7.3f m\n", 2 * frame, loop.height,
                contact::bounce_at(ball, 2.0 * frame).height);
  }
}
