// The coefficient of restitution for a damping ratio, by both rules for the end of a contact, and
// the overlap that is left at zero force.
#include <contact/spring_impact.hpp>
#include <cstdio>

int main() {
  using contact::ContactRelease;
  std::printf("   zeta  e, zero penetration  e, zero force  overlap left\n");
  for (const double ratio : {0.0, 0.1, 0.2, 0.5, 1.0, 2.0}) {
    const auto spring = contact::spring_damper(1.0, 2 * ratio);  // and a mass of 1 kg
    const auto impact = contact::spring_impact(spring, 1.0, 1.0);
    std::printf("%7.1f  %19.3f  %13.3f  %12.2f\n", ratio,
                contact::restitution_of_damping(ratio, ContactRelease::at_zero_penetration),
                impact.restitution, impact.left_overlap / impact.max_depth);
  }
}
