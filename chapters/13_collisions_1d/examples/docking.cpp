// Two satellites dock at 1 cm/s while both move at 7 km/s: the loss of energy as a difference of
// energies and as a product.
#include <contact/collision_1d.hpp>
#include <cstdio>

int main() {
  const auto shuttle = contact::line_body(4000.0, 7000.01);
  const auto station = contact::line_body(90000.0, 7000.0);
  const auto after = contact::collide(shuttle, station, 0.0);
  const auto energy = [](double mass, double v) { return 0.5 * mass * v * v; };
  const double before =
      energy(shuttle.mass, shuttle.velocity) + energy(station.mass, station.velocity);
  const double difference =
      before - energy(shuttle.mass, after.first) - energy(station.mass, after.second);
  std::printf("kinetic energy before   %.6g J\n", before);
  std::printf("before minus after      %.6f J\n", difference);
  std::printf("1/2 mu (1 - e^2) w^2    %.6f J\n", contact::energy_lost(shuttle, station, 0.0));
}
