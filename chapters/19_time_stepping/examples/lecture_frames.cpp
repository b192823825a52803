// The lecture's numbers: gravity (0, -0.5, 0) and two seconds a frame, for a ball that is let go at
// 40 m. Where Euler's two orders say that it is, and where it is.
#include <contact/ballistic.hpp>
#include <cstdio>

int main() {
  using State = contact::MotionState<double>;
  const double gravity = -0.5;
  const auto law = [gravity](double) { return gravity; };
  const State start{40, 0};
  State first = start;
  State second = start;
  std::printf("time  position first  velocity first  exact\n");
  for (int frame = 1; frame <= 6; ++frame) {
    first = contact::position_first_step(first, 2.0, law);
    second = contact::velocity_first_step(second, 2.0, law);
    const State exact = contact::ballistic_motion(start, gravity, 2.0 * frame);
    std::printf("%2d s  %5.1f m         %5.1f m         %5.1f m\n", 2 * frame, first.position,
                second.position, exact.position);
  }
}
