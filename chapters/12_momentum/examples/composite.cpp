// Two carts with a spring between them on a track. The carts oscillate; the centre of mass moves
// like a point with the total mass.
#include <contact/impulse.hpp>
#include <contact/momentum.hpp>
#include <cstdio>
#include <vector>

int main() {
  using contact::Vector3;
  const double stiffness = 200;  // N/m
  const double rest_length = 1;  // m
  const double step = 0.001;     // s
  std::vector<contact::PointMass<double>> carts{
      contact::point_mass<double>(1, {0, 0, 0}, {2, 0, 0}),
      contact::point_mass<double>(3, {1, 0, 0}, {0, 0, 0})};
  const double whole = contact::total_mass(carts);

  std::printf("time  velocities        of the centre  momentum\n");
  for (int i = 0; i <= 1500; ++i) {
    if (i % 250 == 0) {
      std::printf("%.2f  %7.4f  %7.4f  %.4f         %.4f\n", i * step, carts[0].velocity.x(),
                  carts[1].velocity.x(), contact::centre_velocity(carts)->x(),
                  contact::total_momentum(carts).x());
    }
    // The spring exerts opposite forces on the carts. From 0.5 s to 1 s a hand pushes the first one
    // with 4 N: the only external force.
    const double stretch = carts[1].position.x() - carts[0].position.x() - rest_length;
    const Vector3<double> spring(stiffness * stretch * step, 0, 0);
    const Vector3<double> hand(i >= 500 && i < 1000 ? 4 * step : 0, 0, 0);
    carts[0].velocity =
        contact::velocity_after<double>(carts[0].mass, carts[0].velocity, spring + hand);
    carts[1].velocity = contact::velocity_after<double>(carts[1].mass, carts[1].velocity, -spring);
    for (auto& cart : carts) cart.position += step * cart.velocity;
  }
  std::printf("the hand gives 4 N for 0.5 s to %g kg: %g m/s\n", whole, 4 * 0.5 / whole);
}
