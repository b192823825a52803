/// @file
/// From a setup of hard balls to the least composition that simulates it, with the proof of each
/// effect that is left out.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <contact/hard_sphere_run.hpp>
#include <contact/hard_sphere_setup.hpp>
#include <contact/hard_spheres.hpp>

namespace contact {

/// Effects that a setup calls for, and the axes along which something can move.
struct HardSphereComposition {
  HardSphereEffects effects;         ///< those that are on
  std::array<int, 3> axes{0, 1, 2};  ///< the first `effects.dimension` count
};

namespace detail {

/// Whether nothing ever moves along an axis: no gravity and no velocity along it, all centres at
/// one place of it, so that no push of two balls has a part along it, and each wall square to the
/// axis or along it, so that no wall's push has one unless something moves along it.
inline bool nothing_moves_along(const HardSphereSetup& setup, int axis) {
  if (setup.gravity(axis) != 0) return false;
  for (const HardBall& ball : setup.balls) {
    if (ball.velocity(axis) != 0) return false;
    if (ball.position(axis) != setup.balls.front().position(axis)) return false;
  }
  for (const HardWall& wall : setup.walls)
    if (wall.normal(axis) != 0 && wall.normal(axis) != 1 && wall.normal(axis) != -1) return false;
  return true;
}

}  // namespace detail

// [compose]
/// Which effects a setup calls for. An effect is off where it is proved that it does nothing: the
/// run has the same bits as one with all effects.
///
/// The grid is no effect, but a way to ask; with few balls asking everybody is quicker.
inline HardSphereComposition compose_hard_spheres(const HardSphereSetup& setup) {
  require_hard_sphere_setup(setup);
  HardSphereComposition made;
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (!detail::nothing_moves_along(setup, axis))
      made.axes[static_cast<std::size_t>(count++)] = axis;
  if (count == 0) made.axes[static_cast<std::size_t>(count++)] = 0;
  HardSphereEffects& on = made.effects;
  on.dimension = count;
  on.gravity = !setup.gravity.isZero(0);
  on.radii = on.masses = on.restitution = false;
  for (const HardBall& ball : setup.balls) {
    on.radii = on.radii || ball.radius != setup.balls.front().radius;
    on.masses = on.masses || (ball.moves && ball.mass != setup.balls.front().mass);
  }
  for (const double e : setup.restitution) on.restitution = on.restitution || e != 1;
  on.grid = setup.balls.size() > 24;
  return made;
}
// [/compose]

namespace detail {

/// All compositions, numbered.
constexpr std::size_t hard_sphere_compositions = 96;

constexpr HardSphereEffects numbered_effects(std::size_t number) {
  return {static_cast<int>(number / 32) + 1,
          (number & 1) != 0,
          (number & 2) != 0,
          (number & 4) != 0,
          (number & 8) != 0,
          (number & 16) != 0};
}

template <std::size_t Number>
std::unique_ptr<HardSphereRun> make_numbered(const HardSphereSetup& setup,
                                             const std::array<int, 3>& axes) {
  return std::make_unique<HardSpheres<numbered_effects(Number)>>(setup, axes);
}

template <std::size_t... Number>
constexpr auto makers(std::index_sequence<Number...> /*numbers*/) {
  return std::array{&make_numbered<Number>...};
}

}  // namespace detail

/// A run with a composition.
/// @throws std::invalid_argument if the setup is none, or calls for an effect that is off
inline std::unique_ptr<HardSphereRun> make_hard_spheres(const HardSphereSetup& setup,
                                                        const HardSphereComposition& composition) {
  constexpr auto all = detail::makers(std::make_index_sequence<detail::hard_sphere_compositions>());
  for (std::size_t number = 0; number < all.size(); ++number)
    if (detail::numbered_effects(number) == composition.effects)
      return all[number](setup, composition.axes);
  throw_invalid_argument("dimension", std::to_string(composition.effects.dimension),
                         "must be 1, 2 or 3");
}

/// A run with the least composition.
/// @throws std::invalid_argument if the setup is none
inline std::unique_ptr<HardSphereRun> make_hard_spheres(const HardSphereSetup& setup) {
  return make_hard_spheres(setup, compose_hard_spheres(setup));
}

}  // namespace contact
