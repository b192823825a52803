// The velocity of a steel ball that hits a wall at 10 m/s, 60 degrees from its surface, split into
// two parts; and that of a ball at 20 feet per second, 40 degrees from the line of centres.
#include <cmath>
#include <contact/products.hpp>
#include <cstdio>
#include <numbers>

int main() {
  using Vector = contact::Vector3<double>;
  const double degree = std::numbers::pi / 180;
  const Vector into_wall(1, 0, 0);
  // [split]
  const Vector v = 10.0 * Vector(std::sin(60 * degree), std::cos(60 * degree), 0);
  const double along = contact::dot_accurately(v, into_wall);
  const Vector tangential = v - along * into_wall;
  // [/split]
  std::printf("into the wall %.2f m/s, along the wall %.2f m/s\n", along, tangential.norm());
  std::printf("with the angle taken from the normal: %.2f and %.2f m/s\n",
              10 * std::cos(60 * degree), 10 * std::sin(60 * degree));
  std::printf("with degrees for radians: %.2f m/s into the wall\n", 10 * std::sin(60.0));

  const double foot = 0.3048;
  const double speed = 20 * foot;
  std::printf("20 ft/s is %.3f m/s: %.3f along the line of centres, %.3f perpendicular\n", speed,
              speed * std::cos(40 * degree), speed * std::sin(40 * degree));
  std::printf("in feet: %.2f and %.2f ft/s\n", 20 * std::cos(40 * degree),
              20 * std::sin(40 * degree));
}
