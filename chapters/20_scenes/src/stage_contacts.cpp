#include <contact/stepped/stage_contacts.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/convex_bodies.hpp>
#include <contact/frame.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/hull_contact.hpp>
#include <contact/stepped/stage_pairs.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE HullVertices transformed(const HullVertices& shape,
                                               const CoordinateFrame<double>& frame) {
  HullVertices moved;
  moved.points.reserve(shape.points.size());
  for (const Vector3<double>& point : shape.points)
    moved.points.push_back(position_in_world(frame, point));
  return moved;
}

namespace detail {

/// A hull as a convex body; other shapes are convex bodies already.
CONTACT_SCENES_INLINE ConvexHull<double> convex_body(const HullVertices& shape) {
  return {shape.points, 0};
}
template <class Shape>
const Shape& convex_body(const Shape& shape) {
  return shape;
}

/// Whether one of two shapes is a hull, and none a half-space.
template <class A, class B>
inline constexpr bool hull_meets_body =
    (std::same_as<A, HullVertices> ||
     std::same_as<B, HullVertices>)&&!std::same_as<A, HalfSpace<double>> &&
    !std::same_as<B, HalfSpace<double>>;

}  // namespace detail

CONTACT_SCENES_INLINE SignedDistance<double> signed_distance_of_shapes(const StepShape& a,
                                                                       const StepShape& b) {
  return std::visit(
      [](const auto& one, const auto& other) -> SignedDistance<double> {
        using A = std::decay_t<decltype(one)>;
        using B = std::decay_t<decltype(other)>;
        if constexpr (!has_narrow_phase<A, B>) {
          SignedDistance<double> none;
          none.distance = std::numeric_limits<double>::infinity();
          return none;
        } else if constexpr (detail::hull_meets_body<A, B>) {
          return signed_distance(detail::convex_body(one), detail::convex_body(other));
        } else if constexpr (std::same_as<A, HullVertices>) {
          return signed_distance<double>(one.points, 0.0, other);
        } else {
          return signed_distance(one, other);
        }
      },
      a, b);
}

CONTACT_SCENES_INLINE ContactManifold<double> manifold_of_shapes(const StepShape& a,
                                                                 const StepShape& b,
                                                                 double margin) {
  return std::visit(
      [&](const auto& one, const auto& other) -> ContactManifold<double> {
        using A = std::decay_t<decltype(one)>;
        using B = std::decay_t<decltype(other)>;
        ContactManifold<double> manifold;
        if constexpr (!has_narrow_phase<A, B>) {
          return manifold;
        } else if constexpr (detail::hull_meets_body<A, B>) {
          const auto& first = detail::convex_body(one);
          const auto& second = detail::convex_body(other);
          return face_contact(core_vertices(first), core_vertices(second),
                              radius_of(first) + radius_of(second), signed_distance(first, second),
                              margin);
        } else if constexpr (std::same_as<A, HullVertices>) {
          manifold.normal = other.boundary.normal;
          for (const Vector3<double>& point : one.points) {
            const double distance = signed_distance(other.boundary, point);
            if (distance <= margin)
              manifold.points.push_back(
                  {Vector3<double>(point - manifold.normal * (distance / 2)), distance});
          }
          return manifold;
        } else {
          return contact_manifold(one, other, margin);
        }
      },
      a, b);
}

CONTACT_SCENES_INLINE Vector3<double> point_velocity(const SteppedSetup& setup,
                                                     const SteppedState& state, std::size_t slot,
                                                     const Vector3<double>& point) {
  const Vector3<double> v = velocity_of(setup, state, slot);
  if (!rotated_by_contacts(setup, slot)) return v;
  const Vector3<double> lever_arm = point - position_of(setup, state, slot);
  return v + Vector3<double>(state.angular_velocity[slot].cross(lever_arm));
}

namespace detail {

CONTACT_SCENES_INLINE void place_shapes(const SteppedSetup& setup, const SteppedState& state,
                                        Substep& substep) {
  substep.shapes.resize(setup.bodies.size());
  std::vector<bool> done(setup.bodies.size(), false);
  for (const NearPair& pair : substep.pairs) {
    for (const std::size_t i : {pair.a, pair.b}) {
      if (done[i]) continue;
      done[i] = true;
      substep.shapes[i] = shape_in_world(setup.bodies[i], position_of(setup, state, i),
                                         orientation_of(setup, state, i));
    }
  }
}

/// The contact points of a touching pair; at least the nearest one.
CONTACT_SCENES_INLINE ContactManifold<double> manifold_with_gap(const StepShape& a,
                                                                const StepShape& b,
                                                                const SignedDistance<double>& gap,
                                                                const NearPair& pair) {
  ContactManifold<double> manifold =
      manifold_of_shapes(a, b, std::max(pair.near, pair.closing_distance));
  for (const auto& point : manifold.points)
    if (point.distance <= std::max(gap.distance, 0.0) + pair.touch) return manifold;
  manifold.normal = gap.normal;
  manifold.points = {{Vector3<double>((gap.on_a + gap.on_b) / 2), gap.distance}};
  return manifold;
}

/// A distance that rounding cannot distinguish from touching.
CONTACT_SCENES_INLINE double touching_distance(const SteppedSetup& setup, const SteppedState& state,
                                               const NearPair& pair) {
  double size = position_of(setup, state, pair.a).cwiseAbs().maxCoeff() +
                setup.bodies[pair.a].bounding_radius;
  if (pair.b < setup.bounded)
    size += position_of(setup, state, pair.b).cwiseAbs().maxCoeff() +
            setup.bodies[pair.b].bounding_radius;
  return 0x1p-40 * size;
}

/// The angle by which a body of a pair may rotate so that its points move at most a quarter of half
/// the thickness of the thinner one.
CONTACT_SCENES_INLINE double turn_of_core(const SteppedSetup& setup, const NearPair& pair,
                                          std::size_t slot) {
  const double core = std::min(setup.bodies[pair.a].core, setup.bodies[pair.b].core);
  return core / 4 / setup.bodies[slot].rotation_radius;
}

/// For each mover, a bound on the error of its velocity that the contact forces of the last substep
/// left, m/s: the residual at which the solver ends, and rounding. Where a heavy body lies on a
/// light one, it is more than SteppedSetup::slow_speed. Empty if no contact pushed.
CONTACT_SCENES_INLINE std::vector<double> rounding_of_forces(const SteppedSetup& setup,
                                                             const SteppedState& state) {
  std::vector<double> rounding;
  if (!state.touched.empty()) rounding.resize(setup.movers, 0);
  for (std::size_t i = 0; i < state.touched.size(); ++i) {
    for (const int body : {state.touched[i].a, state.touched[i].b}) {
      const auto slot = static_cast<std::size_t>(body);
      if (slot >= setup.movers) continue;
      if (rounding[slot] == 0) rounding[slot] = setup.solver.tolerance;
      const SteppedBody& solid = setup.bodies[slot];
      double inverse_effective_mass = 1 / solid.mass;
      if (rotated_by_contacts(setup, slot))
        inverse_effective_mass +=
            solid.rotation_radius * solid.rotation_radius / solid.moments.minCoeff();
      rounding[slot] += rounding_of_impulses * state.last_impulses[i].normal * setup.step *
                        inverse_effective_mass;
    }
  }
  return rounding;
}

}  // namespace detail

CONTACT_SCENES_INLINE double longest_rotation(const SteppedSetup& setup, const Substep& substep) {
  double longest = substep.planned;
  for (const NearPair& pair : substep.pairs) {
    if (pair.material.stiffness || pair.manifold.points.empty()) continue;
    for (const std::size_t i : {pair.a, pair.b}) {
      if (i >= substep.end_angular_velocity.size() || !(setup.bodies[i].rotation_radius > 0))
        continue;
      const double turns = size_of(substep.end_angular_velocity[i]);
      const double most = detail::turn_of_core(setup, pair, i);
      if (turns * longest > most) longest = most / turns;
    }
  }
  return longest;
}

// [contacts-stage]
CONTACT_SCENES_INLINE void find_touching_pairs(const SteppedSetup& setup, SteppedState& state,
                                               Substep& substep) {
  detail::place_shapes(setup, state, substep);
  const std::vector<double> rounding = detail::rounding_of_forces(setup, state);
  for (NearPair& pair : substep.pairs) {
    const StepShape& a = substep.shapes[pair.a];
    const StepShape& b = substep.shapes[pair.b];
    pair.touch = detail::touching_distance(setup, state, pair);
    double wrong = 0;
    for (const std::size_t i : {pair.a, pair.b})
      if (i < rounding.size()) wrong = std::max(wrong, rounding[i]);
    pair.slow = std::max(setup.slow_speed, wrong);
    pair.near = pair.touch + wrong * setup.step;
    // Without continuous detection only the distance that gravity closes in a step: so resting
    // bodies stay in contact.
    pair.closing_distance = setup.continuous
                                ? detail::pair_closing_distance(setup, state, substep, pair)
                                : size_of(setup.scene.gravity) * substep.left * substep.left;
    if (substep.simultaneous) {
      pair.manifold = manifold_of_shapes(a, b, std::max(pair.touch, pair.closing_distance));
      pair.distance = std::numeric_limits<double>::infinity();
      for (const auto& point : pair.manifold.points)
        pair.distance = std::min(pair.distance, point.distance);
    } else {
      const SignedDistance<double> gap = signed_distance_of_shapes(a, b);
      pair.distance = gap.distance;
      if (pair.distance <= pair.near) pair.manifold = detail::manifold_with_gap(a, b, gap, pair);
    }
    pair.touching = pair.distance <= pair.near;
    if (!pair.touching) continue;
    if (!pair.material.stiffness)
      state.counts.largest_overlap = std::max(state.counts.largest_overlap, -pair.distance);
    pair.leaving = true;
    for (const auto& point : pair.manifold.points) {
      if (point.distance <= pair.near &&
          !(separation_speed(setup, state, pair, point.point) > pair.slow))
        pair.leaving = false;
    }
    for (const std::size_t i : {pair.a, pair.b}) {
      const double turns = size_of(angular_velocity_of(state, i));
      if (i >= setup.movers || !(setup.bodies[i].rotation_radius > 0)) continue;
      const double most = std::min(0x1p-4, detail::turn_of_core(setup, pair, i));
      if (turns * substep.length > most) substep.planned = substep.length = most / turns;
    }
  }
}
// [/contacts-stage]

}  // namespace contact
