// Impacts saved, and error made, by an early rest.
#include <contact/bouncing.hpp>
#include <cstdio>

int main() {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.8);
  const double end = contact::rest_time(ball);
  std::printf("epsilon    rest speed   impacts      rests    early by\n");
  for (const double height : {0.01, 0.001, 1e-4, 1e-6, 1e-9}) {
    const double slow = contact::rest_speed(height, ball.gravity);
    const auto rest = contact::follow_bounces(ball, end, slow);
    const double at = contact::impact_time(ball, static_cast<long long>(rest.bounces));
    std::printf("%-7g  %8.3g m/s  %8g  %.4f s  %8.2g s\n", height, slow, rest.bounces, at,
                end - at);
  }
  const auto endless = contact::follow_bounces(ball, 2 * end, 0.0);
  std::printf("no rest speed: in double the sum stops growing after %g impacts\n", endless.bounces);
  // Box2D leaves out bounces slower than 1 m/s, unless told otherwise.
  std::printf("1 m/s leaves out bounces of up to %.1f cm\n", 100 * 1.0 / (2 * 9.81));
}
