// One collision in four frames: the loss is the same, the fraction is not.
#include <contact/collision_1d.hpp>
#include <cstdio>

int main() {
  const double e = 0.5;
  for (const auto& [name, frame] : {std::pair{"frame of the ground", 0.0},
                                    {"of the truck before", 20.0},
                                    {"of the centre of mass", 15.0},
                                    {"of a train at -40 m/s", -40.0}}) {
    const auto truck = contact::line_body(3000.0, 20.0 - frame);
    const auto car = contact::line_body(1000.0, 0.0 - frame);
    const double before = contact::kinetic_energy(truck) + contact::kinetic_energy(car);
    const double lost = contact::energy_lost(truck, car, e);
    std::printf("%-26s K = %6.0f kJ, lost %6.1f kJ: %4.1f %%\n", name, before / 1e3, lost / 1e3,
                100 * lost / before);
  }
}
