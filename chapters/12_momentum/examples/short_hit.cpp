// The impulse of gravity while a bat hits a ball: the impulse approximation in numbers.
#include <contact/impulse.hpp>
#include <cstdio>

int main() {
  const double mass = 0.145;                                                              // kg
  const double gravity = 9.81;                                                            // m/s²
  const auto of_bat = contact::impulse_of_change<double>(mass, {-40, 0, 0}, {45, 0, 0});  // N s
  std::printf("impulse of the bat: %.3f N s\n", of_bat.x());
  for (const double duration : {0.001, 0.01, 0.1, 1.0}) {
    const auto weight = contact::force_curve<double>(
        {0, duration}, {{0, 0, -mass * gravity}, {0, 0, -mass * gravity}});
    const double of_gravity = -contact::impulse(weight).z();
    std::printf(
        "contact of %4g s: gravity gives %.5f N s, %.2g of the bat's; without it the error is "
        "%.4f m/s\n",
        duration, of_gravity, of_gravity / of_bat.x(), of_gravity / mass);
  }
}
