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
#include <contact/gap.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/stepped/stage_pairs.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE HullCorners placed(const HullCorners& shape, const Vector3<double>& position,
                                         const Matrix3<double>& rotation) {
  HullCorners moved;
  moved.points.reserve(shape.points.size());
  for (const Vector3<double>& point : shape.points)
    moved.points.push_back(position + rotation * point);
  return moved;
}

CONTACT_SCENES_INLINE Gap<double> gap_of_shapes(const StepShape& a, const StepShape& b) {
  return std::visit(
      [](const auto& one, const auto& other) -> Gap<double> {
        using A = std::decay_t<decltype(one)>;
        using B = std::decay_t<decltype(other)>;
        if constexpr (!has_narrow_phase<A, B>) {
          Gap<double> none;
          none.distance = std::numeric_limits<double>::infinity();
          return none;
        } else if constexpr (std::same_as<A, HullCorners>) {
          return gap<double>(one.points, 0.0, other);
        } else {
          return gap(one, other);
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
        } else if constexpr (std::same_as<A, HullCorners>) {
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
                                                     const SteppedState& state, std::size_t place,
                                                     const Vector3<double>& point) {
  const Vector3<double> v = velocity_of(setup, state, place);
  if (!turned_by_contacts(setup, place)) return v;
  const Vector3<double> arm = point - position_of(setup, state, place);
  return v + Vector3<double>(state.spin[place].cross(arm));
}

namespace detail {

CONTACT_SCENES_INLINE void place_shapes(const SteppedSetup& setup, const SteppedState& state,
                                        StepPart& part) {
  part.shapes.resize(setup.bodies.size());
  std::vector<bool> done(setup.bodies.size(), false);
  for (const NearPair& pair : part.pairs) {
    for (const std::size_t i : {pair.a, pair.b}) {
      if (done[i]) continue;
      done[i] = true;
      part.shapes[i] = shape_in_world(setup.bodies[i], position_of(setup, state, i),
                                      orientation_of(setup, state, i));
    }
  }
}

/// The contact points of a touching pair; at least the nearest one.
CONTACT_SCENES_INLINE ContactManifold<double> manifold_with_gap(const StepShape& a,
                                                                const StepShape& b,
                                                                const Gap<double>& gap,
                                                                const NearPair& pair) {
  ContactManifold<double> manifold = manifold_of_shapes(a, b, std::max(pair.near, pair.reach));
  for (const auto& point : manifold.points)
    if (point.distance <= std::max(gap.distance, 0.0) + pair.touch) return manifold;
  manifold.normal = gap.normal;
  manifold.points = {{Vector3<double>((gap.on_a + gap.on_b) / 2), gap.distance}};
  return manifold;
}

/// A distance that rounding cannot distinguish from touching.
CONTACT_SCENES_INLINE double touching_distance(const SteppedSetup& setup, const SteppedState& state,
                                               const NearPair& pair) {
  double size =
      position_of(setup, state, pair.a).cwiseAbs().maxCoeff() + setup.bodies[pair.a].reach;
  if (pair.b < setup.bounded)
    size += position_of(setup, state, pair.b).cwiseAbs().maxCoeff() + setup.bodies[pair.b].reach;
  return 0x1p-40 * size;
}

/// The angle by which a body of a pair may rotate so that its points move at most a quarter of half
/// the thickness of the thinner one.
CONTACT_SCENES_INLINE double turn_of_core(const SteppedSetup& setup, const NearPair& pair,
                                          std::size_t place) {
  const double core = std::min(setup.bodies[pair.a].core, setup.bodies[pair.b].core);
  return core / 4 / setup.bodies[place].spin_arm;
}

/// For each mover, a bound on the error of its velocity that the contact forces of the last substep
/// left, m/s. Where a heavy body lies on a light one, it is more than SteppedSetup::slow_speed.
/// Empty if no contact pushed.
CONTACT_SCENES_INLINE std::vector<double> rounding_of_forces(const SteppedSetup& setup,
                                                             const SteppedState& state) {
  std::vector<double> rounding;
  if (!state.touched.empty()) rounding.resize(setup.movers, 0);
  for (std::size_t i = 0; i < state.touched.size(); ++i) {
    for (const int body : {state.touched[i].a, state.touched[i].b}) {
      const auto place = static_cast<std::size_t>(body);
      if (place >= setup.movers) continue;
      const SteppedBody& solid = setup.bodies[place];
      double response = 1 / solid.mass;
      if (turned_by_contacts(setup, place))
        response += solid.spin_arm * solid.spin_arm / solid.moments.minCoeff();
      rounding[place] += rounding_of_impulses * state.pushed[i].normal * setup.step * response;
    }
  }
  return rounding;
}

}  // namespace detail

CONTACT_SCENES_INLINE double longest_turn(const SteppedSetup& setup, const StepPart& part) {
  double longest = part.planned;
  for (const NearPair& pair : part.pairs) {
    if (pair.material.stiffness || pair.manifold.points.empty()) continue;
    for (const std::size_t i : {pair.a, pair.b}) {
      if (i >= part.end_spin.size() || !(setup.bodies[i].spin_arm > 0)) continue;
      const double turns = size_of(part.end_spin[i]);
      const double most = detail::turn_of_core(setup, pair, i);
      if (turns * longest > most) longest = most / turns;
    }
  }
  return longest;
}

// [contacts-stage]
CONTACT_SCENES_INLINE void find_touching_pairs(const SteppedSetup& setup, SteppedState& state,
                                               StepPart& part) {
  detail::place_shapes(setup, state, part);
  const std::vector<double> rounding = detail::rounding_of_forces(setup, state);
  for (NearPair& pair : part.pairs) {
    const StepShape& a = part.shapes[pair.a];
    const StepShape& b = part.shapes[pair.b];
    pair.touch = detail::touching_distance(setup, state, pair);
    double wrong = 0;
    for (const std::size_t i : {pair.a, pair.b})
      if (i < rounding.size()) wrong = std::max(wrong, rounding[i]);
    pair.slow = std::max(setup.slow_speed, wrong);
    pair.near = pair.touch + wrong * setup.step;
    // Without continuous detection only the distance that gravity closes in a step: so resting
    // bodies stay in contact.
    pair.reach = setup.continuous ? detail::pair_reach(setup, state, part, pair)
                                  : size_of(setup.scene.gravity) * part.left * part.left;
    if (part.at_once) {
      pair.manifold = manifold_of_shapes(a, b, std::max(pair.touch, pair.reach));
      pair.distance = std::numeric_limits<double>::infinity();
      for (const auto& point : pair.manifold.points)
        pair.distance = std::min(pair.distance, point.distance);
    } else {
      const Gap<double> gap = gap_of_shapes(a, b);
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
          !(parting_speed(setup, state, pair, point.point) > pair.slow))
        pair.leaving = false;
    }
    for (const std::size_t i : {pair.a, pair.b}) {
      const double turns = size_of(spin_of(state, i));
      if (i >= setup.movers || !(setup.bodies[i].spin_arm > 0)) continue;
      const double most = std::min(0x1p-4, detail::turn_of_core(setup, pair, i));
      if (turns * part.length > most) part.planned = part.length = most / turns;
    }
  }
}
// [/contacts-stage]

}  // namespace contact
