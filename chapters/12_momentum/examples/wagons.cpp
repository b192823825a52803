// A wagon of 4000 kg rolls at 3 m/s without friction, and its mass changes.
#include <contact/momentum.hpp>
#include <contact/variable_mass.hpp>
#include <cstdio>

int main() {
  const double mass = 4000;  // kg
  const contact::Vector3<double> v(3, 0, 0);

  const auto show = [&](const char* what, double change, const contact::Vector3<double>& w) {
    const double after = contact::velocity_after_exchange(mass, v, change, w)->x();
    const double alone = mass * v.x() / (mass + change);
    std::printf("%-22s %5g kg: %.3f m/s; with m v of the wagon alone constant: %.3f m/s\n", what,
                mass + change, after, alone);
  };
  show("rain falls vertically", 1000, {0, 0, 0});
  show("sand runs out", -1000, v);
  show("sand is thrown back", -1000, {-1, 0, 0});

  // A rocket ejects half its mass backwards at 1000 m/s, in fewer or more pieces.
  std::printf("\nrocket, half of 10 kg at 1000 m/s:\n");
  for (const int pieces : {1, 10, 100, 1000}) {
    double left = 10;
    contact::Vector3<double> speed(0, 0, 0);
    for (int i = 0; i < pieces; ++i) {
      const double piece = 5.0 / pieces;
      left = 10 - 5.0 * (i + 1) / pieces;
      speed = contact::push_off<double>(left, piece, speed, {-1000, 0, 0}).first;
    }
    std::printf("%5d pieces: %.3f m/s\n", pieces, speed.x());
  }
  std::printf("   continuously: %.3f m/s\n", contact::rocket_speed_gain(1000.0, 10.0, 5.0));
}
