/// @file
/// A stage: which of the near pairs touch, and where.
#pragma once

#include <concepts>
#include <cstddef>
#include <variant>

#include <contact/contact_manifold.hpp>
#include <contact/contact_world.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/frame.hpp>
#include <contact/inertia.hpp>
#include <contact/pose.hpp>
#include <contact/quaternion.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/hull_contact.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A hull in its body's pose.
HullVertices transformed(const HullVertices& shape, const CoordinateFrame<double>& frame);

/// Whether there is a narrow phase for two shapes: for all except two half-spaces, and a half-space
/// before a hull. A half-space is always the second of a pair.
template <class A, class B>
inline constexpr bool has_narrow_phase =
    !(std::same_as<A, HalfSpace<double>> &&
      (std::same_as<B, HalfSpace<double>> || std::same_as<B, HullVertices>));

/// The signed distance of two shapes in the world; infinite if there is no narrow phase for them.
SignedDistance<double> signed_distance_of_shapes(const StepShape& a, const StepShape& b);

/// The points at which two shapes are at most the margin apart; of a hull and another bounded body
/// those of face_contact().
ContactManifold<double> manifold_of_shapes(const StepShape& a, const StepShape& b, double margin);

/// A body's shape in its present pose.
inline StepShape shape_in_world(const SteppedBody& body, const Vector3<double>& position,
                                const Quaternion<double>& orientation) {
  const auto frame = frame_of<double>({position, orientation});
  return std::visit([&](const auto& shape) { return StepShape(transformed(shape, frame)); },
                    body.shape);
}

/// The velocity of a body's point, m/s.
Vector3<double> point_velocity(const SteppedSetup& setup, const SteppedState& state,
                               std::size_t slot, const Vector3<double>& point);

/// The speed of separation of two bodies at a point, along the normal from b to a, m/s.
inline double separation_speed(const SteppedSetup& setup, const SteppedState& state,
                               const NearPair& pair, const Vector3<double>& point) {
  return pair.manifold.normal.dot(Vector3<double>(point_velocity(setup, state, pair.a, point) -
                                                  point_velocity(setup, state, pair.b, point)));
}

/// The longest substep in which all bodies rotate with their final angular velocities without
/// rotating through a body that they may touch; s.
double longest_rotation(const SteppedSetup& setup, const Substep& substep);

/// The narrow phase: the distance of each pair, whether it touches, and its contact points.
///
/// A touching pair also includes points that may come to touch in this substep. A pair that
/// separates at every contact point is leaving. A body that rotates in contact is tested again
/// before it has rotated by a sixteenth of a radian, or has penetrated the thinner body by a
/// quarter of its thickness.
void find_touching_pairs(const SteppedSetup& setup, SteppedState& state, Substep& substep);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_contacts.cpp"
#endif
