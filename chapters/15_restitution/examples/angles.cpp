// Incidence at 45 degrees, and the rebound with more and more friction: for a body that does not
// rotate, for a solid ball, and for a superball, whose tangential restitution is 1.
#include <contact/rebound_angle.hpp>
#include <contact/restitution.hpp>
#include <cstdio>

int main() {
  using Vector = contact::Vector3<double>;
  const Vector v(4, 0, -4);  // m/s
  const Vector n(0, 0, 1);
  std::printf("friction  k = 1            k = 0.6          ball, k = 0.6    superball, k = 1\n");
  const double roll = contact::solid_ball_grip<double>;  // of the speed, until the ball rolls
  for (const double friction : {0.0, 0.1, 0.2, 0.5, 0.8}) {
    std::printf("%.1f     ", friction);
    for (const auto& [k, grip] : {std::pair(1.0, 1.0), std::pair(0.6, 1.0), std::pair(0.6, roll),
                                  std::pair(1.0, 2 * roll)}) {
      const Vector after = contact::after_bounce_with_friction(v, n, k, friction, grip);
      std::printf("  %4.1f deg (%.2f)", contact::degrees(contact::angle_from_normal(after, n)),
                  after.x());
    }
    std::printf("\n");
  }
}
