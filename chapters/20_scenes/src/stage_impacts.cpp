#include <contact/stepped/stage_impacts.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <contact/contact_active_set.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/spring_damper.hpp>
#include <contact/stepped/stage_contact_events.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/step_solver.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Whether a body of a pair's contacts has contacts with other bodies too. An impact then reaches
/// them at the same instant, and how they share it is a choice of the model: all at once.
CONTACT_SCENES_INLINE bool shares_impact(const SteppedSetup& setup,
                                         const std::vector<BodyContact<double>>& contacts,
                                         std::size_t first, std::size_t last) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i >= first && i < last) continue;
    for (const int one : {contacts[first].a, contacts[first].b})
      for (const int other : {contacts[i].a, contacts[i].b})
        if (one == other && index(one) < setup.movers) return true;
  }
  return false;
}

}  // namespace detail

// [impacts-stage]
CONTACT_SCENES_INLINE void solve_impacts(const SteppedSetup& setup, SteppedState& state,
                                         Substep& substep) {
  if (substep.simultaneous) return;
  std::vector<BodyContact<double>> contacts;
  std::vector<std::pair<std::size_t, std::size_t>> hits;  // first and one past the last contact
  bool approaches = false;
  for (const NearPair& pair : substep.pairs) {
    if (!pair.touching || pair.material.stiffness) continue;
    const std::size_t first = contacts.size();
    bool hit = false;
    bool lay_down = false;
    double laid = 0;  // with which speed, m/s
    const double slowest =
        std::max(slowest_bounce(setup, pair.b >= setup.movers, pair.manifold.normal), pair.slow);
    for (const auto& point : pair.manifold.points) {
      if (point.distance > pair.near) continue;
      const double speed = separation_speed(setup, state, pair, point.point);
      const bool fast = speed < -slowest;
      contacts.push_back(
          detail::contact_at(pair, point, fast ? -(pair.material.restitution * speed) : 0.0));
      hit = hit || fast;
      approaches = approaches || speed < -pair.slow;
      if (!fast && speed < -pair.slow) note_slow_impact(setup, state, substep, pair, -speed);
      if (!fast && speed < -pair.slow && pair.material.restitution > 0) {
        lay_down = true;
        laid = std::max(laid, -speed);
      }
    }
    if (hit) hits.push_back({first, contacts.size()});
    if (lay_down && !hit) {
      ++state.counts.rests;
      if (laid * setup.step > min_error(setup)) {
        const double now = time_of_substep(setup, state, substep);
        state.counts.doubts.add(RunDoubt::contact, now);
        state.counts.doubts.add(RunDoubt::rest, now);
      }
    }
  }
  if (!approaches) return;
  const auto impulses = detail::solve_now(setup, state, contacts);
  for (const auto& [first, last] : hits) {
    detail::record_hit(setup, state, substep, contacts, impulses, first, last);
    if (detail::shares_impact(setup, contacts, first, last))
      state.counts.doubts.add(RunDoubt::crowd, time_of_substep(setup, state, substep));
  }
  substep.length = 0;
  ++substep.cuts;
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
                                                         const Substep& substep) {
  std::vector<BodyContact<double>> pushed;
  for (const StepBounce& bounce : substep.bounces) pushed.push_back(bounce.contact);
  const auto bounces = [&](std::size_t i) { return pushed[i].min_velocity > 0; };
  BouncingContacts found;
  for (const std::vector<std::size_t>& island : islands(setup, state, pushed)) {
    if (std::none_of(island.begin(), island.end(), bounces)) continue;
    for (const std::size_t i : island) {
      found.contacts.push_back(pushed[i]);
      found.start.push_back(substep.bounces[i].stop);
    }
  }
  return found;
}

// [bounce-energy]
/// The energy of some bodies at the end of a substep, as a parabola in the share of their bounce:
/// 0 ends with the velocities without restitution, 1 with those after it.
struct BounceEnergy {
  double square = 0;
  double linear = 0;
  double constant = 0;  // less the energy that they may have
  double size = 0;      // of the terms, for their rounding

  /// The largest share that adds no energy.
  double share() const {
    const double slack = 0x1p8 * std::numeric_limits<double>::epsilon() * size;
    if (square + linear + constant <= slack) return 1;
    if (!(constant < 0)) return 0;
    const double root = std::sqrt(std::max(linear * linear - 4 * square * constant, 0.0));
    const double sum = linear + root;
    return sum > 0 ? std::clamp(-2 * constant / sum, 0.0, 1.0) : 0;
  }
};

/// A bounced body may have its energy at the start, and the work of gravity and springs on its way.
CONTACT_SCENES_INLINE void add_energy(const SteppedSetup& setup, const SteppedState& state,
                                      const Substep& substep, const BouncedBody& bounced,
                                      BounceEnergy& sum) {
  const std::size_t slot = bounced.slot;
  const Vector3<double> before = velocity_of(setup, state, slot);
  const Vector3<double> stopped = substep.end_velocity[slot];
  const Vector3<double> change = bounced.velocity - stopped;
  const Vector3<double> mean = (first_velocity(state, substep, slot) + stopped) / 2;
  const double mass = setup.bodies[slot].mass;
  const double work = mass * Vector3<double>(substep.free_velocity[slot] - before).dot(mean);
  const auto add = [&sum](double squares, double products, double stops, double starts) {
    sum.square += squares / 2;
    sum.linear += products;
    sum.constant += (stops - starts) / 2;
    sum.size += squares + std::abs(products) + stops + starts;
  };
  add(mass * change.dot(change), mass * stopped.dot(change), mass * stopped.dot(stopped),
      mass * before.dot(before));
  sum.constant -= work;
  sum.size += std::abs(work);
  if (!rotated_by_contacts(setup, slot)) return;
  const Vector3<double> spin = angular_velocity_of(state, slot);
  const Vector3<double> slowed = substep.end_angular_velocity[slot];
  const Vector3<double> turn = bounced.angular_velocity - slowed;
  const Matrix3<double> inertia = solver_body(setup, state, slot, before, spin).inertia;
  add(turn.dot(inertia * turn), slowed.dot(inertia * turn), slowed.dot(inertia * slowed),
      spin.dot(inertia * spin));
}

/// Bodies that bounce during a substep leave from where they were stopped. Gravity has changed
/// their velocities for the whole substep, but has not moved them so far: with all of that change,
/// a bounce would add energy. Each island gets the share of its bounce that adds none.
CONTACT_SCENES_INLINE void limit_energy(const SteppedSetup& setup, const SteppedState& state,
                                        Substep& substep, const BouncingContacts& all,
                                        std::vector<ContactImpulse<double>>& impulses) {
  const std::vector<BodyContact<double>>& contacts = all.contacts;
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> at(setup.movers, none);  // where a body is among those that bounced
  for (std::size_t i = 0; i < substep.bounced.size(); ++i) at[substep.bounced[i].slot] = i;
  for (const std::vector<std::size_t>& island : islands(setup, state, contacts)) {
    std::vector<std::size_t> bodies;
    for (const std::size_t i : island)
      for (const int body : {contacts[i].a, contacts[i].b})
        if (index(body) < setup.movers && at[index(body)] != none)
          bodies.push_back(std::exchange(at[index(body)], none));
    BounceEnergy energy;
    for (const std::size_t i : bodies)
      add_energy(setup, state, substep, substep.bounced[i], energy);
    const double share = energy.share();
    if (share == 1) continue;
    for (const std::size_t i : island) {
      const ContactImpulse<double>& stop = all.start[i];
      impulses[i].normal = stop.normal + (impulses[i].normal - stop.normal) * share;
      const Vector3<double> more = impulses[i].tangential - stop.tangential;
      impulses[i].tangential = stop.tangential + more * share;
    }
    for (const std::size_t i : bodies) {
      BouncedBody& body = substep.bounced[i];
      const Vector3<double> stopped = substep.end_velocity[body.slot];
      body.velocity = stopped + (body.velocity - stopped) * share;
      if (!rotated_by_contacts(setup, body.slot)) continue;
      const Vector3<double> slowed = substep.end_angular_velocity[body.slot];
      body.angular_velocity = slowed + (body.angular_velocity - slowed) * share;
    }
  }
}
// [/bounce-energy]

}  // namespace detail

// [bounces-stage]
CONTACT_SCENES_INLINE void solve_bounces(const SteppedSetup& setup, SteppedState& state,
                                         Substep& substep) {
  if (substep.bounces.empty()) return;
  const auto all = detail::bouncing_contacts(setup, state, substep);
  const auto make = [&](std::size_t slot) {
    const Vector3<double> zero = Vector3<double>::Zero();
    return detail::solver_body(
        setup, state, slot, slot < setup.movers ? substep.free_velocity[slot] : zero,
        slot < substep.free_angular_velocity.size() ? substep.free_angular_velocity[slot] : zero);
  };
  const auto give = [&](std::size_t slot, const RigidBody<double>& body) {
    substep.bounced.push_back(
        {slot, body.velocity, body.angular_velocity, orientation_of(setup, state, slot)});
  };
  auto impulses = detail::solve_islands(setup, state, all.contacts, all.start, substep.planned,
                                        detail::SolveFor::bounces, make, give);
  detail::limit_energy(setup, state, substep, all, impulses);
  for (std::size_t first = 0, last = 0; first < all.contacts.size(); first = last) {
    bool hit = false;
    for (; last < all.contacts.size() && all.contacts[last].a == all.contacts[first].a &&
           all.contacts[last].b == all.contacts[first].b;
         ++last)
      hit = hit || all.contacts[last].min_velocity > 0;
    if (hit) detail::record_hit(setup, state, substep, all.contacts, impulses, first, last);
  }
}
// [/bounces-stage]

// [leaving-stage]
CONTACT_SCENES_INLINE void apply_bounces(const SteppedSetup& setup, SteppedState& state,
                                         Substep& substep) {
  for (const BouncedBody& body : substep.bounced) {
    state.velocity.set(body.slot, body.velocity);
    if (!rotated_by_contacts(setup, body.slot)) continue;
    Vector3<double> angular_velocity = body.angular_velocity;
    if (!setup.bodies[body.slot].round) {
      const Vector3<double> own = matrix_of(body.orientation).transpose() * angular_velocity;
      angular_velocity = matrix_of(state.orientation[body.slot]) * own;
    }
    state.angular_velocity.set(body.slot, angular_velocity);
  }
}
// [/leaving-stage]

namespace detail {

/// Applies an impulse at a point to the velocities of two bodies at the end of the substep.
CONTACT_SCENES_INLINE void projected_newton(const SteppedSetup& setup, const SteppedState& state,
                                            Substep& substep, const NearPair& pair,
                                            const RigidBody<double>& a, const RigidBody<double>& b,
                                            const Vector3<double>& point,
                                            const Vector3<double>& impulse) {
  const auto give = [&](std::size_t slot, const RigidBody<double>& body,
                        const Vector3<double>& push) {
    if (slot >= setup.movers || sleeps(state, slot)) return;
    substep.end_velocity.add(slot, push * body.inverse_mass);
    substep.contacted[slot] = true;
    if (!rotated_by_contacts(setup, slot)) return;
    const Vector3<double> lever_arm = point - body.position;
    substep.end_angular_velocity.add(slot,
                                     body.inverse_inertia * Vector3<double>(lever_arm.cross(push)));
  };
  give(pair.a, a, impulse);
  give(pair.b, b, Vector3<double>(-impulse));
}

}  // namespace detail

// [springs-stage]
CONTACT_SCENES_INLINE void apply_spring_forces(const SteppedSetup& setup, SteppedState& state,
                                               Substep& substep) {
  bool near = false;
  for (const NearPair& pair : substep.pairs)
    near = near || (pair.material.stiffness && pair.distance <= pair.closing_distance);
  if (!near) return;
  substep.planned = substep.length = std::min(substep.length, setup.spring_substep);
  const double h = substep.length;
  const auto make = [&](std::size_t slot) {
    return detail::solver_body(setup, state, slot, velocity_of(setup, state, slot),
                               angular_velocity_of(state, slot));
  };
  for (const NearPair& pair : substep.pairs) {
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
      const double give = inverse_effective_mass<double>(a, b, point.point, n, n);
      const double push =
          contact_force(spring, depth, approach + h * pull) / (1 + h * spring.damping * give);
      if (!(push > 0)) continue;
      Vector3<double> impulse = n * (push * h);
      const Vector3<double> along = slide + n * approach;
      const double speed = size_of(along);
      if (pair.material.friction > 0 && speed > 0) {
        const Vector3<double> way = along / speed;
        const double stop = speed / inverse_effective_mass<double>(a, b, point.point, way, way);
        impulse -= way * std::min(stop, pair.material.friction * push * h);
      }
      detail::projected_newton(setup, state, substep, pair, a, b, point.point, impulse);
      ++state.counts.contacts;
      const double now = time_of_substep(setup, state, substep);
      state.counts.doubts.add(RunDoubt::contact, now);
      state.counts.doubts.add(RunDoubt::spring, now);
    }
  }
}
// [/springs-stage]

}  // namespace contact
