// A small ball above a large one, both dropped from 1 m.
#include <cmath>
#include <contact/stacked_drop.hpp>
#include <cstdio>

int main() {
  const double speed = std::sqrt(2 * 9.81 * 1.0);  // m/s, of both at the floor
  const auto show = [speed](const char* name, double lower, double upper, double k) {
    const auto after = contact::drop_stacked(lower, upper, speed, k, k);
    const double up = after.upper / speed;
    std::printf("%-24s upper %5.2f m/s, up to %.2f m; lower %5.2f m/s\n", name, after.upper,
                up * up, after.lower);
  };
  show("1000 kg and 1 g, k = 1", 1000, 0.001, 1);
  show("600 g and 58 g, k = 1", 0.6, 0.058, 1);
  show("600 g and 58 g, k = 0.8", 0.6, 0.058, 0.8);
  show("3 to 1, k = 1", 3, 1, 1);
  show("equal masses, k = 1", 1, 1, 1);
}
