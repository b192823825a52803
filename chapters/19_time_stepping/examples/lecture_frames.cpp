// The lecture's numbers: gravity (0, -0.5, 0) and frames of two seconds, for a ball that is
// released at 40 m. Its height by explicit Euler, by symplectic Euler, and by the exact formula.
#include <contact/ballistic.hpp>
#include <cstdio>

int main() {
  using State = contact::MotionState<double>;
  const double gravity = -0.5;
  const auto law = [gravity](double) { return gravity; };
  const State start{40, 0};
  State forward = start;
  State symplectic = start;
  std::printf("time  explicit Euler  symplectic Euler  exact\n");
  for (int frame = 1; frame <= 6; ++frame) {
    forward = contact::explicit_euler_step(forward, 2.0, law);
    symplectic = contact::semi_implicit_euler_step(symplectic, 2.0, law);
    const State exact = contact::ballistic_motion(start, gravity, 2.0 * frame);
    std::printf("%2d s  %5.1f m         %5.1f m           %5.1f m\n", 2 * frame, forward.position,
                symplectic.position, exact.position);
  }
}
