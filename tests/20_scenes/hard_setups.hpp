/// @file
/// Hard balls for tests: random ones in a box, and queries of their runs.
#pragma once

#include <contact/events/hard_spheres.hpp>
#include <vector>

#include "support/generators.hpp"

namespace hard_setups {

using contact::HardBall;
using contact::HardSphereEffects;
using contact::HardSphereHit;
using contact::HardSphereObserver;
using contact::HardSphereSetup;
using contact::Vector3;
using generators::Random;

inline constexpr double u = 0x1p-53;
inline constexpr HardSphereEffects everything{3, true, true, true, true};

/// Records which bodies hit, and when.
struct Log final : HardSphereObserver {
  std::vector<HardSphereHit> hits;
  bool on_hit(const HardSphereHit& hit) override {
    hits.push_back(hit);
    return true;
  }
};

inline HardBall ball(const Vector3<double>& x, const Vector3<double>& v, double radius = 0.5,
                     double mass = 1) {
  return {x, v, radius, mass, 0, true};
}

inline Vector3<double> in_cube(Random& random, double half) {
  const double x = random.uniform(-half, half);
  const double y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}

/// A box from (0, 0, 0) to (edge, edge, height).
inline void add_box(HardSphereSetup& setup, double edge, double height) {
  for (int k = 0; k < 3; ++k) {
    setup.walls.push_back({Vector3<double>::Unit(k), 0, 0});
    setup.walls.push_back({-Vector3<double>::Unit(k), k == 2 ? -height : -edge, 0});
  }
}

/// Balls at random positions in a box of edge 6, without overlaps.
inline HardSphereSetup random_setup(Random& random, int balls, bool alike, double gravity) {
  HardSphereSetup setup;
  setup.gravity = {0, 0, -gravity};
  add_box(setup, 6, 6);
  while (static_cast<int>(setup.balls.size()) < balls) {
    const double radius = alike ? 0.4 : random.uniform(0.1, 0.6);
    const double mass = alike ? 1.0 : random.uniform(0.2, 5);
    const Vector3<double> x = Vector3<double>(3, 3, 3) + in_cube(random, 3 - radius);
    bool free = true;
    for (const HardBall& other : setup.balls)
      free = free && (x - other.position).norm() > radius + other.radius + 1e-6;
    if (free) setup.balls.push_back(ball(x, in_cube(random, 4), radius, mass));
  }
  return setup;
}

inline double largest_overlap(const contact::HardSphereRun& run, const HardSphereSetup& setup) {
  double overlap = 0;
  for (std::size_t i = 0; i < setup.balls.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double gap = (run.position(i) - run.position(k)).norm() - setup.balls[i].radius -
                         setup.balls[k].radius;
      overlap = std::max(overlap, -gap);
    }
    for (const auto& wall : setup.walls) {
      overlap = std::max(overlap,
                         -(wall.normal.dot(run.position(i)) - wall.offset - setup.balls[i].radius));
    }
  }
  return overlap;
}

}  // namespace hard_setups
