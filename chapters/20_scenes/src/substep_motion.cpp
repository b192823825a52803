#include <contact/stepped/substep_motion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stage_motion.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE Quaternion<double> orientation_at(const SteppedSetup& setup,
                                                        const SteppedState& state,
                                                        const Substep& substep, std::size_t slot,
                                                        double t) {
  return setup.gyroscopic ? rotated_freely(setup, state, substep, slot, t)
                          : rotated_uniformly(state, substep, slot, t);
}

CONTACT_SCENES_INLINE Vector3<double> angular_velocity_at(const SteppedSetup& setup,
                                                          const SteppedState& state,
                                                          const Substep& substep, std::size_t slot,
                                                          double t,
                                                          const Quaternion<double>& orientation) {
  const Vector3<double> mean = mean_angular_velocity(state, substep, slot, t);
  if (!setup.gyroscopic || setup.bodies[slot].round)
    return contact_angular_velocity(state, substep, slot, t);
  const SteppedBody& body = setup.bodies[slot];
  const Vector3<double> momentum = angular_momentum_of(body, state.orientation[slot], mean);
  const Vector3<double> pushed = contact_angular_velocity(state, substep, slot, t) - mean;
  return pushed + free_angular_velocity<double>(
                      momentum, body.moments, Matrix3<double>(matrix_of(orientation) * body.axes));
}

/// Bounds the acceleration by rotation of a point at the distance r from the centre. A constant
/// angular velocity gives ω² r; a torque adds dω/dt r. Without torque the angular velocity may
/// still change: by Euler's equations no faster than ω²/√3 times the largest |I₂ − I₃|/I₁, and by
/// its energy ω² grows by at most the ratio of its moments, and by less without torque.
CONTACT_SCENES_INLINE void bound_swing(const SteppedSetup& setup, const SteppedState& state,
                                       const Substep& substep, std::size_t slot,
                                       SubstepMotion& motion) {
  const SteppedBody& body = setup.bodies[slot];
  const Vector3<double> first = mean_angular_velocity(state, substep, slot, 0);
  const Vector3<double>& last = substep.end_angular_velocity[slot];
  double square = std::max(first.dot(first), last.dot(last));
  double push = size_of(last - first) / substep.planned;
  double own = 0;
  if (setup.gyroscopic && !body.round) {
    const Vector3<double>& m = body.moments;
    const double ratio = m.maxCoeff() / m.minCoeff();
    square = first == last ? largest_free_square(body, orientation_of(setup, state, slot), first)
                           : square * ratio;
    push *= ratio;
    const Vector3<double> apart(m.y() - m.z(), m.z() - m.x(), m.x() - m.y());
    own = square * apart.cwiseAbs().cwiseQuotient(m).maxCoeff() / std::sqrt(3.0);
  }
  motion.turns = square > 0;
  motion.unforeseen = push * std::sqrt(square) * substep.planned * body.rotation_radius;
  motion.swing = (square + own + push) * body.rotation_radius + motion.unforeseen;
}

CONTACT_SCENES_INLINE SubstepMotion substep_motion(const SteppedSetup& setup,
                                                   const SteppedState& state,
                                                   const Substep& substep, std::size_t slot) {
  SubstepMotion motion;
  motion.position = position_of(setup, state, slot);
  if (slot >= setup.movers || sleeps(state, slot)) return motion;
  motion.velocity = first_velocity(state, substep, slot);
  motion.acceleration = (substep.end_velocity[slot] - motion.velocity) / substep.planned;
  if (setup.rotation && setup.bodies[slot].rotation_radius > 0)
    bound_swing(setup, state, substep, slot, motion);
  return motion;
}

CONTACT_SCENES_INLINE MovedBody moved_body(const SteppedSetup& setup, const SteppedState& state,
                                           const Substep& substep, std::size_t slot,
                                           const SubstepMotion& motion, double t) {
  MovedBody body;
  body.centre = motion.position_at(t);
  body.velocity = motion.velocity + motion.acceleration * t;
  body.unforeseen = motion.unforeseen * t;
  Quaternion<double> orientation = orientation_of(setup, state, slot);
  if (motion.turns) {
    orientation = orientation_at(setup, state, substep, slot, t);
    body.angular_velocity = angular_velocity_at(setup, state, substep, slot, t, orientation);
  }
  body.shape = shape_in_world(setup.bodies[slot], body.centre, orientation);
  return body;
}

}  // namespace detail

}  // namespace contact
