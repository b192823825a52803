/// @file
/// One iteration over many contacts with friction: sequential impulses (projected Gauss–Seidel) or
/// simultaneous ones (projected Jacobi).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <contact/contact_lcp.hpp>
#include <contact/friction_pyramid.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/signed_distance.hpp>
#include <contact/symmetric_sum.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The impulse at a contact: on A, and the opposite on B.
template <Ring S>
struct ContactImpulse {
  S normal = S(0);  ///< along the normal, never negative, N·s
  /// Friction, N·s: of length at most μ times the normal impulse, up to rounding. With a friction
  /// pyramid each of its two components is, and the length is up to √2 times that.
  Vector3<S> tangential = Vector3<S>::Zero();
};

/// Settings of the solver: when the iterations end, and how they are made.
template <Ring S>
struct SolverSettings {
  int iterations = 10000;  ///< maximum number of iterations, at least 1
  S tolerance = S(1e-12);  ///< m/s; ends when the residual is at most this: see SolverReport
  /// Over-relaxation: the change of an impulse as a multiple of the exact change for its contact,
  /// greater than 0, below 2. A factor above 1 saves iterations without friction. With friction the
  /// iterations may not converge, and even repeat themselves; whenever 1,024 of them make no
  /// progress, they continue with a factor of 1, then with half of it.
  S relaxation = S(1);
  /// Jacobi instead of Gauss–Seidel: all contacts of an iteration use the same velocities. Slower,
  /// but independent of the order of the contacts to the last bit, so a scene that is symmetric
  /// about a plane perpendicular to a coordinate axis stays symmetric to the last bit.
  bool jacobi = false;
  /// Block solve: two contacts of the same bodies that follow each other in the list are solved at
  /// once (two_contacts.hpp), so that the two ends of a rod or an edge need one iteration. Not with
  /// `jacobi`, and without over-relaxation of their normals.
  bool block = false;
  /// The set to which friction is limited. The pyramid's errors are those of pyramid_error().
  FrictionBound friction_bound = FrictionBound::cone;
};

/// How the iterations ended, and what the impulses are worth.
template <Ring S>
struct SolverReport {
  int iterations = 0;    ///< number of iterations
  S last_change = S(0);  ///< largest change of a contact velocity in the last iteration, m/s
  bool blended = false;  ///< restitution was reduced, so that the energy does not grow
  S rounding = S(0);     ///< bound on the error of velocities from rounded impulses, m/s
  /// Residual of complementarity and of Coulomb's law: by how much the velocity of a contact would
  /// change if its impulses alone were corrected once more, maximal over contacts, m/s. Where
  /// restitution was reduced, the larger residual of the impulses with and without it.
  S residual = S(0);
  /// Whether the residual is at most the tolerance plus `rounding`. Impulses that repeat themselves
  /// after every second iteration have not settled, whatever their number. Never true for impulses
  /// that had to be moved towards those without friction.
  bool settled = false;
  /// Friction was reduced: the iterations had not settled, and their impulses would have added
  /// energy.
  bool friction_reduced = false;
};

namespace detail {

/// A contact with the values that do not change during the iterations.
template <std::floating_point S>
struct PreparedContact {
  BodyContact<S> contact;
  std::array<Vector3<S>, 3> direction;  // normal and two tangents
  std::array<Vector3<S>, 3>
      angular_a;  // change of A's angular velocity for a unit impulse along each
  std::array<Vector3<S>, 3> angular_b;
  S inverse_normal_mass = S(0);   // inverse of the effective mass along the normal, 1/kg
  S inverse_tangent_mass = S(0);  // an upper bound of it over all tangents, 1/kg
  FrictionBound bound = FrictionBound::cone;
};

/// @param together whether the effective masses must not depend on which body is A (for Jacobi)
template <std::floating_point S>
PreparedContact<S> prepared(const std::vector<RigidBody<S>>& bodies, const BodyContact<S>& contact,
                            bool together = false) {
  const RigidBody<S>& a = bodies[index(contact.a)];
  const RigidBody<S>& b = bodies[index(contact.b)];
  PreparedContact<S> p{contact, {}, {}, {}, S(0), S(0)};
  p.direction[0] = contact.normal;
  p.direction[1] = perpendicular_to<S>(contact.normal);
  p.direction[2] = contact.normal.cross(p.direction[1]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3<S> lever_arm_a = contact.point - a.position;
    const Vector3<S> lever_arm_b = contact.point - b.position;
    p.angular_a[k] = a.inverse_inertia * Vector3<S>(lever_arm_a.cross(p.direction[k]));
    p.angular_b[k] = b.inverse_inertia * Vector3<S>(lever_arm_b.cross(p.direction[k]));
  }
  const auto inverse_mass = [&](std::size_t out, std::size_t in) {
    const Vector3<S>& n = p.direction[out];
    const Vector3<S>& m = p.direction[in];
    if (!together) return inverse_effective_mass<S>(a, b, contact.point, n, m);
    return S(body_inverse_effective_mass<S>(a, contact.point, n, contact.point, m) +
             body_inverse_effective_mass<S>(b, contact.point, n, contact.point, m));
  };
  p.inverse_normal_mass = inverse_mass(0, 0);
  const S one = inverse_mass(1, 1);
  const S mixed = inverse_mass(1, 2);
  const S two = inverse_mass(2, 2);
  // The larger eigenvalue of the 2 × 2 matrix.
  p.inverse_tangent_mass =
      (one + two + std::sqrt((one - two) * (one - two) + S(4) * mixed * mixed)) / S(2);
  return p;
}

/// Applies an impulse along direction k of a contact.
template <std::floating_point S>
void apply_impulse(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p, std::size_t k,
                   const S& impulse) {
  RigidBody<S>& a = bodies[index(p.contact.a)];
  RigidBody<S>& b = bodies[index(p.contact.b)];
  a.velocity += p.direction[k] * (impulse * a.inverse_mass);
  a.angular_velocity += p.angular_a[k] * impulse;
  b.velocity -= p.direction[k] * (impulse * b.inverse_mass);
  b.angular_velocity -= p.angular_b[k] * impulse;
}

template <std::floating_point S>
Vector3<S> relative_velocity(const std::vector<RigidBody<S>>& bodies,
                             const BodyContact<S>& contact) {
  return velocity_at(bodies[index(contact.a)], contact.point) -
         velocity_at(bodies[index(contact.b)], contact.point);
}

/// Components of an impulse: normal, first tangent, second tangent.
template <std::floating_point S>
using ImpulseComponents = std::array<S, 3>;

// [gauss-seidel]
/// Changes the friction of a contact to the nearest that its normal impulse allows. Returns the
/// change of a velocity, as relax() does.
template <std::floating_point S>
S change_friction(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p,
                  ImpulseComponents<S>& x, const S& one, const S& two) {
  S largest(0);
  const Vector2<S> bounded = bounded_friction<S>(p.bound, {one, two}, p.contact.friction * x[0]);
  const ImpulseComponents<S> next{x[0], bounded.x(), bounded.y()};
  for (std::size_t k = 1; k < 3; ++k) {
    const S change = next[k] - x[k];
    if (change == S(0)) continue;
    apply_impulse(bodies, p, k, change);
    largest = std::max(largest, std::abs(change) * p.inverse_tangent_mass);
  }
  x = next;
  return largest;
}

/// A step against the slip, with the effective mass of the stiffest tangent.
template <std::floating_point S>
S relax_friction(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p,
                 ImpulseComponents<S>& x, const S& relaxation) {
  if (!(p.contact.friction > S(0)) || !(p.inverse_tangent_mass > S(0))) return S(0);
  const Vector3<S> slip = relative_velocity(bodies, p.contact);
  return change_friction<S>(bodies, p, x,
                            x[1] - relaxation * slip.dot(p.direction[1]) / p.inverse_tangent_mass,
                            x[2] - relaxation * slip.dot(p.direction[2]) / p.inverse_tangent_mass);
}

/// Changes the accumulated normal impulse. If it becomes smaller, friction is projected again.
template <std::floating_point S>
S change_normal(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p,
                ImpulseComponents<S>& x, const S& next) {
  const S change = next - x[0];
  if (change == S(0)) return S(0);
  apply_impulse(bodies, p, 0, change);
  x[0] = next;
  const S largest = std::abs(change) * p.inverse_normal_mass;
  return change < S(0) ? std::max(largest, change_friction<S>(bodies, p, x, x[1], x[2])) : largest;
}

// [normal-visit]
/// The normal impulse that brings the normal velocity to its minimum, while the accumulated impulse
/// stays at 0 or more.
template <std::floating_point S>
S relax_normal(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p,
               ImpulseComponents<S>& x, const S& relaxation) {
  const S velocity = p.direction[0].dot(relative_velocity(bodies, p.contact));
  const S change = relaxation * (p.contact.min_velocity - velocity) / p.inverse_normal_mass;
  return change_normal<S>(bodies, p, x, std::max(S(0), x[0] + change));
}
// [/normal-visit]

/// Updates the impulses of one contact. Returns the largest change of a velocity.
///
/// Friction first, with the normal impulse of the previous iteration, projected onto the disc of
/// radius μ times the normal impulse. The disc is convex and the relaxation below 2, so this does
/// not increase the kinetic energy. Then the normal, which does not increase the function f of
/// keep_energy(); the energy itself it can, for instance with restitution. If the normal impulse
/// has become smaller, friction is projected again. This last projection can increase both.
template <std::floating_point S>
S relax(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p, ImpulseComponents<S>& x,
        const S& relaxation) {
  const S friction = relax_friction(bodies, p, x, relaxation);
  return std::max(friction, relax_normal(bodies, p, x, relaxation));
}

/// One iteration over all contacts, in the order of the list (Gauss–Seidel). Returns the largest
/// change of a velocity.
template <std::floating_point S>
S gauss_seidel_iteration(std::vector<RigidBody<S>>& bodies,
                         const std::vector<PreparedContact<S>>& contacts,
                         std::vector<ImpulseComponents<S>>& impulses, const S& relaxation) {
  S largest(0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!(contacts[i].inverse_normal_mass > S(0))) continue;  // two immovable bodies
    largest = std::max(largest, relax(bodies, contacts[i], impulses[i], relaxation));
  }
  return largest;
}
// [/gauss-seidel]

// [jacobi]
/// Adds impulses to the velocities of the bodies: for each body the sum of all of them, in whatever
/// order they are listed (symmetric_sum()).
template <std::floating_point S>
void apply_together(std::vector<RigidBody<S>>& bodies,
                    const std::vector<PreparedContact<S>>& contacts,
                    const std::vector<ImpulseComponents<S>>& impulses) {
  std::vector<std::vector<Vector3<S>>> linear(bodies.size());
  std::vector<std::vector<Vector3<S>>> angular(bodies.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    const auto sum = [&](const std::array<Vector3<S>, 3>& of) {
      return Vector3<S>(of[0] * impulses[i][0] + of[1] * impulses[i][1] + of[2] * impulses[i][2]);
    };
    const Vector3<S> impulse = sum(p.direction);
    linear[index(p.contact.a)].push_back(impulse);
    linear[index(p.contact.b)].push_back(-impulse);
    angular[index(p.contact.a)].push_back(sum(p.angular_a));
    angular[index(p.contact.b)].push_back(-sum(p.angular_b));
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!(bodies[k].inverse_mass > S(0))) continue;
    bodies[k].velocity += symmetric_vector_sum(linear[k]) * bodies[k].inverse_mass;
    bodies[k].angular_velocity += symmetric_vector_sum(angular[k]);
  }
}

/// One Jacobi iteration: every contact starts from the same velocities. Its change is divided by
/// the number of contacts of its bodies. The new impulses lie between admissible ones, so they are
/// admissible.
///
/// Without friction the function f of keep_energy() does not grow: no change alone increases it,
/// and it is a sum of a convex function of each body's velocities and a linear one of the impulses,
/// so the sum of the divided changes does not either. The kinetic energy itself can grow where a
/// least velocity is above 0, or an impulse was too large. With friction f can grow too, where a
/// friction is cut to a smaller disc.
/// @param partners for each contact, the larger number of contacts of its two bodies
template <std::floating_point S>
S jacobi_iteration(std::vector<RigidBody<S>>& bodies,
                   const std::vector<PreparedContact<S>>& contacts,
                   std::vector<ImpulseComponents<S>>& impulses, const std::vector<int>& partners,
                   const S& relaxation = S(1)) {
  S largest(0);
  std::vector<ImpulseComponents<S>> changes(contacts.size(),
                                            ImpulseComponents<S>{S(0), S(0), S(0)});
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    if (!(p.inverse_normal_mass > S(0))) continue;
    RigidBody<S>& a = bodies[index(p.contact.a)];
    RigidBody<S>& b = bodies[index(p.contact.b)];
    const RigidBody<S> a_before = a;
    const RigidBody<S> b_before = b;
    ImpulseComponents<S> x = impulses[i];
    largest = std::max(largest, relax(bodies, p, x, relaxation));
    a = a_before;
    b = b_before;
    for (std::size_t k = 0; k < 3; ++k) changes[i][k] = (x[k] - impulses[i][k]) / S(partners[i]);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) impulses[i][k] += changes[i][k];
  }
  apply_together(bodies, contacts, changes);
  return largest;
}
// [/jacobi]

/// For each contact, the larger number of contacts of its two bodies; immovable bodies count as 0.
template <std::floating_point S>
std::vector<int> busiest(const std::vector<RigidBody<S>>& bodies,
                         const std::vector<PreparedContact<S>>& contacts) {
  std::vector<int> of_body(bodies.size(), 0);
  for (const PreparedContact<S>& p : contacts) {
    for (const int body : {p.contact.a, p.contact.b})
      if (bodies[index(body)].inverse_mass > S(0)) ++of_body[index(body)];
  }
  std::vector<int> most;
  most.reserve(contacts.size());
  for (const PreparedContact<S>& p : contacts)
    most.push_back(std::max({1, of_body[index(p.contact.a)], of_body[index(p.contact.b)]}));
  return most;
}
}  // namespace detail

}  // namespace contact
