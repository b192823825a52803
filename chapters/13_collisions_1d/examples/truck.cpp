// A truck of 3000 kg at 20 m/s runs into a parked car of 1000 kg, which leaves at 15 m/s. Then the
// same collision with other coefficients of restitution.
#include <contact/collision_1d.hpp>
#include <cstdio>

int main() {
  const auto truck = contact::line_body(3000.0, 20.0);
  const auto car = contact::line_body(1000.0, 0.0);
  const double car_after = 15;
  const double truck_after =
      truck.velocity - car.mass * (car_after - car.velocity) / truck.mass;  // momentum
  const auto e = contact::restitution_of(truck, car, truck_after, car_after);
  std::printf("the truck leaves at %g m/s, so e = %g\n", truck_after, *e);

  for (const double bounce : {0.0, 0.5, 1.0}) {
    const auto after = contact::collide(truck, car, bounce);
    const double lost = contact::energy_lost(truck, car, bounce);
    std::printf("e = %-3g  truck %4g m/s, car %4g m/s, impulse %g kN s, lost %5.1f kJ of %g\n",
                bounce, after.first, after.second,
                contact::collision_impulse(truck, car, bounce) / 1e3, lost / 1e3,
                contact::kinetic_energy(truck) / 1e3);
  }
}
