#include "player_run.hpp"

#include <array>

#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_spheres.hpp>
#include <contact/scene/make_scene_run.hpp>

namespace contact::scenes {

namespace {

/// A page need not have every composition of hard balls. The effects that take most of a run's time
/// are left out where the scene does not need them: dimensions, gravity, the grid. Sizes and
/// restitution are always on; where they make no difference they change no bit.
template <int Dimension, bool Gravity, bool Grid>
std::unique_ptr<HardSphereRun> composed(const HardSphereSetup& setup,
                                        const std::array<int, 3>& axes) {
  constexpr HardSphereEffects effects{
      .dimension = Dimension, .gravity = Gravity, .sizes = true, .restitution = true, .grid = Grid};
  return std::make_unique<HardSpheres<effects>>(setup, axes);
}

std::unique_ptr<HardSphereRun> compose(const HardSphereSetup& setup) {
  constexpr std::array makers{
      &composed<1, false, false>, &composed<1, false, true>,  &composed<1, true, false>,
      &composed<1, true, true>,   &composed<2, false, false>, &composed<2, false, true>,
      &composed<2, true, false>,  &composed<2, true, true>,   &composed<3, false, false>,
      &composed<3, false, true>,  &composed<3, true, false>,  &composed<3, true, true>};
  const HardSphereComposition made = compose_hard_spheres(setup);
  const HardSphereEffects& on = made.effects;
  const std::size_t which =
      4 * static_cast<std::size_t>(on.dimension - 1) + (on.gravity ? 2 : 0) + (on.grid ? 1 : 0);
  return makers[which](setup, made.axes);
}

}  // namespace

std::unique_ptr<SceneRun> player_run(const Scene& scene, const Plan& plan) {
  return make_scene_run(scene, plan, &compose);
}

}  // namespace contact::scenes
