// Errors of position and velocity of a body on a spring after two seconds, as the step is halved.
#include <cmath>
#include <contact/spring_motion.hpp>
#include <cstdio>

int main() {
  using contact::Integrator;
  const auto spring = contact::linear_spring(1.0);
  const contact::MotionState<double> start{1, 0.5};
  const auto truth = contact::spring_motion(spring, start, 2.0);
  std::printf("steps  explicit Euler  symplectic Euler  Verlet     Runge-Kutta\n");
  for (const int steps : {20, 40, 80, 160}) {
    const auto off = [&](Integrator integrator) {
      const auto end = contact::integrate(integrator, start, 2.0 / steps, steps, spring);
      return std::hypot(end.position - truth.position, end.velocity - truth.velocity);
    };
    std::printf("%4d   %.1e         %.1e           %.1e    %.1e\n", steps,
                off(Integrator::explicit_euler), off(Integrator::semi_implicit_euler),
                off(Integrator::velocity_verlet), off(Integrator::runge_kutta_4));
  }
}
