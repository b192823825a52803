// The lecture's steel ball: 3 kg, 10 m/s, at 60 degrees with the surface of a wall, 0.2 s of
// contact.
#include <cmath>
#include <contact/impulse.hpp>
#include <contact/rebound_angle.hpp>
#include <contact/restitution.hpp>
#include <cstdio>

int main() {
  using Vector = contact::Vector3<double>;
  const Vector wall(1, 0, 0);              // the wall's normal
  const double sine = std::sqrt(3.0) / 2;  // of 60 degrees
  const double cosine = 0.5;

  const auto force = [&wall](const Vector& v) {
    const Vector after = contact::after_bounce(v, wall, 1.0);
    return contact::impulse_of_change(3.0, v, after).x() / 0.2;
  };
  const Vector from_surface(-10 * sine, 10 * cosine, 0);
  const Vector from_normal(-10 * cosine, 10 * sine, 0);
  std::printf("60 degrees from the surface: %.0f from the normal, average force %.1f N\n",
              contact::degrees(contact::angle_from_normal(from_surface, wall)),
              force(from_surface));
  std::printf("60 degrees from the normal:  %.0f from the normal, average force %.1f N\n",
              contact::degrees(contact::angle_from_normal(from_normal, wall)), force(from_normal));
}
