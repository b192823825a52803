// Two hockey players collide head-on and hold on to each other.
#include <contact/impulse.hpp>
#include <contact/momentum.hpp>
#include <cstdio>

int main() {
  const auto first = contact::point_mass<double>(90, {0, 0, 0}, {6, 0, 0});
  const auto second = contact::point_mass<double>(80, {0, 0, 0}, {-7, 0, 0});
  std::printf("momenta: %g and %g kg m/s, together %g kg m/s\n", contact::momentum(first).x(),
              contact::momentum(second).x(), contact::total_momentum<double>({first, second}).x());

  const auto together = *contact::centre_velocity<double>({first, second});
  std::printf("stuck together they move at %.2f m/s (%.17g)\n", together.x(), together.x());

  const auto on_first = contact::impulse_of_change(first.mass, first.velocity, together);
  const auto on_second = contact::impulse_of_change(second.mass, second.velocity, together);
  std::printf("impulse on the first: %.1f N s, on the second: %.1f N s\n", on_first.x(),
              on_second.x());

  // The result with speeds instead of velocities.
  std::printf("without the minus: %.2f m/s\n", (90 * 6 + 80 * 7) / (90.0 + 80.0));
}
