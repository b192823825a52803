/// @file
/// Bodies with shapes, and a time step: find the contacts, solve them, move the bodies.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <contact/contact_active_set.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/frame.hpp>
#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/manifold_ids.hpp>
#include <contact/manifold_point.hpp>
#include <contact/pose.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rotation.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A shape in the axes of its body, with the centre of mass at the origin; a half-space in the
/// world.
template <Ring S>
using BodyShape = std::variant<Sphere<S>, Capsule<S>, OrientedBox<S>, HalfSpace<S>>;

// [shaped-body]
/// A rigid body with a shape.
template <Ring S>
struct ShapedBody {
  BodyShape<S> shape;         ///< in the body's axes, m
  RigidBody<S> motion;        ///< in the world; its tensors follow the orientation
  Quaternion<S> orientation;  ///< from body to world
  /// Moments of inertia about the body's axes, which are its principal axes, kg·m²; not read for an
  /// immovable body.
  Vector3<S> moments = Vector3<S>::Zero();
  S friction = S(0);     ///< μ; that of a pair is the square root of the product
  S restitution = S(0);  ///< e, from 0 to 1; that of a pair is the larger
};
// [/shaped-body]

/// A solid box of uniform density.
/// @param size lengths of the edges, m
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
ShapedBody<S> solid_box(const S& mass, const Vector3<S>& size, const Vector3<S>& position) {
  const Matrix3<S> tensor = box_inertia<S>(mass, size);
  const Vector3<S> zero = Vector3<S>::Zero();
  ShapedBody<S> body;
  body.shape = oriented_box_from_axes<S>(zero, Matrix3<S>::Identity(), Vector3<S>(size / S(2)));
  body.moments = tensor.diagonal();
  body.motion =
      rigid_body_from_axes<S>(mass, body.moments, Matrix3<S>::Identity(), position, zero, zero);
  return body;
}

/// A solid ball of uniform density.
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
ShapedBody<S> solid_ball(const S& mass, const S& radius, const Vector3<S>& position) {
  const Matrix3<S> tensor = sphere_inertia<S>(mass, radius);
  const Vector3<S> zero = Vector3<S>::Zero();
  ShapedBody<S> body;
  body.shape = sphere_from_radius<S>(zero, radius);
  body.moments = tensor.diagonal();
  body.motion =
      rigid_body_from_axes<S>(mass, body.moments, Matrix3<S>::Identity(), position, zero, zero);
  return body;
}

/// An immovable half-space.
/// @throws std::invalid_argument naming the argument and its value
template <std::floating_point S>
ShapedBody<S> ground(const Plane<S>& boundary) {
  ShapedBody<S> body;
  body.shape = half_space_behind<S>(boundary);
  return body;
}

/// A half-space is in the world already.
template <std::floating_point S>
HalfSpace<S> transformed(const HalfSpace<S>& shape, const CoordinateFrame<S>&) {
  return shape;
}

/// Settings of a step.
template <Ring S>
struct StepSettings {
  Vector3<S> gravity{S(0), S(0), S(-9.80665)};  ///< m/s²
  S step = S(1) / S(60);                        ///< h, s, greater than 0
  S margin = S(0.02);     ///< surfaces at most this far apart are in contact, m
  S rest_speed = S(0.5);  ///< slower impacts do not bounce, m/s
  SolverSettings<S> solver{20000, S(1e-11), S(1.8)};  ///< of the solver
};

/// The contacts of bodies, by pairs in the order of the list.
template <Ring S>
struct FoundContacts {
  std::vector<BodyContact<S>> contacts;  ///< of a pair in the order of its manifold
  std::vector<PointFeatures> features;   ///< one for each contact
};

/// The contacts of a step and their impulses, for the warm start of the next step.
template <Ring S>
struct StepMemory {
  FoundContacts<S> found;                   ///< in the order of the step
  std::vector<ContactImpulse<S>> impulses;  ///< one for each contact
};

namespace detail {

/// A sphere that contains the shape, a little larger than the smallest; of a half-space, one of
/// infinite radius.
template <std::floating_point S>
Sphere<S> sphere_around(const BodyShape<S>& shape) {
  const S larger = S(1) + S(16) * std::numeric_limits<S>::epsilon();
  if (const auto* ball = std::get_if<Sphere<S>>(&shape))
    return {ball->centre, ball->radius * larger};
  if (const auto* box = std::get_if<OrientedBox<S>>(&shape)) {
    return {box->centre, std::sqrt(S(box->half_lengths.dot(box->half_lengths))) * larger};
  }
  if (const auto* capsule = std::get_if<Capsule<S>>(&shape)) {
    const Vector3<S> half = (capsule->core.end - capsule->core.start) / S(2);
    return {capsule->core.start + half, (std::sqrt(S(half.dot(half))) + capsule->radius) * larger};
  }
  return {Vector3<S>::Zero(), std::numeric_limits<S>::infinity()};
}

/// Whether two spheres are farther apart than the margin, beyond all rounding.
template <std::floating_point S>
bool far_apart(const Sphere<S>& a, const Sphere<S>& b, const S& margin) {
  const Vector3<S> between = b.centre - a.centre;
  const S size = a.centre.cwiseAbs().maxCoeff() + b.centre.cwiseAbs().maxCoeff();
  const S reach = a.radius + b.radius + margin + S(16) * std::numeric_limits<S>::epsilon() * size;
  return between.dot(between) > reach * reach * (S(1) + S(16) * std::numeric_limits<S>::epsilon());
}

}  // namespace detail

// [find-contacts]
/// All contacts of bodies within the margin, by pairs in the order of the list and by points in the
/// order of the manifold. All pairs are tested, most of them only by their bounding spheres.
///
/// A gap may close within the step, but not become negative. Bodies farther apart than the margin
/// are no contact: if they approach faster than margin/h, they may overlap afterwards by their
/// displacement in the step. After an impact faster than the rest speed the bodies separate with e
/// times the speed of approach.
template <std::floating_point S>
FoundContacts<S> find_contacts(const std::vector<ShapedBody<S>>& bodies,
                               const StepSettings<S>& settings) {
  FoundContacts<S> found;
  std::vector<BodyShape<S>> shapes;
  std::vector<Sphere<S>> spheres;
  for (const ShapedBody<S>& body : bodies) {
    const auto frame = frame_of<S>({body.motion.position, body.orientation});
    shapes.push_back(std::visit(
        [&](const auto& shape) { return BodyShape<S>(transformed(shape, frame)); }, body.shape));
    spheres.push_back(detail::sphere_around(shapes.back()));
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
      const RigidBody<S>& a = bodies[i].motion;
      const RigidBody<S>& b = bodies[k].motion;
      if (a.inverse_mass == S(0) && b.inverse_mass == S(0)) continue;
      if (detail::far_apart(spheres[i], spheres[k], settings.margin)) continue;
      const ContactManifold<S> manifold = std::visit(
          [&](const auto& one, const auto& other) -> ContactManifold<S> {
            using A = std::decay_t<decltype(one)>;
            using B = std::decay_t<decltype(other)>;
            if constexpr (std::same_as<A, HalfSpace<S>> && std::same_as<B, HalfSpace<S>>) {
              return {};
            } else {
              return contact_manifold(one, other, settings.margin);
            }
          },
          shapes[i], shapes[k]);
      for (const ManifoldPoint<S>& p : manifold.points) {
        BodyContact<S> contact{static_cast<int>(i),
                               static_cast<int>(k),
                               p.point,
                               manifold.normal,
                               std::sqrt(bodies[i].friction * bodies[k].friction),
                               S(0)};
        const S velocity = manifold.normal.dot(velocity_at(a, p.point) - velocity_at(b, p.point));
        const S e = std::max(bodies[i].restitution, bodies[k].restitution);
        const S room = -std::max(p.distance, S(0)) / settings.step;
        const bool hits = velocity < room && velocity < -settings.rest_speed && e > S(0);
        contact.min_velocity = hits ? -(e * velocity) : room;
        found.contacts.push_back(contact);
        found.features.push_back(p.features);
      }
    }
  }
  return found;
}
// [/find-contacts]

namespace detail {

// [remembered]
/// The impulses of the previous step: each contact takes that of the same point of the same pair
/// (matched_points(), with the margin as radius). Both lists are in the order of the pairs.
template <std::floating_point S>
std::vector<ContactImpulse<S>> remembered(const FoundContacts<S>& now, const StepMemory<S>& memory,
                                          const S& margin) {
  const auto pair_of = [](const FoundContacts<S>& found, std::size_t i) {
    return std::pair{found.contacts[i].a, found.contacts[i].b};
  };
  // The contacts of one pair from `first` on, which becomes the first of the next pair.
  const auto manifold_of = [&](const FoundContacts<S>& found, std::size_t& first) {
    ContactManifold<S> manifold{found.contacts[first].normal, {}};
    const auto pair = pair_of(found, first);
    for (; first < found.contacts.size() && pair_of(found, first) == pair; ++first)
      manifold.points.push_back({found.contacts[first].point, S(0), found.features[first]});
    return manifold;
  };
  std::vector<ContactImpulse<S>> start(now.contacts.size());
  const FoundContacts<S>& previous = memory.found;
  std::size_t old = 0;
  for (std::size_t next = 0; next < now.contacts.size();) {
    const std::size_t first = next;
    const ContactManifold<S> manifold = manifold_of(now, next);
    const auto pair = pair_of(now, first);
    while (old < previous.contacts.size() && pair_of(previous, old) < pair) ++old;
    if (old == previous.contacts.size() || pair_of(previous, old) != pair) continue;
    const std::size_t old_first = old;
    const std::vector<int> matched = matched_points(manifold, manifold_of(previous, old), margin);
    for (std::size_t i = 0; i < matched.size(); ++i)
      if (matched[i] >= 0) start[first + i] = memory.impulses[old_first + index(matched[i])];
  }
  return start;
}
// [/remembered]

/// The number of iterations before an active-set solve is tried.
inline constexpr int iterations_before_active_set = 8;

// [solve-step]
/// The impulses of a step: a few iterations from those of the previous step, which suffice while
/// bodies rest; if they have not settled, an active-set solve; and if that does not settle either,
/// the other iterations, with over-relaxation. Of the results, that with the smallest residual.
/// With Jacobi's iterations there is no active-set solve: a symmetric scene stays symmetric.
template <std::floating_point S>
SolvedContacts<S> solve_step(const std::vector<RigidBody<S>>& bodies,
                             const std::vector<BodyContact<S>>& contacts,
                             const std::vector<ContactImpulse<S>>& start,
                             const SolverSettings<S>& settings) {
  const auto prepared =
      prepared_contacts(bodies, contacts, settings.jacobi, settings.friction_bound);
  SolverSettings<S> few = settings;
  few.iterations = std::min(settings.iterations, iterations_before_active_set);
  few.relaxation = S(1);
  std::vector<ImpulseComponents<S>> impulses = clamped_impulses(prepared, start);
  const SolverReport<S> report = iterate_until(bodies, prepared, impulses, few);
  const auto iterated = [&] { return solved_after(bodies, prepared, impulses, report, few); };
  const bool last = settings.iterations <= few.iterations;
  std::optional<SolvedContacts<S>> solved;
  if (last || !(report.last_change > few.tolerance)) {
    solved = iterated();
    if (last || solved->report.settled) return *solved;
  }
  if (settings.friction_bound == FrictionBound::cone && !settings.jacobi) {
    auto exact = solve_active_set_of(bodies, prepared, impulses_of(prepared, impulses),
                                     FrictionLaw::coulomb, settings.tolerance);
    if (exact) exact->report.iterations = report.iterations;
    if (exact && exact->report.settled) return *exact;
    if (!solved) solved = iterated();
    if (exact && exact->report.residual < solved->report.residual) solved = std::move(exact);
  }
  if (!solved) solved = iterated();
  SolverSettings<S> rest = settings;
  rest.iterations -= report.iterations;
  SolvedContacts<S> more = solve_contacts(bodies, contacts, solved->impulses, rest);
  more.report.iterations += report.iterations;
  return more.report.settled || more.report.residual < solved->report.residual ? more : *solved;
}
// [/solve-step]

// [slide]
/// How much farther a body slides in a step than its velocity afterwards says: friction is constant
/// while it slides, so it moves with the mean of both velocities, until it stops.
///
/// Only for a body that does not rotate, whose contacts have one normal and no impact, with
/// immovable bodies at rest, and only perpendicular to this normal: then no gap changes. (The
/// frictions at the corners of a box that spins have different directions, and a ball that rolls
/// does not slide: for those the way depends on the step.) Let P be the change of momentum in the
/// plane. A body that still slides has used all friction, and slides for the whole step h. If of
/// the largest friction impulse μ N some s is left, it stopped after the time h P / (s + P):
/// constant friction μ N/h acted until then, and afterwards a force that balances the load; the
/// equation of both impulses gives this time, if the slip and the load are parallel. So a box that
/// slides to rest without rotation, on level ground or straight up or down a slope, covers the
/// right way, v²/(2 μ g) on the level, whatever the step.
/// @param before with the velocity before gravity and impulses
template <std::floating_point S>
Vector3<S> slide_correction(const std::vector<RigidBody<S>>& before,
                            const std::vector<RigidBody<S>>& after,
                            const std::vector<BodyContact<S>>& contacts,
                            const std::vector<ContactImpulse<S>>& impulses, std::size_t body,
                            const StepSettings<S>& settings) {
  const Vector3<S> none = Vector3<S>::Zero();
  Vector3<S> normal = none;
  Vector3<S> friction = none;
  S most(0);
  S reach(0);
  const S slow = std::sqrt(S(settings.gravity.dot(settings.gravity))) * settings.step;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const BodyContact<S>& c = contacts[i];
    const bool is_a = index(c.a) == body;
    if ((!is_a && index(c.b) != body) || !(impulses[i].normal > S(0))) continue;
    const RigidBody<S>& other = before[index(is_a ? c.b : c.a)];
    const Vector3<S> n = is_a ? c.normal : Vector3<S>(-c.normal);
    if (other.inverse_mass > S(0) || other.velocity != none || other.angular_velocity != none ||
        c.min_velocity > S(0) || !(contact_velocity(before, c) >= -slow) ||
        (normal != none && normal != n)) {
      return none;
    }
    normal = n;
    friction += is_a ? impulses[i].tangential : Vector3<S>(-impulses[i].tangential);
    most += c.friction * impulses[i].normal;
    reach = std::max(reach, (c.point - before[body].position).cwiseAbs().maxCoeff());
  }
  if (normal == none) return none;
  Vector3<S> slower = before[body].velocity - after[body].velocity;
  slower -= normal * normal.dot(slower);
  const auto turn = [](const RigidBody<S>& one) {
    return one.angular_velocity.cwiseAbs().maxCoeff();
  };
  const S rotation = reach * std::max(turn(before[body]), turn(after[body]));
  if (!(rotation <= S(0x1p-24) * slower.cwiseAbs().maxCoeff())) return none;  // beyond rounding
  const S change = before[body].mass * std::sqrt(S(slower.dot(slower)));
  const S rest = std::max(S(0), most - std::sqrt(S(friction.dot(friction))));
  if (!(change > S(0))) return none;
  const bool slides = !(rest > S(0x1p-30) * most);
  const S time = slides ? settings.step : settings.step * (change / (rest + change));
  return slower * (time / S(2));
}
// [/slide]

}  // namespace detail

// [step]
/// A time step: gravity changes the velocities, contact impulses correct them, and the bodies move
/// with the corrected velocities; those that slide on immovable ones move as far as constant
/// friction lets them (detail::slide_correction()).
///
/// Immovable bodies move by their velocities, but are not turned by their angular velocities; and a
/// half-space stays where it is. Contacts use these velocities all the same: of a conveyor belt, or
/// of a roller, whose surface passes along itself. To turn or move another shape is the caller's
/// task.
///
/// The angular momentum of a body without contacts is conserved: its angular velocity follows from
/// its orientation. Penetration (from the start, by rounding, or of bodies that were too fast for
/// the margin) is not corrected, and does not grow at the contact points. An immovable body keeps
/// its orientation, and a half-space its position, also if they have velocities.
/// @param memory of the previous step, replaced by that of this step; empty for the first step
/// @return how the solver ended: not `settled` if the impulses are only an approximation
template <std::floating_point S>
SolverReport<S> step_contacts(std::vector<ShapedBody<S>>& bodies, StepMemory<S>& memory,
                              const StepSettings<S>& settings = {}) {
  std::vector<RigidBody<S>> before;
  std::vector<RigidBody<S>> motions;
  for (ShapedBody<S>& body : bodies) {
    before.push_back(body.motion);
    if (body.motion.inverse_mass > S(0)) {
      body.motion.velocity += settings.gravity * settings.step;
    }
    motions.push_back(body.motion);
  }
  const FoundContacts<S> found = find_contacts(bodies, settings);
  const std::vector<BodyContact<S>>& contacts = found.contacts;
  const auto start = detail::remembered(found, memory, settings.margin);
  const SolvedContacts<S> solved = detail::solve_step(motions, contacts, start, settings.solver);
  memory = {found, solved.impulses};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    ShapedBody<S>& body = bodies[i];
    body.motion = solved.bodies[i];
    body.motion.position += body.motion.velocity * settings.step;
    if (body.motion.inverse_mass > S(0)) {
      body.motion.position +=
          detail::slide_correction(before, solved.bodies, contacts, solved.impulses, i, settings);
    }
    const Vector3<S> angular_velocity = body.motion.angular_velocity;
    if (body.motion.inverse_mass == S(0) || angular_velocity == Vector3<S>::Zero()) continue;
    const Vector3<S> momentum = body.motion.inertia * angular_velocity;
    body.orientation =
        normalised(exponential_step(body.orientation, angular_velocity, settings.step));
    body.motion =
        rigid_body_from_axes<S>(body.motion.mass, body.moments, matrix_of(body.orientation),
                                body.motion.position, body.motion.velocity, angular_velocity);
    body.motion.angular_velocity = body.motion.inverse_inertia * momentum;
  }
  return solved.report;
}
// [/step]

}  // namespace contact
