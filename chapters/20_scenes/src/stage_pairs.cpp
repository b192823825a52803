#include <contact/stepped/stage_pairs.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/box_pairs.hpp>
#include <contact/capsule.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/frame.hpp>
#include <contact/grid_pairs.hpp>
#include <contact/inertia.hpp>
#include <contact/oriented_box.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/pose.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE Aabb<double> box_of(const Sphere<double>& shape,
                                          const CoordinateFrame<double>& frame, double) {
  return aabb_of_sphere<double>({frame.origin, shape.radius});
}

CONTACT_SCENES_INLINE Aabb<double> box_of(const Capsule<double>& shape,
                                          const CoordinateFrame<double>& frame, double) {
  return aabb_of_capsule(transformed(shape, frame));
}

CONTACT_SCENES_INLINE Aabb<double> box_of(const OrientedBox<double>& shape,
                                          const CoordinateFrame<double>& frame, double) {
  return aabb_of_oriented_box<double>({frame.origin, frame.axes, shape.half_lengths});
}

template <class Shape>
Aabb<double> box_of(const Shape&, const CoordinateFrame<double>& frame, double radius) {
  return aabb_of_sphere<double>({frame.origin, radius});
}

}  // namespace detail

// [sweeping-room]
CONTACT_SCENES_INLINE double swept_margin(const SteppedSetup& setup, const SteppedState& state,
                                          const Substep& substep, std::size_t slot) {
  const double t = substep.left;
  const double turned =
      size_of(angular_velocity_of(state, slot)) * setup.bodies[slot].rotation_radius * t;
  const double size =
      position_of(setup, state, slot).cwiseAbs().maxCoeff() + setup.bodies[slot].bounding_radius;
  const double deflection = slot < substep.deflection.size() ? substep.deflection[slot] : 0.0;
  return size_of(setup.scene.gravity) * t * t + turned + deflection + 0x1p-30 * size;
}

CONTACT_SCENES_INLINE Aabb<double> swept_box(const SteppedSetup& setup, const SteppedState& state,
                                             const Substep& substep, std::size_t slot) {
  const auto frame =
      frame_of<double>({position_of(setup, state, slot), orientation_of(setup, state, slot)});
  const double radius = setup.bodies[slot].bounding_radius;
  const Aabb<double> box =
      std::visit([&](const auto& shape) { return detail::box_of(shape, frame, radius); },
                 setup.bodies[slot].shape);
  if (slot >= setup.movers) return box;
  return aabb_of_swept_box<double>(box, velocity_of(setup, state, slot) * substep.left,
                                   swept_margin(setup, state, substep, slot));
}
// [/sweeping-room]

namespace detail {

CONTACT_SCENES_INLINE void record_pairs(const SteppedSetup& setup, const SteppedState& state,
                                        Substep& substep, std::span<const Aabb<double>> boxes,
                                        std::vector<BoxPair> found) {
  for (std::size_t k = setup.bounded; k < setup.bodies.size(); ++k) {
    const auto& wall = std::get<HalfSpace<double>>(setup.bodies[k].shape).boundary;
    for (std::size_t i = 0; i < setup.movers; ++i) {
      double lowest = -wall.offset;  // of the box's vertices
      for (int axis = 0; axis < 3; ++axis) {
        const double n = wall.normal(axis);
        lowest += n * (n > 0 ? boxes[i].low(axis) : boxes[i].high(axis));
      }
      if (lowest <= 0)
        found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
    }
  }
  std::sort(found.begin(), found.end());
  substep.pairs.clear();
  for (const BoxPair& pair : found) {
    const bool still = pair.b >= setup.movers || sleeps(state, pair.b);
    if (pair.a >= setup.movers || (sleeps(state, pair.a) && still)) continue;
    NearPair near;
    near.a = pair.a;
    near.b = pair.b;
    near.material = setup.material[setup.bodies[pair.a].material * setup.scene.materials.size() +
                                   setup.bodies[pair.b].material];
    substep.pairs.push_back(near);
  }
}

CONTACT_SCENES_INLINE double pair_closing_distance(const SteppedSetup& setup,
                                                   const SteppedState& state,
                                                   const Substep& substep, const NearPair& pair) {
  const Vector3<double> relative =
      velocity_of(setup, state, pair.a) - velocity_of(setup, state, pair.b);
  double reach = size_of(relative) * substep.left + swept_margin(setup, state, substep, pair.a);
  if (pair.b < setup.movers) reach += swept_margin(setup, state, substep, pair.b);
  return reach;
}

/// Whether the bounding balls of two bodies may come to touch in the rest of the step.
CONTACT_SCENES_INLINE bool may_reach(const SteppedSetup& setup, const SteppedState& state,
                                     const Substep& substep, const NearPair& pair) {
  const double reach =
      pair_closing_distance(setup, state, substep, pair) + setup.bodies[pair.a].bounding_radius;
  const Vector3<double> slot = position_of(setup, state, pair.a);
  if (pair.b >= setup.bounded) {
    const auto& wall = std::get<HalfSpace<double>>(setup.bodies[pair.b].shape).boundary;
    return wall.normal.dot(slot) - wall.offset <= reach;
  }
  const Vector3<double> between = slot - position_of(setup, state, pair.b);
  return size_of(between) <= reach + setup.bodies[pair.b].bounding_radius;
}

}  // namespace detail

// [flung]
CONTACT_SCENES_INLINE bool deflected_at_others(const SteppedSetup& setup, SteppedState& state,
                                               Substep& substep, StepStage find) {
  std::vector<bool> farther(setup.movers, false);
  bool any = false;
  Substep wider;
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (!substep.contacted[i]) continue;
    double change = size_of(substep.end_velocity[i] - state.velocity[i]);
    if (i < substep.end_angular_velocity.size())
      change += size_of(substep.end_angular_velocity[i] - state.angular_velocity[i]) *
                setup.bodies[i].rotation_radius;
    const double way = change * substep.planned;
    if (way <= swept_margin(setup, state, substep, i) + max_deflection(setup)) continue;
    if (wider.deflection.empty()) wider.deflection = substep.deflection;
    wider.deflection.resize(setup.movers, 0.0);
    wider.deflection[i] = 2 * way;
    farther[i] = any = true;
  }
  if (!any) return false;
  wider.left = substep.left;
  const std::uint64_t counted = state.counts.pairs;
  find(setup, state, wider);
  state.counts.pairs = counted;
  const auto at = [&](const NearPair& pair) { return std::pair{pair.a, pair.b}; };
  std::size_t k = 0;
  bool found = false;
  for (const NearPair& pair : wider.pairs) {
    while (k < substep.pairs.size() && at(substep.pairs[k]) < at(pair)) ++k;
    const bool known = k < substep.pairs.size() && at(substep.pairs[k]) == at(pair);
    if (known && (!substep.pairs[k].manifold.points.empty() || substep.pairs[k].material.stiffness))
      continue;
    const bool deflection = farther[pair.a] || (pair.b < setup.movers && farther[pair.b]);
    found = found || (deflection && detail::may_reach(setup, state, wider, pair));
  }
  if (found) substep.deflection = wider.deflection;
  return found;
}
// [/flung]

}  // namespace contact
