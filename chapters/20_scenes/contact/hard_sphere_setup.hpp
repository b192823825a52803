/// @file
/// What a simulation of hard, smooth balls is given, and two families of such setups of any size.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A smooth ball. It does not turn: nothing could turn it.
struct HardBall {
  Vector3<double> position = Vector3<double>::Zero();  ///< of its centre, m
  Vector3<double> velocity = Vector3<double>::Zero();  ///< m/s; 0 if it does not move
  double radius = 0;                                   ///< m, greater than 0
  double mass = 0;                                     ///< kg, greater than 0 if it moves
  std::size_t material = 0;                            ///< row of HardSphereSetup::restitution
  bool moves = true;                                   ///< false: nothing moves it
};

/// A smooth wall or floor: no point of a ball may have normal · x < offset. Never moves.
struct HardWall {
  Vector3<double> normal = Vector3<double>::UnitZ();  ///< unit vector, towards the balls
  double offset = 0;                                  ///< m
  std::size_t material = 0;                           ///< row of HardSphereSetup::restitution
};

/// Balls, walls, and what makes them bounce. Balls may touch at first, and not overlap.
struct HardSphereSetup {
  Vector3<double> gravity = Vector3<double>::Zero();  ///< m/s²
  std::vector<HardBall> balls;                        ///< those that move first, then the others
  std::vector<HardWall> walls;                        ///< half-spaces that do not move
  /// Coefficients of restitution, from 0 to 1, a symmetric square table: row and column by
  /// material.
  std::vector<double> restitution{1.0};
  /// s. A ball whose next hop on a wall would be shorter lies down on it: its path is then off by
  /// at most (pull towards the wall) cutoff² / 8. A ball that without that hits more often than
  /// 1,000 times in a row, each time sooner than this, ends the run.
  double cutoff = 0x1p-20;
};

/// How many of the balls move.
inline std::size_t moving_balls(const HardSphereSetup& setup) {
  std::size_t count = 0;
  while (count < setup.balls.size() && setup.balls[count].moves) ++count;
  return count;
}

/// Throws std::invalid_argument unless a setup is one: finite numbers, radii and masses greater
/// than 0, unit normals, coefficients from 0 to 1, materials that are in the table, at least one
/// ball that moves, and those that do not after all that do. Overlaps are not looked for.
inline void require_hard_sphere_setup(const HardSphereSetup& setup) {
  require_finite("gravity", setup.gravity);
  std::size_t materials = 1;
  while (materials * materials < setup.restitution.size()) ++materials;
  if (materials * materials != setup.restitution.size()) {
    throw_invalid_argument("restitution", std::to_string(setup.restitution.size()) + " entries",
                           "must be a square table");
  }
  for (const double e : setup.restitution) {
    if (!(e >= 0 && e <= 1))
      throw_invalid_argument("restitution", number_text(e), "must be from 0 to 1");
  }
  if (!(setup.cutoff >= 0) || !is_finite(setup.cutoff))
    throw_invalid_argument("cutoff", number_text(setup.cutoff), "must be finite and not negative");
  for (std::size_t i = 0; i < materials; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (setup.restitution[i * materials + k] != setup.restitution[k * materials + i]) {
        throw_invalid_argument("restitution", number_text(setup.restitution[i * materials + k]),
                               "must be the same for two materials in either order");
      }
    }
  }
  const auto name = [](const char* list, std::size_t i, const char* member) {
    return std::string(list) + "[" + std::to_string(i) + "]." + member;
  };
  const auto require_material = [&](const char* list, std::size_t i, std::size_t material) {
    if (material >= materials) {
      throw_invalid_argument(name(list, i, "material"), std::to_string(material),
                             "must be below " + std::to_string(materials));
    }
  };
  const std::size_t moving = moving_balls(setup);
  if (moving == 0) throw_invalid_argument("balls", "0 that move", "at least one must move");
  for (std::size_t i = 0; i < setup.balls.size(); ++i) {
    const HardBall& ball = setup.balls[i];
    if (ball.moves != (i < moving))
      throw_invalid_argument(name("balls", i, "moves"), "true", "balls that move must come first");
    require_finite(name("balls", i, "position").c_str(), ball.position);
    require_finite(name("balls", i, "velocity").c_str(), ball.velocity);
    if (!(ball.radius > 0) || !is_finite(ball.radius)) {
      throw_invalid_argument(name("balls", i, "radius"), number_text(ball.radius),
                             "must be finite and greater than 0");
    }
    if (ball.moves && (!(ball.mass > 0) || !is_finite(ball.mass))) {
      throw_invalid_argument(name("balls", i, "mass"), number_text(ball.mass),
                             "must be finite and greater than 0");
    }
    if (!ball.moves && !ball.velocity.isZero(0)) {
      throw_invalid_argument(name("balls", i, "velocity"), vector_text(ball.velocity),
                             "must be 0 of a ball that does not move");
    }
    require_material("balls", i, ball.material);
  }
  for (std::size_t w = 0; w < setup.walls.size(); ++w) {
    const HardWall& wall = setup.walls[w];
    require_finite(name("walls", w, "normal").c_str(), wall.normal);
    require_finite(name("walls", w, "offset").c_str(), wall.offset);
    if (std::abs(wall.normal.squaredNorm() - 1) > 0x1p-48) {
      throw_invalid_argument(name("walls", w, "normal"), vector_text(wall.normal),
                             "must have length 1");
    }
    require_material("walls", w, wall.material);
  }
}

namespace detail {

/// Numbers for setups, the same on every machine: splitmix64 (Steele, Lea and Flood, 2014).
class SetupNumbers {
 public:
  explicit SetupNumbers(std::uint64_t seed) : state_(seed) {}

  /// In [low, high).
  double next(double low, double high) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * (static_cast<double>(z >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_;
};

/// n balls of radius 0.5 and mass 1 on a lattice, each moved off its place, with velocities drawn
/// from a ball, in a box round the lattice that is `higher` times as high.
inline HardSphereSetup balls_on_lattice(std::size_t n, std::uint64_t seed, double spacing,
                                        double jitter, double speed, double higher) {
  std::size_t side = 1;
  while (side * side * side < n) ++side;
  SetupNumbers numbers(seed);
  HardSphereSetup setup;
  setup.cutoff = 0x1p-30;
  setup.balls.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    HardBall ball;
    ball.radius = 0.5;
    ball.mass = 1;
    const std::size_t place[3] = {i % side, i / side % side, i / side / side};
    for (int k = 0; k < 3; ++k) {
      ball.position(k) = (static_cast<double>(place[k]) + 0.5) * spacing;
      ball.position(k) += numbers.next(-jitter, jitter);
    }
    do {
      for (int k = 0; k < 3; ++k) ball.velocity(k) = numbers.next(-speed, speed);
    } while (ball.velocity.squaredNorm() > speed * speed);
    setup.balls.push_back(ball);
  }
  const double edge = static_cast<double>(side) * spacing;
  for (int k = 0; k < 3; ++k) {
    const Vector3<double> axis = Vector3<double>::Unit(k);
    setup.walls.push_back({axis, 0, 0});
    setup.walls.push_back({-axis, -(k == 2 ? higher : 1) * edge, 0});
  }
  return setup;
}

}  // namespace detail

// [elastic-lattice]
/// Elastic balls under gravity in a box: the scene on which engines gain energy. n balls of radius
/// 0.5 m and mass 1 kg on a jittered lattice of spacing 1.2 m, speeds up to 3 m/s, in a box 1.5
/// times as high as the lattice, with g = 10 m/s².
inline HardSphereSetup elastic_lattice(std::size_t n, std::uint64_t seed) {
  HardSphereSetup setup = detail::balls_on_lattice(n, seed, 1.2, 0.09, 3, 1.5);
  setup.gravity = {0, 0, -10};
  return setup;
}

/// A dilute gas without gravity: n balls of radius 0.5 m, one in each cube of edge 5 m (0.4 % of
/// the room), speeds up to 3 m/s, in a box. Its density does not depend on n.
inline HardSphereSetup dilute_gas(std::size_t n, std::uint64_t seed) {
  return detail::balls_on_lattice(n, seed, 5, 1.9, 3, 1);
}
// [/elastic-lattice]

}  // namespace contact
