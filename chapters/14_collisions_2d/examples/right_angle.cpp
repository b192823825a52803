// The angle at which two balls leave. A arrives at 2 m/s, B is in front of it and to the side.
#include <cmath>
#include <contact/disc_collision.hpp>
#include <cstdio>
#include <numbers>

using Vector = contact::Vector2<double>;

void hit(const char* name, double mass_b, double e, const Vector& velocity_b,
         const Vector& centre_b) {
  const auto a = contact::disc<double>(1, 0.5, {0, 0}, {2, 0});
  const auto b = contact::disc<double>(mass_b, 0.5, centre_b, velocity_b);
  const auto after = contact::collide_discs(a, b, e);
  const Vector& va = after.velocity_a;
  const Vector& vb = after.velocity_b;
  if (va.norm() < 1e-9) {
    std::printf("%-28s A is at rest, so there is no angle\n", name);
    return;
  }
  const double angle = std::acos(va.dot(vb) / (va.norm() * vb.norm())) * 180 / std::numbers::pi;
  std::printf("%-28s %5.1f degrees\n", name, angle);
}

int main() {
  const Vector aside(0.8, 0.6);
  hit("equal, elastic, B at rest:", 1, 1, {0, 0}, aside);
  hit("e = 0.9:", 1, 0.9, {0, 0}, aside);
  hit("B twice as heavy:", 2, 1, {0, 0}, aside);
  hit("B half as heavy:", 0.5, 1, {0, 0}, aside);
  hit("twice as heavy, e = 0.5:", 2, 0.5, {0, 0}, aside);
  hit("B moves:", 1, 1, {0.5, -0.5}, aside);
  hit("B moves perpendicularly:", 1, 1, {0, -0.5}, aside);
  hit("head-on:", 1, 1, {0, 0}, {1, 0});
}
