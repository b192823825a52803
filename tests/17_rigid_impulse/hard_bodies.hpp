/// @file
/// The bodies and contacts of this chapter's corpus, stored or in exact fractions.
#pragma once

#include <contact/impact_friction.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_impulse.hpp>
#include <string>

#include "support/hard_cases.hpp"

namespace hard_bodies {

using hard_cases::Case;
using hard_cases::convert;

using V = contact::Vector3<double>;

template <class S>
contact::Vector3<S> convert(const V& v) {
  return {convert<S>(v.x()), convert<S>(v.y()), convert<S>(v.z())};
}

/// A body of the corpus: moments about the world's axes, or about axes rotated about z by
/// `turn` = (cosine, sine, 0). Mass 0 stands for an immovable body.
template <class S>
contact::RigidBody<S> body(const Case& c, const std::string& name) {
  const double mass = c.number(name + "_mass");
  const auto position = convert<S>(c.vector(name + "_position"));
  const auto velocity = convert<S>(c.vector(name + "_velocity"));
  const auto angular_velocity = convert<S>(c.vector(name + "_angular_velocity"));
  if (mass == 0) return contact::immovable<S>(position, velocity, angular_velocity);
  contact::Matrix3<S> turn = contact::Matrix3<S>::Identity();
  if (c.has("turn")) {
    const auto t = convert<S>(c.vector("turn"));
    turn(0, 0) = turn(1, 1) = t.x();
    turn(1, 0) = t.y();
    turn(0, 1) = S(-t.y());
  }
  return contact::rigid_body_from_axes<S>(convert<S>(mass), convert<S>(c.vector(name + "_moments")),
                                          turn, position, velocity, angular_velocity);
}

template <class S>
contact::ContactPoint<S> contact_of(const Case& c) {
  return {convert<S>(c.vector("point")), convert<S>(c.vector("normal"))};
}

template <class S>
contact::PlanarContact<S> planar(const Case& c) {
  return {convert<S>(c.number("slip")), convert<S>(c.number("closing")),
          convert<S>(c.number("k_tt")), convert<S>(c.number("k_tn")), convert<S>(c.number("k_nn"))};
}

}  // namespace hard_bodies
