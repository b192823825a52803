// A ball of 1 kg hits a rod of 3 kg and 2 m at rest, at 4 m/s and with e = 1/2: in the middle, at
// the sweet spot, at the end.
#include <contact/rigid_impulse.hpp>
#include <cstdio>

using V = contact::Vector3<double>;

int main() {
  const V none(0, 0, 0);
  const double transverse = contact::rod_inertia<double>(3, 2);
  const auto inertia = contact::detail::diagonal<double>(transverse, transverse, transverse);
  const auto rod = contact::rigid_body<double>(3, inertia, none, none, none);
  const double sweet = contact::centre_of_percussion(transverse, 3.0, 1.0);
  std::printf("centre of percussion of a grip at the left end: %.4f m beyond the middle\n", sweet);
  std::printf("hit at   j        v'      w'      ball    grip    energy L about 0\n");
  for (const double x : {0.0, sweet, 0.7, 1.0}) {
    const auto ball = contact::rigid_body<double>(1, contact::sphere_inertia<double>(1, 0.1),
                                                  {x, -0.1, 0}, {0, 4, 0}, none);
    const auto [a, b, impulse] = contact::collide<double>(rod, ball, {{x, 0, 0}, {0, 1, 0}}, 0.5);
    const V momentum = contact::angular_momentum(a, none) + contact::angular_momentum(b, none);
    std::printf(
        "%.4f  %.4f  %.4f  %.4f  %7.4f %7.4f  %.4f  %.4f of %.4f\n", x, impulse.y(), a.velocity.y(),
        a.angular_velocity.z(), b.velocity.y(), contact::velocity_at(a, V(-1, 0, 0)).y(),
        (contact::kinetic_energy(a) + contact::kinetic_energy(b)) / contact::kinetic_energy(ball),
        momentum.z(), contact::angular_momentum(ball, none).z());
  }
}
