#include <contact/events/hard_sphere_compose.hpp>

#include <cstddef>

#include <contact/events/hard_sphere_run.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/scene/compiled.hpp>

namespace contact {

namespace detail {

/// Whether no ball ever moves along an axis: no gravity and no velocity along it, all centres at
/// the same coordinate, so that no impulse between balls has a component along it, and each wall
/// perpendicular or parallel to the axis, so that no wall's impulse has one unless a ball moves
/// along it.
CONTACT_SCENES_INLINE bool nothing_moves_along(const HardSphereSetup& setup, int axis) {
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
CONTACT_SCENES_INLINE HardSphereComposition compose_hard_spheres(const HardSphereSetup& setup) {
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
  on.sizes = on.restitution = false;
  for (const HardBall& ball : setup.balls) {
    on.sizes = on.sizes || ball.radius != setup.balls.front().radius ||
               (ball.moves && ball.mass != setup.balls.front().mass);
  }
  for (const double e : setup.restitution) on.restitution = on.restitution || e != 1;
  on.grid = setup.balls.size() > cost::max_balls_without_cells;
  return made;
}
// [/compose]

}  // namespace contact
