/// @file
/// Code to break: a body with two contacts that are treated one after the other, as many programs
/// do it.
#pragma once

namespace given {

/// How the box moves.
struct Motion {
  double velocity;          ///< of the centre, m/s; up is positive
  double angular_velocity;  ///< rad/s, counter-clockwise
};

/// The impulse at one contact, on a box of 1 kg.
inline Motion after_contact(Motion motion, double arm, double inertia, double restitution) {
  const double velocity = motion.velocity + motion.angular_velocity * arm;
  if (velocity >= 0) return motion;
  const double impulse = -(1 + restitution) * velocity / (1 + arm * arm / inertia);
  motion.velocity += impulse;
  motion.angular_velocity += arm * impulse / inertia;
  return motion;
}

/// The motion of the box after the impact: first the one contact, then the other.
template <class Box>
Motion one_by_one(const Box& box) {
  const double inertia = (box.width * box.width + box.height * box.height) / 12;
  const Motion before{box.velocity, box.angular_velocity};
  const Motion between = after_contact(before, box.first, inertia, box.restitution);
  return after_contact(between, box.second, inertia, box.restitution);
}

}  // namespace given
