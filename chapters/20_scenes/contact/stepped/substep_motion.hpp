/// @file
/// The motion of bodies within one substep: constant acceleration, and the rotation of their stage.
#pragma once

#include <cstddef>

#include <contact/quaternion.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stage_motion.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The motion of a body in a substep: constant acceleration, and the rotation of its stage.
struct SubstepMotion {
  Vector3<double> position = Vector3<double>::Zero();
  Vector3<double> velocity = Vector3<double>::Zero();
  Vector3<double> acceleration = Vector3<double>::Zero();
  bool turns = false;     // false for a ball: it looks the same in every orientation
  double swing = 0;       // largest acceleration of a point of it by rotation, m/s²
  double unforeseen = 0;  // and by deviation from angular_velocity_at(), m/s²

  Vector3<double> position_at(double t) const {
    return position + (velocity + acceleration * (t / 2)) * t;
  }
};

/// Orientation of a mover after a time of the substep, bit for bit as its stage rotates it.
Quaternion<double> orientation_at(const SteppedSetup& setup, const SteppedState& state,
                                  const Substep& substep, std::size_t slot, double t);

/// Its angular velocity then, except for SubstepMotion::unforeseen.
Vector3<double> angular_velocity_at(const SteppedSetup& setup, const SteppedState& state,
                                    const Substep& substep, std::size_t slot, double t,
                                    const Quaternion<double>& orientation);

/// The motion of a body from its velocities at both ends of the substep.
SubstepMotion substep_motion(const SteppedSetup& setup, const SteppedState& state,
                             const Substep& substep, std::size_t slot);

/// A body of a pair at a time of the substep.
struct MovedBody {
  StepShape shape;
  Vector3<double> centre = Vector3<double>::Zero();
  Vector3<double> velocity = Vector3<double>::Zero();
  Vector3<double> angular_velocity = Vector3<double>::Zero();
  double unforeseen = 0;  // additional speed that one of its points may have, m/s
};

/// The body after a time of the substep.
MovedBody moved_body(const SteppedSetup& setup, const SteppedState& state, const Substep& substep,
                     std::size_t slot, const SubstepMotion& motion, double t);

}  // namespace detail

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/substep_motion.cpp"
#endif
