// A ball of 0.4 kg hits a wall at 10 m/s and stops or bounces.
#include <cmath>
#include <contact/impulse.hpp>
#include <cstdio>

int main() {
  const double mass = 0.4;       // kg
  const double duration = 0.01;  // s
  const contact::Vector3<double> before(10, 0, 0);
  for (const double after : {0.0, -5.0, -10.0}) {
    const auto impulse = contact::impulse_of_change<double>(mass, before, {after, 0, 0});
    std::printf("leaves at %3g m/s: impulse %g N s, average force %g N; from speeds %g N s\n",
                after, impulse.x(), impulse.x() / duration, mass * (std::abs(after) - before.x()));
  }
}
