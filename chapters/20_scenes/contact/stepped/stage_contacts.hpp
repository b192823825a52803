/// @file
/// A stage: which of the near pairs touch, and where.
#pragma once

#include <concepts>
#include <cstddef>
#include <variant>

#include <contact/contact_manifold.hpp>
#include <contact/contact_world.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/gap.hpp>
#include <contact/inertia.hpp>
#include <contact/rotation.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A hull where its body is.
HullCorners placed(const HullCorners& shape, const Vector3<double>& position,
                   const Matrix3<double>& rotation);

/// Whether there is a narrow phase for two shapes: for all but a hull with anything else than a
/// half-space, and two half-spaces.
template <class A, class B>
inline constexpr bool has_narrow_phase =
    std::same_as<A, HullCorners>
        ? std::same_as<B, HalfSpace<double>>
        : !std::same_as<B, HullCorners> &&
              !(std::same_as<A, HalfSpace<double>> && std::same_as<B, HalfSpace<double>>);

/// The gap of two shapes in the world; endlessly far apart if there is no narrow phase for them.
Gap<double> gap_of_shapes(const StepShape& a, const StepShape& b);

/// The points at which two shapes are at most the margin apart.
ContactManifold<double> manifold_of_shapes(const StepShape& a, const StepShape& b, double margin);

/// A body's shape where it is now.
inline StepShape shape_in_world(const SteppedBody& body, const Vector3<double>& position,
                                const Rotor<double>& orientation) {
  const Matrix3<double> turn = matrix_of(orientation);
  return std::visit([&](const auto& shape) { return StepShape(placed(shape, position, turn)); },
                    body.shape);
}

/// The velocity of a body's point, m/s.
Vector3<double> point_velocity(const SteppedSetup& setup, const SteppedState& state,
                               std::size_t place, const Vector3<double>& point);

/// How fast two bodies come apart at a point, along the normal from b to a, m/s.
inline double parting_speed(const SteppedSetup& setup, const SteppedState& state,
                            const NearPair& pair, const Vector3<double>& point) {
  return pair.manifold.normal.dot(Vector3<double>(point_velocity(setup, state, pair.a, point) -
                                                  point_velocity(setup, state, pair.b, point)));
}

/// How long a part may be in which everybody turns as at its end, so that nobody turns through
/// whom it may touch; s.
double longest_turn(const SteppedSetup& setup, const StepPart& part);

/// The narrow phase: how far each pair is apart, whether it touches, and at which points.
///
/// Of a pair that touches, points that may come to touch in this part belong to it too. A pair that
/// parts at every point where it touches is on its way out. A body that turns while it touches
/// something is looked at again before it has turned by a sixteenth of a radian, or has come a
/// quarter into the thinner one by that.
void find_touching_pairs(const SteppedSetup& setup, SteppedState& state, StepPart& part);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_contacts.cpp"
#endif
