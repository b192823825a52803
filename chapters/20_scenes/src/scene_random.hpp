#pragma once

// The numbers of a repeated body: seeded, and the same on every machine.

#include <cmath>
#include <cstdint>

#include <contact/vector.hpp>

namespace contact::scenes {

/// splitmix64 (Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, 2014).
class SceneRandom {
 public:
  explicit SceneRandom(std::uint64_t seed) : state_(seed) {}

  /// A multiple of 2^-52 from -1 to 1, without 1.
  double signed_unit() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return std::ldexp(static_cast<double>(z >> 11U), -52) - 1;
  }
  /// A point of the cube from -1 to 1: x is drawn first, z last.
  Vector3<double> in_cube() {
    const double x = signed_unit();
    const double y = signed_unit();
    const double z = signed_unit();
    return {x, y, z};
  }
  /// A point of the ball of radius 1: the first of the cube's that lies in it.
  Vector3<double> in_ball() {
    for (;;) {
      const Vector3<double> point = in_cube();
      if (point.x() * point.x() + point.y() * point.y() + point.z() * point.z() <= 1) return point;
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace contact::scenes
