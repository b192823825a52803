// Bodies that do not turn, because each of their contacts lies at the centre of mass: what the
// figures `stack`, `sliding_box` and `cradle` share.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/contact_solver.hpp>
#include <cstddef>
#include <vector>

namespace blocks {

using Vector = contact::Vector3<double>;
using Body = contact::RigidBody<double>;
using Contacts = std::vector<contact::BodyContact<double>>;
using Settings = contact::SolverSettings<double>;

constexpr double gravity = 9.81, mass = 10;  // m/s², kg

inline Vector up() { return {0, 0, 1}; }

inline Body block(double kilograms, const Vector& position, const Vector& velocity) {
  return contact::rigid_body_from_axes<double>(kilograms, Vector(1, 1, 1),
                                               contact::Matrix3<double>::Identity(), position,
                                               velocity, Vector::Zero());
}

inline Body ground() {
  return contact::immovable<double>(Vector::Zero(), Vector::Zero(), Vector::Zero());
}

/// The velocities after a time without contacts.
inline void fall(std::vector<Body>& bodies, double time) {
  for (Body& body : bodies)
    if (body.inverse_mass > 0) body.velocity -= up() * (gravity * time);
}

/// A number of things, from the number of a slider.
inline std::size_t whole(double x, double low, double high) {
  return static_cast<std::size_t>(std::clamp(std::round(x), low, high));
}

}  // namespace blocks
