// A body on a spring with a period of one second: its energy after 1, 10 and 100 periods, as a
// multiple of its energy at the start, at 64 steps a period.
#include <contact/spring_motion.hpp>
#include <cstdio>

int main() {
  using contact::Integrator;
  const auto spring = contact::linear_spring(6.283185307179586);
  const contact::MotionState<double> start{1, 0};
  const double energy = contact::spring_energy(spring, start);
  std::printf("energy after          1 period  10 periods 100 periods\n");
  const auto show = [&](const char* name, Integrator integrator) {
    std::printf("%-18s", name);
    for (const int periods : {1, 10, 100}) {
      const auto end = contact::integrate(integrator, start, 1.0 / 64, 64 * periods, spring);
      std::printf("  %10.6g", contact::spring_energy(spring, end) / energy);
    }
    std::printf("\n");
  };
  show("explicit Euler", Integrator::explicit_euler);
  show("symplectic Euler", Integrator::semi_implicit_euler);
  show("Verlet", Integrator::velocity_verlet);
  show("Runge-Kutta", Integrator::runge_kutta_4);
  std::printf("%-18s", "implicit Euler");
  auto damped = start;
  for (int step = 1; step <= 6400; ++step) {
    damped = contact::implicit_euler_step(damped, 1.0 / 64, spring);
    if (step == 64 || step == 640 || step == 6400) {
      std::printf("  %10.6g", contact::spring_energy(spring, damped) / energy);
    }
  }
  std::printf("\n");
}
