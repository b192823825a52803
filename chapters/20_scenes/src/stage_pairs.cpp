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

/// Whether a box reaches into the half-space with that index in the list of bodies.
CONTACT_SCENES_INLINE bool reaches_wall(const SteppedSetup& setup, std::size_t slot,
                                        const Aabb<double>& box) {
  const auto& wall = std::get<HalfSpace<double>>(setup.bodies[slot].shape).boundary;
  double lowest = -wall.offset;  // of the box's vertices
  for (int axis = 0; axis < 3; ++axis) {
    const double n = wall.normal(axis);
    lowest += n * (n > 0 ? box.low(axis) : box.high(axis));
  }
  return lowest <= 0;
}

CONTACT_SCENES_INLINE void record_pairs(const SteppedSetup& setup, const SteppedState& state,
                                        Substep& substep, std::span<const Aabb<double>> boxes,
                                        std::vector<BoxPair> found) {
  const auto bounded = static_cast<std::ptrdiff_t>(found.size());
  for (std::size_t i = 0; i < setup.movers; ++i) {
    for (std::size_t k = setup.bounded; k < setup.bodies.size(); ++k) {
      if (reaches_wall(setup, k, boxes[i]))
        found.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)});
    }
  }
  std::inplace_merge(found.begin(), found.begin() + bounded, found.end());
  substep.pairs.clear();
  substep.pairs.reserve(found.size());
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

namespace detail {

/// Boxes in the order of their lower ends along x: a search for those that touch a box leaves out
/// the ones that end before it or begin after it.
struct BoxesAlongX {
  std::vector<Aabb<double>> boxes;
  std::vector<std::size_t> order;
  std::vector<double> begins;  ///< of each, in this order
  std::vector<double> ends;    ///< the largest upper end of the boxes so far, in this order
};

CONTACT_SCENES_INLINE BoxesAlongX boxes_along_x(const SteppedSetup& setup,
                                                const SteppedState& state, const Substep& substep) {
  BoxesAlongX all;
  const std::size_t n = setup.bounded;
  all.boxes.reserve(n);
  all.order.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    all.boxes.push_back(swept_box(setup, state, substep, i));
    all.order[i] = i;
  }
  // Without an order of its ends, each is compared with all.
  if (!std::all_of(all.boxes.begin(), all.boxes.end(), is_box<double>)) return all;
  std::sort(all.order.begin(), all.order.end(), [&](std::size_t i, std::size_t k) {
    return all.boxes[i].low.x() < all.boxes[k].low.x();
  });
  all.begins.reserve(n);
  all.ends.reserve(n);
  for (const std::size_t i : all.order) {
    all.begins.push_back(all.boxes[i].low.x());
    const double end = all.boxes[i].high.x();
    all.ends.push_back(all.ends.empty() ? end : std::max(all.ends.back(), end));
  }
  return all;
}

/// The bodies whose boxes may touch that of a body: a part of the order.
CONTACT_SCENES_INLINE std::span<const std::size_t> beside(const BoxesAlongX& all,
                                                          std::size_t slot) {
  if (all.begins.empty()) return all.order;
  const Aabb<double>& box = all.boxes[slot];
  const auto first = std::lower_bound(all.ends.begin(), all.ends.end(), box.low.x());
  const auto last = std::upper_bound(all.begins.begin(), all.begins.end(), box.high.x());
  const auto from = static_cast<std::size_t>(first - all.ends.begin());
  const auto to = static_cast<std::size_t>(last - all.begins.begin());
  return std::span(all.order).subspan(from, to - from);
}

/// Whether a pair has a contact in this substep already, or a spring.
CONTACT_SCENES_INLINE bool is_known(const Substep& substep, std::size_t a, std::size_t b) {
  const auto before = [](const NearPair& pair, const std::pair<std::size_t, std::size_t>& other) {
    return std::pair{pair.a, pair.b} < other;
  };
  const auto at =
      std::lower_bound(substep.pairs.begin(), substep.pairs.end(), std::pair{a, b}, before);
  return at != substep.pairs.end() && at->a == a && at->b == b &&
         (!at->manifold.points.empty() || at->material.stiffness);
}

}  // namespace detail

// [flung]
CONTACT_SCENES_INLINE bool deflected_at_others(const SteppedSetup& setup, const SteppedState& state,
                                               Substep& substep) {
  std::vector<std::size_t> farther;
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
    farther.push_back(i);
  }
  if (farther.empty()) return false;
  wider.left = substep.left;
  // Only pairs of these can be new, and one is enough.
  const detail::BoxesAlongX all = detail::boxes_along_x(setup, state, wider);
  const auto meets = [&](std::size_t i, std::size_t other) {
    NearPair pair;
    pair.a = std::min(i, other);
    pair.b = std::max(i, other);
    const bool still = pair.b >= setup.movers || sleeps(state, pair.b);
    return !(sleeps(state, pair.a) && still) && !detail::is_known(substep, pair.a, pair.b) &&
           detail::may_reach(setup, state, wider, pair);
  };
  const bool found = std::any_of(farther.begin(), farther.end(), [&](std::size_t i) {
    for (const std::size_t other : detail::beside(all, i))
      if (other != i && boxes_touch(all.boxes[i], all.boxes[other]) && meets(i, other)) return true;
    for (std::size_t k = setup.bounded; k < setup.bodies.size(); ++k)
      if (detail::reaches_wall(setup, k, all.boxes[i]) && meets(i, k)) return true;
    return false;
  });
  if (found) substep.deflection = wider.deflection;
  return found;
}
// [/flung]

}  // namespace contact
