// A head of 5 kg comes from 15 m/s to rest: at the dashboard, in a belt, in an air bag.
#include <contact/impulse.hpp>
#include <cstdio>

int main() {
  const double mass = 5;  // kg
  const contact::Vector3<double> before(15, 0, 0);
  const contact::Vector3<double> rest(0, 0, 0);
  const auto needed = contact::impulse_of_change(mass, before, rest);
  std::printf("impulse that brings it to rest: %g N s, in every case\n", needed.x());

  struct Stop {
    const char* on;
    double duration;  // s
  };
  for (const Stop& stop : {Stop{"dashboard", 0.005}, Stop{"belt", 0.1}, Stop{"air bag", 0.15}}) {
    // A force that rises and falls linearly: a triangle whose area is the impulse.
    const double peak = 2 * needed.x() / stop.duration;
    const auto curve = contact::force_curve<double>({0, stop.duration / 2, stop.duration},
                                                    {{0, 0, 0}, {peak, 0, 0}, {0, 0, 0}});
    const auto impulse = contact::impulse(curve);
    std::printf("%-9s %5.0f ms: average %7.0f N, largest %7.0f N, area %g N s, end at %g m/s\n",
                stop.on, 1000 * stop.duration, contact::average_force(curve).x(), peak, impulse.x(),
                contact::velocity_after(mass, before, impulse).x());
  }
}
