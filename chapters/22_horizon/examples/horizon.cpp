// Ten discs in a square, twice: the second time one of them begins one ulp farther right.
#include <algorithm>
#include <cmath>
#include <contact/events/hard_spheres.hpp>
#include <cstdio>

namespace {

contact::HardSphereSetup ten_discs() {
  contact::HardSphereSetup setup;
  for (int i = 0; i < 10; ++i) {
    contact::HardBall disc;
    disc.radius = 0.5;
    disc.mass = 1;
    disc.position = {1 + 2.0 * (i % 3), 1 + 1.75 * (i / 3), 0};
    disc.velocity = {std::fmod(7 * i + 3, 5) - 2, std::fmod(3 * i + 1, 7) - 3, 0};
    setup.balls.push_back(disc);
  }
  for (const int axis : {0, 1}) {
    const auto normal = contact::Vector3<double>::Unit(axis);
    setup.walls.push_back({normal, 0, 0});
    setup.walls.push_back({-normal, -8, 0});
  }
  return setup;
}

}  // namespace

int main() {
  constexpr contact::HardSphereEffects plane{
      .dimension = 2, .gravity = false, .sizes = false, .restitution = false, .grid = false};
  // [two-runs]
  contact::HardSphereSetup setup = ten_discs();
  contact::HardSpheres<plane> one(setup);
  setup.balls[0].position.x() = std::nextafter(setup.balls[0].position.x(), 2.0);
  contact::HardSpheres<plane> other(setup);
  for (int second = 0; second <= 12; ++second) {
    one.advance(second);
    other.advance(second);
    double apart = 0;
    for (std::size_t i = 0; i < one.moving(); ++i)
      apart = std::max(apart, (one.position(i) - other.position(i)).norm());
    std::printf("%2d s  %3d hits  apart %.1e m   energies apart %.0e J\n", second,
                static_cast<int>(one.counts().hits), apart,
                std::abs(one.energy() - other.energy()));
  }
  // [/two-runs]
}
