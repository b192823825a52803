// Ball A at 20 ft/s meets ball B at rest; the line of centres is at 40° to A's path. Equal masses.
#include <cmath>
#include <contact/disc_collision.hpp>
#include <cstdio>
#include <numbers>

using Vector = contact::Vector2<double>;

int main() {
  const double angle = 40 * std::numbers::pi / 180;
  // B lies 40° to the left of A's direction, and they touch.
  const Vector towards_b(std::cos(angle), std::sin(angle));
  // [collide]
  const auto a = contact::disc<double>(1, 0.5, Vector(0, 0), Vector(20, 0));
  const auto b = contact::disc<double>(1, 0.5, towards_b, Vector(0, 0));
  const auto after = contact::collide_discs(a, b, 1.0);
  // [/collide]
  const auto parts = contact::components(a.velocity, towards_b);
  std::printf("A before: %.2f ft/s normal, %.2f tangential\n", parts.normal,
              parts.tangential.norm());
  std::printf("A after:  %.2f ft/s, B after: %.2f ft/s\n", after.velocity_a.norm(),
              after.velocity_b.norm());
  std::printf("in SI: A %.3f m/s, B %.3f m/s\n", after.velocity_a.norm() * 0.3048,
              after.velocity_b.norm() * 0.3048);
  std::printf("their product v_A'.v_B': %.1f, so they leave at a right angle\n",
              std::abs(after.velocity_a.dot(after.velocity_b)));
  // 40 taken as radians, and the angle taken from the tangent.
  std::printf("sin and cos of 40 radians: A %.2f, B %.2f\n", 20 * std::sin(40.0),
              20 * std::cos(40.0));
  std::printf("40 degrees from the tangent: A %.2f, B %.2f\n", 20 * std::cos(angle),
              20 * std::sin(angle));
}
