// An archer on ice shoots an arrow: the recoil for two readings of the arrow's speed.
#include <contact/momentum.hpp>
#include <cstdio>

int main() {
  const double archer = 60;   // kg, with the bow
  const double arrow = 0.03;  // kg
  const double speed = 85;    // m/s

  // 85 m/s relative to the archer.
  const auto seen = contact::push_off<double>(archer, arrow, {0, 0, 0}, {speed, 0, 0});
  std::printf("85 m/s relative to the archer: archer %.5f m/s, arrow %.5f m/s over the ice\n",
              seen.first.x(), seen.second.x());

  // 85 m/s over the ice: then the two momenta are opposite.
  std::printf("85 m/s over the ice:           archer %.5f m/s\n", -arrow * speed / archer);

  // With a stone instead of the arrow the two readings differ much more.
  const auto stone = contact::push_off<double>(archer, 20, {0, 0, 0}, {3, 0, 0});
  std::printf(
      "a 20 kg stone at 3 m/s: archer %.3f m/s if relative to the archer, %.3f m/s if over "
      "the ice\n",
      stone.first.x(), -20 * 3.0 / archer);
}
