/// @file
/// Many contacts with friction: sequential impulses, iterated (projected Gauss–Seidel or Jacobi).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <contact/contact_lcp.hpp>
#include <contact/frame.hpp>
#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/rigid_body.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The impulse at a contact: on A, and the opposite on B.
template <Ring S>
struct ContactImpulse {
  S normal = S(0);                             ///< along the normal, never negative, N·s
  Vector3<S> tangential = Vector3<S>::Zero();  ///< friction, at most μ times the normal one, N·s
};

/// Settings of the solver: when the iterations end, and how they are made.
template <Ring S>
struct SolverSettings {
  int iterations = 10000;  ///< maximum number of iterations, at least 1
  S tolerance = S(1e-12);  ///< ends when an iteration changes no contact velocity by more, m/s
  /// Over-relaxation: the change of an impulse as a multiple of the exact change for its contact,
  /// greater than 0, below 2. A factor above 1 saves iterations without friction. With friction the
  /// iteration may not converge; then it continues with a factor of 1.
  S relaxation = S(1);
  /// Jacobi instead of Gauss–Seidel: all contacts of an iteration use the same velocities. Slower,
  /// but independent of the order of the contacts, so a symmetric scene stays symmetric.
  bool jacobi = false;
};

/// How the iterations ended.
template <Ring S>
struct SolverReport {
  int iterations = 0;    ///< number of iterations
  S last_change = S(0);  ///< largest change of a contact velocity in the last iteration, m/s
  bool blended = false;  ///< restitution was reduced, so that the energy does not grow
  S rounding = S(0);     ///< bound on the error of velocities from rounded impulses, m/s
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
};

template <std::floating_point S>
PreparedContact<S> prepared(const std::vector<RigidBody<S>>& bodies,
                            const BodyContact<S>& contact) {
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
  p.inverse_normal_mass =
      inverse_effective_mass<S>(a, b, contact.point, p.direction[0], p.direction[0]);
  const S one = inverse_effective_mass<S>(a, b, contact.point, p.direction[1], p.direction[1]);
  const S mixed = inverse_effective_mass<S>(a, b, contact.point, p.direction[1], p.direction[2]);
  const S two = inverse_effective_mass<S>(a, b, contact.point, p.direction[2], p.direction[2]);
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

// [sweep]
/// Updates the impulses of one contact. Returns the largest change of a velocity.
///
/// Friction first, with the normal impulse of the previous iteration: a step against the slip with
/// the effective mass of the stiffest tangent, projected onto the disc of radius μ times the normal
/// impulse. The disc is convex and the relaxation below 2, so this does not increase the kinetic
/// energy. Then the normal: the impulse that brings the normal velocity to its minimum,
/// while the accumulated impulse stays at 0 or more. If it has become smaller, the friction is
/// projected again.
template <std::floating_point S>
S relax(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p, ImpulseComponents<S>& x,
        const S& relaxation) {
  S largest(0);
  const auto update_friction = [&](const S& one, const S& two) {
    const S most = p.contact.friction * x[0];
    const S length = std::sqrt(one * one + two * two);
    const S share = length > most ? most / length : S(1);
    const ImpulseComponents<S> next{x[0], one * share, two * share};
    for (std::size_t k = 1; k < 3; ++k) {
      const S change = next[k] - x[k];
      if (change == S(0)) continue;
      apply_impulse(bodies, p, k, change);
      largest = std::max(largest, std::abs(change) * p.inverse_tangent_mass);
    }
    x = next;
  };
  if (p.contact.friction > S(0) && p.inverse_tangent_mass > S(0)) {
    const Vector3<S> slip = relative_velocity(bodies, p.contact);
    update_friction(x[1] - relaxation * slip.dot(p.direction[1]) / p.inverse_tangent_mass,
                    x[2] - relaxation * slip.dot(p.direction[2]) / p.inverse_tangent_mass);
  }
  const S velocity = p.direction[0].dot(relative_velocity(bodies, p.contact));
  const S next = std::max(
      S(0), x[0] + relaxation * (p.contact.min_velocity - velocity) / p.inverse_normal_mass);
  const S change = next - x[0];
  if (change == S(0)) return largest;
  apply_impulse(bodies, p, 0, change);
  x[0] = next;
  largest = std::max(largest, std::abs(change) * p.inverse_normal_mass);
  if (change < S(0)) update_friction(x[1], x[2]);
  return largest;
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
// [/sweep]

// [sweep-at-once]
/// One Jacobi iteration: every contact starts from the same velocities. Its change is divided by
/// the number of contacts of its bodies. No change alone increases the kinetic energy; after the
/// division their sum does not either. The new impulses lie between admissible ones, so they are
/// admissible.
/// @param partners for each contact, the larger number of contacts of its two bodies
template <std::floating_point S>
S jacobi_iteration(std::vector<RigidBody<S>>& bodies,
                   const std::vector<PreparedContact<S>>& contacts,
                   std::vector<ImpulseComponents<S>>& impulses, const std::vector<int>& partners) {
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
    largest = std::max(largest, relax(bodies, p, x, S(1)));
    a = a_before;
    b = b_before;
    for (std::size_t k = 0; k < 3; ++k) changes[i][k] = (x[k] - impulses[i][k]) / S(partners[i]);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      impulses[i][k] += changes[i][k];
      apply_impulse(bodies, contacts[i], k, changes[i][k]);
    }
  }
  return largest;
}

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
// [/sweep-at-once]

/// Over-relaxation ends if this many iterations bring no smaller change than the same number before
/// them.
inline constexpr int settling_iterations = 1024;

template <std::floating_point S>
SolverReport<S> iterate_until(std::vector<RigidBody<S>> bodies,
                              const std::vector<PreparedContact<S>>& contacts,
                              std::vector<ImpulseComponents<S>>& impulses,
                              const SolverSettings<S>& limits) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) apply_impulse(bodies, contacts[i], k, impulses[i][k]);
  }
  SolverReport<S> report;
  S relaxation = limits.relaxation;
  S least = std::numeric_limits<S>::infinity();  // smallest change in these iterations
  S min_before = least;
  const std::vector<int> partners = limits.jacobi ? busiest(bodies, contacts) : std::vector<int>();
  do {
    report.last_change = limits.jacobi
                             ? jacobi_iteration(bodies, contacts, impulses, partners)
                             : gauss_seidel_iteration(bodies, contacts, impulses, relaxation);
    ++report.iterations;
    least = std::min(least, report.last_change);
    if (report.iterations % settling_iterations != 0) continue;
    if (!(least < min_before)) relaxation = std::min(relaxation, S(1));
    min_before = least;
    least = std::numeric_limits<S>::infinity();
  } while (report.iterations < limits.iterations && report.last_change > limits.tolerance);
  return report;
}

template <std::floating_point S>
std::vector<RigidBody<S>> after_impulses(std::vector<RigidBody<S>> bodies,
                                         const std::vector<PreparedContact<S>>& contacts,
                                         const std::vector<ImpulseComponents<S>>& impulses) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    const Vector3<S> impulse = p.direction[0] * impulses[i][0] + p.direction[1] * impulses[i][1] +
                               p.direction[2] * impulses[i][2];
    RigidBody<S>& a = bodies[index(p.contact.a)];
    RigidBody<S>& b = bodies[index(p.contact.b)];
    a = after_impulse<S>(a, impulse, p.contact.point);
    b = after_impulse<S>(b, Vector3<S>(-impulse), p.contact.point);
  }
  return bodies;
}

/// The kinetic energy that impulses have added: the sum over contacts of the impulse times the mean
/// of the velocities before and after. The difference of two energies would round to more than the
/// energy of a light body beside a heavy one. A sum that may be rounding counts as 0.
template <std::floating_point S>
S energy_made(const std::vector<RigidBody<S>>& before, const std::vector<RigidBody<S>>& after,
              const std::vector<PreparedContact<S>>& contacts,
              const std::vector<ImpulseComponents<S>>& impulses) {
  S made(0);
  S size(0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    const Vector3<S> mean =
        (relative_velocity(before, p.contact) + relative_velocity(after, p.contact)) / S(2);
    const auto speeds = [&](const std::vector<RigidBody<S>>& bodies) {
      return velocity_at(bodies[index(p.contact.a)], p.contact.point).cwiseAbs().maxCoeff() +
             velocity_at(bodies[index(p.contact.b)], p.contact.point).cwiseAbs().maxCoeff();
    };
    const S speed = speeds(before) + speeds(after);
    for (std::size_t k = 0; k < 3; ++k) {
      made += impulses[i][k] * mean.dot(p.direction[k]);
      size += std::abs(impulses[i][k]) * speed;
    }
  }
  return made > S(64) * std::numeric_limits<S>::epsilon() * size ? made : S(0);
}

}  // namespace detail

/// Bodies after the contact impulses, and these impulses.
template <Ring S>
struct SolvedContacts {
  std::vector<RigidBody<S>> bodies;         ///< in the order of the input
  std::vector<ContactImpulse<S>> impulses;  ///< one a contact
  SolverReport<S> report;                   ///< of the iterations
};

namespace detail {

/// @throws std::invalid_argument as solve_contacts() does
template <std::floating_point S>
std::vector<PreparedContact<S>> prepared_contacts(const std::vector<RigidBody<S>>& bodies,
                                                  const std::vector<BodyContact<S>>& contacts) {
  std::vector<PreparedContact<S>> prepared;
  for (const BodyContact<S>& c : contacts) {
    const int count = static_cast<int>(bodies.size());
    if (c.a < 0 || c.a >= count || c.b < 0 || c.b >= count || c.a == c.b) {
      throw_invalid_argument("contacts",
                             "bodies " + std::to_string(c.a) + " and " + std::to_string(c.b),
                             "must be two of the list");
    }
    require_finite("point", c.point);
    require_finite("normal", c.normal);
    require_finite("min_velocity", c.min_velocity);
    if (!(c.friction >= S(0)) || !is_finite(c.friction)) {
      throw_invalid_argument("friction", number_text(c.friction), "must not be negative");
    }
    prepared.push_back(detail::prepared(bodies, c));
  }
  return prepared;
}

/// Projects impulses onto the admissible ones: no pull, friction inside its cone. An empty list
/// gives zeros.
template <std::floating_point S>
std::vector<ImpulseComponents<S>> clamped_impulses(const std::vector<PreparedContact<S>>& prepared,
                                                   const std::vector<ContactImpulse<S>>& start) {
  std::vector<ImpulseComponents<S>> impulses(prepared.size(),
                                             ImpulseComponents<S>{S(0), S(0), S(0)});
  for (std::size_t i = 0; i < start.size(); ++i) {
    const S normal = std::max(S(0), start[i].normal);
    const S one = start[i].tangential.dot(prepared[i].direction[1]);
    const S two = start[i].tangential.dot(prepared[i].direction[2]);
    const S length = std::sqrt(one * one + two * two);
    const S most = prepared[i].contact.friction * normal;
    const S share = length > most ? most / length : S(1);
    impulses[i] = {normal, one * share, two * share};
  }
  return impulses;
}

/// A bound on the error of velocities from rounded impulses. Between two heavy bodies, large
/// changes of the velocity of a light one cancel, but their rounding errors do not: for doubles
/// 2⁻⁴⁴ of the sum of their absolute values.
template <std::floating_point S>
S impulse_rounding(const std::vector<RigidBody<S>>& bodies,
                   const std::vector<PreparedContact<S>>& contacts,
                   const std::vector<ImpulseComponents<S>>& impulses) {
  std::vector<S> changes(bodies.size(), S(0));
  S most(0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    for (const bool first : {true, false}) {
      const std::size_t place = index(first ? p.contact.a : p.contact.b);
      const RigidBody<S>& body = bodies[place];
      const Vector3<S> lever_arm = p.contact.point - body.position;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3<S>& turn = first ? p.angular_a[k] : p.angular_b[k];
        changes[place] +=
            std::abs(impulses[i][k]) *
            (body.inverse_mass + std::sqrt(S(turn.dot(turn)) * S(lever_arm.dot(lever_arm))));
      }
      most = std::max(most, changes[place]);
    }
  }
  return S(256) * std::numeric_limits<S>::epsilon() * most;
}

/// The bodies after impulses. If restitution has added energy, it is reduced until it does not:
/// `stop()` returns the impulses without restitution.
template <std::floating_point S, class Stop>
SolvedContacts<S> solved_by(const std::vector<RigidBody<S>>& bodies,
                            const std::vector<PreparedContact<S>>& prepared,
                            std::vector<ImpulseComponents<S>> impulses, const Stop& stop) {
  SolvedContacts<S> solved;
  solved.bodies = after_impulses(bodies, prepared, impulses);
  bool still = true;
  bool bounces = false;
  for (const RigidBody<S>& body : bodies) {
    const bool moves =
        body.velocity != Vector3<S>::Zero() || body.angular_velocity != Vector3<S>::Zero();
    if (body.inverse_mass == S(0) && moves) still = false;
  }
  for (const PreparedContact<S>& p : prepared) bounces = bounces || p.contact.min_velocity > S(0);
  if (still && bounces && energy_made(bodies, solved.bodies, prepared, impulses) > S(0)) {
    // On the segment from the impulses without restitution to those with it the energy is a
    // parabola that opens upwards. Bisection finds where it returns to the energy before.
    const std::vector<ImpulseComponents<S>> stopped = stop();
    const auto blend = [&](const S& share) {
      std::vector<ImpulseComponents<S>> mixed = stopped;
      for (std::size_t i = 0; i < mixed.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) mixed[i][k] += share * (impulses[i][k] - stopped[i][k]);
      }
      return mixed;
    };
    S low(0);
    S high(1);
    for (int i = 0; i < 60; ++i) {
      const S middle = (low + high) / S(2);
      const std::vector<ImpulseComponents<S>> mixed = blend(middle);
      const auto then = after_impulses(bodies, prepared, mixed);
      (energy_made(bodies, then, prepared, mixed) > S(0) ? high : low) = middle;
    }
    impulses = blend(low);
    solved.bodies = after_impulses(bodies, prepared, impulses);
    solved.report.blended = true;
  }
  solved.report.rounding = impulse_rounding(bodies, prepared, impulses);
  for (std::size_t i = 0; i < prepared.size(); ++i) {
    solved.impulses.push_back(
        {impulses[i][0], Vector3<S>(prepared[i].direction[1] * impulses[i][1] +
                                    prepared[i].direction[2] * impulses[i][2])});
  }
  return solved;
}

/// The same contacts without restitution.
template <std::floating_point S>
std::vector<PreparedContact<S>> softened(std::vector<PreparedContact<S>> prepared) {
  for (auto& p : prepared) p.contact.min_velocity = std::min(p.contact.min_velocity, S(0));
  return prepared;
}

}  // namespace detail

// [solve]
/// The impulses at all contacts, with friction, by sequential impulses (projected Gauss–Seidel) or
/// by simultaneous impulses (projected Jacobi).
///
/// After any number of iterations: no normal impulse pulls; the friction of each contact is inside
/// its cone, |tangential| ≤ μ normal; and momentum and angular momentum are conserved up to the
/// rounding of the velocities, because each impulse acts on A and its opposite on B at one point.
/// The velocities are computed from the impulses at the end, once, in the order of the list.
///
/// When the iteration has converged, no contact is slower than its least velocity, up to the
/// tolerance, and contacts with an impulse are exactly that fast (complementarity). If all least
/// velocities are 0 or less, the kinetic energy has not grown. Newton's restitution together with
/// friction can make it grow; then the restitution is reduced to the largest for which it does not,
/// on the segment between the impulses without and with restitution. (Not if an immovable body
/// moves, since it may do work.)
/// @param contacts between different bodies of the list, with unit normals
/// @param start initial impulses (warm start), for instance those of the previous step: they save
/// iterations. Empty, or one for each contact; they are projected onto the admissible impulses
/// @throws std::invalid_argument if a contact names a body that does not exist or the same body
/// twice, has negative friction, or a number that is not finite; or if `start` has another length
template <std::floating_point S>
SolvedContacts<S> solve_contacts(const std::vector<RigidBody<S>>& bodies,
                                 const std::vector<BodyContact<S>>& contacts,
                                 const std::vector<ContactImpulse<S>>& start = {},
                                 const SolverSettings<S>& limits = {}) {
  if (!start.empty() && start.size() != contacts.size()) {
    throw_invalid_argument("start", std::to_string(start.size()) + " impulses",
                           "must be one a contact");
  }
  const auto prepared = detail::prepared_contacts(bodies, contacts);
  std::vector<detail::ImpulseComponents<S>> impulses = detail::clamped_impulses(prepared, start);
  const SolverReport<S> report = detail::iterate_until(bodies, prepared, impulses, limits);
  const auto stop = [&] {
    std::vector<detail::ImpulseComponents<S>> stopped = detail::clamped_impulses<S>(prepared, {});
    detail::iterate_until(bodies, detail::softened(prepared), stopped, limits);
    return stopped;
  };
  SolvedContacts<S> solved = detail::solved_by<S>(bodies, prepared, std::move(impulses), stop);
  solved.report.iterations = report.iterations;
  solved.report.last_change = report.last_change;
  return solved;
}
// [/solve]

}  // namespace contact
