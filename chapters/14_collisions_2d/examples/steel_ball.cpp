// A 3 kg steel ball hits a wall at 10 m/s, 60 degrees from the surface, and bounces off
// elastically.
#include <cmath>
#include <contact/disc_collision.hpp>
#include <contact/impulse.hpp>
#include <cstdio>
#include <numbers>

using Vector = contact::Vector2<double>;

double force_for(double from_surface) {
  const double angle = from_surface * std::numbers::pi / 180;
  // The wall is x = 0, and the ball is on its positive side.
  const Vector before(-10 * std::sin(angle), 10 * std::cos(angle));
  const Vector after = contact::off_cushion<double>(before, {1, 0}, 1.0);
  const auto impulse =
      contact::impulse_of_change<double>(3, {before.x(), before.y(), 0}, {after.x(), after.y(), 0});
  return impulse.norm() / 0.2;
}

int main() {
  std::printf("60 degrees from the surface: %.1f N, normal to the wall\n", force_for(60));
  std::printf("the whole velocity reversed: %.1f N\n", 2 * 3 * 10 / 0.2);
  std::printf("60 degrees taken from the normal: %.1f N\n", force_for(30));
  std::printf("change of speed, and not of velocity: %.1f N\n", 3 * (10.0 - 10.0) / 0.2);
}
