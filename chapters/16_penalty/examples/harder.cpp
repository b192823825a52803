// A ball of 1 kg at 2 m/s on springs without a damper, from soft to hard: the force becomes larger
// and shorter, and its area stays the same.
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_impact.hpp>
#include <cstdio>

int main() {
  const double mass = 1, speed = 2;  // kg, m/s
  std::printf("    k, N/m  duration, ms  depth, mm  largest force, N  impulse, N s\n");
  for (const double stiffness : {1e2, 1e4, 1e6, 1e8}) {
    const auto spring = contact::spring_damper(stiffness, 0.0);
    const auto impact = contact::spring_impact(spring, mass, speed);
    std::printf("%10.0f  %12.3f  %9.2f  %16.0f  %12.1f\n", stiffness, 1000 * impact.duration,
                1000 * impact.max_depth, impact.max_force,
                contact::contact_impulse(spring, mass, speed));
  }
}
