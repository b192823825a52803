// A body on a spring that swings once in a second: how much energy each step makes of it in 1, 10
// and 100 swings, at 64 steps a swing.
#include <contact/spring_motion.hpp>
#include <cstdio>

int main() {
  using contact::Integrator;
  const auto spring = contact::linear_spring(6.283185307179586);
  const contact::MotionState<double> start{1, 0};
  const double energy = contact::spring_energy(spring, start);
  std::printf("energy after         1 swing   10 swings   100 swings\n");
  const auto show = [&](const char* name, Integrator integrator) {
    std::printf("%-18s", name);
    for (const int swings : {1, 10, 100}) {
      const auto end = contact::integrate(integrator, start, 1.0 / 64, 64 * swings, spring);
      std::printf("  %10.6g", contact::spring_energy(spring, end) / energy);
    }
    std::printf("\n");
  };
  show("position first", Integrator::position_first);
  show("velocity first", Integrator::velocity_first);
  show("Verlet", Integrator::velocity_verlet);
  show("Runge-Kutta", Integrator::runge_kutta_4);
}
