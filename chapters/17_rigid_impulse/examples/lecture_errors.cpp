// A ball of 1 kg hits the middle of a rod of 3 kg and 2 m at rest, at 4 m/s and with e = 1/2. Two
// errors of a lecture: the normal reversed, and j/m multiplied by a time step.
#include <contact/rigid_impulse.hpp>
#include <cstdio>

using V = contact::Vector3<double>;

int main() {
  const V none(0, 0, 0);
  const double transverse = contact::rod_inertia<double>(3, 2);
  const auto inertia = contact::detail::diagonal<double>(transverse, transverse, transverse);
  const auto rod = contact::rigid_body<double>(3, inertia, none, none, none);
  const auto ball = contact::rigid_body<double>(1, contact::sphere_inertia<double>(1, 0.1),
                                                {0, -0.1, 0}, {0, 4, 0}, none);
  const contact::ContactPoint<double> towards_b{{0, 0, 0}, {0, -1, 0}};
  std::printf("normal from A to B: v_n = %+.1f m/s, so it counts as separating: j = %g\n",
              contact::normal_velocity(rod, ball, towards_b),
              contact::collision_impulse<double>(rod, ball, towards_b, 0.5));
  const contact::ContactPoint<double> hit{{0, 0, 0}, {0, 1, 0}};
  const double j = contact::collision_impulse<double>(rod, ball, hit, 0.5);
  for (const double h : {1.0 / 60, 1.0 / 120}) {
    std::printf("v + h j/m with h = 1/%g s: the rod leaves at %.4f m/s instead of %.4f\n", 1 / h,
                h * j / 3, j / 3);
  }
}
