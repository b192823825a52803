#include <contact/events/hard_sphere_run.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <contact/invalid_argument.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE void require_hard_sphere_setup(const HardSphereSetup& setup) {
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

CONTACT_SCENES_INLINE HardSphereSetup balls_on_lattice(std::size_t n, std::uint64_t seed,
                                                       double spacing, double jitter, double speed,
                                                       double higher) {
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

}  // namespace contact
