#include <contact/stepped/stage_impacts.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <contact/contact_finish.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/gap.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/spring_damper.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/step_solver.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

// [impacts-stage]
CONTACT_SCENES_INLINE void solve_impacts(const SteppedSetup& setup, SteppedState& state,
                                         StepPart& part) {
  if (part.at_once) return;
  std::vector<BodyContact<double>> contacts;
  std::vector<std::pair<std::size_t, std::size_t>> hits;  // first and one past the last contact
  bool approaches = false;
  for (const NearPair& pair : part.pairs) {
    if (!pair.touching || pair.material.stiffness) continue;
    const std::size_t first = contacts.size();
    bool hit = false;
    bool lay_down = false;
    const double slowest =
        std::max(slowest_bounce(setup, pair.b >= setup.movers, pair.manifold.normal), pair.slow);
    for (const auto& point : pair.manifold.points) {
      if (point.distance > pair.near) continue;
      const double speed = parting_speed(setup, state, pair, point.point);
      const bool fast = speed < -slowest;
      contacts.push_back(
          detail::contact_at(pair, point, fast ? -(pair.material.restitution * speed) : 0.0));
      hit = hit || fast;
      approaches = approaches || speed < -pair.slow;
      if (!fast && speed < -pair.slow && pair.material.restitution > 0) lay_down = true;
    }
    if (hit) hits.push_back({first, contacts.size()});
    if (lay_down && !hit) ++state.counts.rests;
  }
  if (!approaches) return;
  const auto impulses = detail::solve_now(setup, state, contacts);
  for (const auto& [first, last] : hits)
    detail::note_hit(setup, state, part, contacts, impulses, first, last);
  part.length = 0;
  ++part.cuts;
}
// [/impacts-stage]

namespace detail {

/// The contacts of islands in which a contact bounces, and the initial impulses.
struct BouncingContacts {
  std::vector<BodyContact<double>> contacts;
  std::vector<ContactImpulse<double>> start;
};

CONTACT_SCENES_INLINE BouncingContacts bouncing_contacts(const SteppedSetup& setup,
                                                         const SteppedState& state,
                                                         const StepPart& part) {
  std::vector<BodyContact<double>> pushed;
  for (const StepBounce& bounce : part.bounces) pushed.push_back(bounce.contact);
  const auto bounces = [&](std::size_t i) { return pushed[i].least_velocity > 0; };
  BouncingContacts found;
  for (const std::vector<std::size_t>& island : islands(setup, state, pushed)) {
    if (std::none_of(island.begin(), island.end(), bounces)) continue;
    for (const std::size_t i : island) {
      found.contacts.push_back(pushed[i]);
      found.start.push_back(part.bounces[i].stop);
    }
  }
  return found;
}

}  // namespace detail

// [bounces-stage]
CONTACT_SCENES_INLINE void solve_bounces(const SteppedSetup& setup, SteppedState& state,
                                         StepPart& part) {
  if (part.bounces.empty()) return;
  const auto all = detail::bouncing_contacts(setup, state, part);
  const auto make = [&](std::size_t place) {
    const Vector3<double> zero = Vector3<double>::Zero();
    return detail::solver_body(setup, state, place,
                               place < setup.movers ? part.free_velocity[place] : zero,
                               place < part.free_spin.size() ? part.free_spin[place] : zero);
  };
  const auto give = [&](std::size_t place, const RigidBody<double>& body) {
    part.bounced.push_back({place, body.velocity, body.spin, orientation_of(setup, state, place)});
  };
  const auto impulses = detail::solve_islands(setup, state, all.contacts, all.start, part.planned,
                                              detail::SweepsFor::bounces, make, give);
  for (std::size_t first = 0, last = 0; first < all.contacts.size(); first = last) {
    bool hit = false;
    for (; last < all.contacts.size() && all.contacts[last].a == all.contacts[first].a &&
           all.contacts[last].b == all.contacts[first].b;
         ++last)
      hit = hit || all.contacts[last].least_velocity > 0;
    if (hit) detail::note_hit(setup, state, part, all.contacts, impulses, first, last);
  }
}
// [/bounces-stage]

// [leaving-stage]
CONTACT_SCENES_INLINE void leave_bounced(const SteppedSetup& setup, SteppedState& state,
                                         StepPart& part) {
  for (const BouncedBody& body : part.bounced) {
    state.velocity.set(body.place, body.velocity);
    if (!turned_by_contacts(setup, body.place)) continue;
    Vector3<double> spin = body.spin;
    if (!setup.bodies[body.place].round) {
      const Vector3<double> own = matrix_of(body.orientation).transpose() * spin;
      spin = matrix_of(state.orientation[body.place]) * own;
    }
    state.spin.set(body.place, spin);
  }
}
// [/leaving-stage]

namespace detail {

/// Applies an impulse at a point to the velocities of two bodies at the end of the substep.
CONTACT_SCENES_INLINE void push_apart(const SteppedSetup& setup, const SteppedState& state,
                                      StepPart& part, const NearPair& pair,
                                      const RigidBody<double>& a, const RigidBody<double>& b,
                                      const Vector3<double>& point,
                                      const Vector3<double>& impulse) {
  const auto give = [&](std::size_t place, const RigidBody<double>& body,
                        const Vector3<double>& push) {
    if (place >= setup.movers || sleeps(state, place)) return;
    part.end_velocity.add(place, push * body.inverse_mass);
    part.pushed[place] = true;
    if (!turned_by_contacts(setup, place)) return;
    const Vector3<double> arm = point - body.position;
    part.end_spin.add(place, body.inverse_inertia * Vector3<double>(arm.cross(push)));
  };
  give(pair.a, a, impulse);
  give(pair.b, b, Vector3<double>(-impulse));
}

}  // namespace detail

// [springs-stage]
CONTACT_SCENES_INLINE void push_springs(const SteppedSetup& setup, SteppedState& state,
                                        StepPart& part) {
  bool near = false;
  for (const NearPair& pair : part.pairs)
    near = near || (pair.material.stiffness && pair.distance <= pair.reach);
  if (!near) return;
  part.planned = part.length = std::min(part.length, setup.spring_part);
  const double h = part.length;
  const auto make = [&](std::size_t place) {
    return detail::solver_body(setup, state, place, velocity_of(setup, state, place),
                               spin_of(state, place));
  };
  for (const NearPair& pair : part.pairs) {
    if (!pair.material.stiffness || pair.manifold.points.empty()) continue;
    const RigidBody<double> a = make(pair.a);
    const RigidBody<double> b = make(pair.b);
    const Vector3<double>& n = pair.manifold.normal;
    const double share = 1 / static_cast<double>(pair.manifold.points.size());
    const SpringDamper<double> spring{*pair.material.stiffness * share,
                                      pair.material.damping * share};
    // How gravity alone changes the speed of approach, m/s².
    const double pull =
        -n.dot(setup.scene.gravity) * ((a.inverse_mass > 0 ? 1 : 0) - (b.inverse_mass > 0 ? 1 : 0));
    for (const auto& point : pair.manifold.points) {
      const Vector3<double> slide = point_velocity(setup, state, pair.a, point.point) -
                                    point_velocity(setup, state, pair.b, point.point);
      const double approach = -n.dot(slide);
      const double depth = approach * (h / 2) - point.distance;
      const double give = response<double>(a, b, point.point, n, n);
      const double push =
          contact_push(spring, depth, approach + h * pull) / (1 + h * spring.damping * give);
      if (!(push > 0)) continue;
      Vector3<double> impulse = n * (push * h);
      const Vector3<double> along = slide + n * approach;
      const double speed = size_of(along);
      if (pair.material.friction > 0 && speed > 0) {
        const Vector3<double> way = along / speed;
        const double stop = speed / response<double>(a, b, point.point, way, way);
        impulse -= way * std::min(stop, pair.material.friction * push * h);
      }
      detail::push_apart(setup, state, part, pair, a, b, point.point, impulse);
      ++state.counts.contacts;
    }
  }
}
// [/springs-stage]

}  // namespace contact
