#include <contact/stepped/stage_forces.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <contact/contact_active_set.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_contact_events.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/step_solver.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The forces of the last substep, as impulses of this one: each for the nearest contact of the
/// same pair.
CONTACT_SCENES_INLINE std::vector<ContactImpulse<double>> warm_start(
    const SteppedState& state, const std::vector<BodyContact<double>>& contacts, double length,
    double margin) {
  std::vector<ContactImpulse<double>> start(contacts.size());
  const auto before = [](const BodyContact<double>& x, const BodyContact<double>& y) {
    return x.a < y.a || (x.a == y.a && x.b < y.b);
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto [first, last] =
        std::equal_range(state.touched.begin(), state.touched.end(), contacts[i], before);
    double nearest = margin * margin;
    for (auto then = first; then != last; ++then) {
      const Vector3<double> between = then->point - contacts[i].point;
      if (!(between.dot(between) < nearest)) continue;
      nearest = between.dot(between);
      const auto& force =
          state.last_impulses[static_cast<std::size_t>(then - state.touched.begin())];
      start[i] = {force.normal * length, Vector3<double>(force.tangential * length)};
    }
  }
  return start;
}

/// The speed of approach of two bodies at a point, now and at the end of the substep, m/s.
struct Closing {
  double now = 0;
  double then = 0;  // without contacts

  /// On touching, after a distance. The acceleration is constant, so the square of the speed grows
  /// linearly with the distance. 0 if they separate now.
  double after(double gap, double time) const {
    if (!(now > 0)) return 0;
    return std::sqrt(std::max(now * now + 2 * ((then - now) / time) * gap, 0.0));
  }
};

CONTACT_SCENES_INLINE double restitution_of(const SteppedSetup& setup,
                                            const BodyContact<double>& contact) {
  const auto row = setup.bodies[index(contact.a)].material * setup.scene.materials.size();
  return setup.material[row + setup.bodies[index(contact.b)].material].restitution;
}

CONTACT_SCENES_INLINE Closing closing_of(const SteppedSetup& setup, const SteppedState& state,
                                         const Substep& substep, const NearPair& pair,
                                         const Vector3<double>& point) {
  const auto change = [&](std::size_t slot) {
    if (slot >= setup.movers) return Vector3<double>(Vector3<double>::Zero());
    Vector3<double> of_point = substep.end_velocity[slot] - state.velocity[slot];
    if (!rotated_by_contacts(setup, slot)) return of_point;
    const Vector3<double> lever_arm = point - position_of(setup, state, slot);
    of_point += Vector3<double>(substep.end_angular_velocity[slot] - state.angular_velocity[slot])
                    .cross(lever_arm);
    return of_point;
  };
  const double now = -separation_speed(setup, state, pair, point);
  const Vector3<double> changes = change(pair.b) - change(pair.a);
  return {now, now + pair.manifold.normal.dot(changes)};
}

/// A body that is pushed at the start pushes at the start what it touches, and so on: with the mean
/// of two velocities that would react too late.
CONTACT_SCENES_INLINE void push_on(const SteppedSetup& setup, const SteppedState& state,
                                   Substep& substep,
                                   const std::vector<BodyContact<double>>& contacts,
                                   const std::vector<ContactImpulse<double>>& impulses) {
  std::vector<BodyContact<double>> pushing;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (impulses[i].normal > 0) pushing.push_back(contacts[i]);
  const auto moves = [&](int body) { return index(body) < setup.movers; };
  const auto at_start = [&](int body) { return moves(body) && substep.at_start[index(body)]; };
  for (const std::vector<std::size_t>& island : islands(setup, state, pushing)) {
    const bool some = std::any_of(island.begin(), island.end(), [&](std::size_t i) {
      return at_start(pushing[i].a) || at_start(pushing[i].b);
    });
    if (!some) continue;
    for (const std::size_t i : island)
      for (const int body : {pushing[i].a, pushing[i].b})
        if (moves(body)) substep.at_start[index(body)] = true;
  }
}

/// Bodies that contacts push at the start still fall with constant acceleration where no contact
/// holds them: perpendicular to the normals of all contacts. Friction holds in all directions.
CONTACT_SCENES_INLINE void change_evenly(const SteppedSetup& setup, const SteppedState& state,
                                         Substep& substep,
                                         const std::vector<BodyContact<double>>& contacts,
                                         const std::vector<ContactImpulse<double>>& impulses) {
  std::vector<std::vector<Vector3<double>>> held(setup.movers);  // orthonormal
  std::vector<bool> has_friction(setup.movers, false);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!(impulses[i].normal > 0)) continue;
    for (const int body : {contacts[i].a, contacts[i].b}) {
      const std::size_t slot = index(body);
      if (slot >= setup.movers || !substep.at_start[slot]) continue;
      has_friction[slot] = has_friction[slot] || impulses[i].tangential != Vector3<double>::Zero();
      Vector3<double> rest = contacts[i].normal;
      for (const Vector3<double>& n : held[slot]) rest -= n * n.dot(rest);
      const double size = size_of(rest);
      if (size > 0x1p-20) held[slot].push_back(rest / size);
    }
  }
  substep.even.assign(setup.movers, Vector3<double>::Zero());
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (!substep.at_start[i] || has_friction[i]) continue;
    substep.even[i] = substep.free_velocity[i] - state.velocity[i];
    for (const Vector3<double>& n : held[i]) substep.even[i] -= n * n.dot(substep.even[i]);
  }
}

}  // namespace detail

// [forces-stage]
CONTACT_SCENES_INLINE void solve_forces(const SteppedSetup& setup, SteppedState& state,
                                        Substep& substep) {
  substep.free_velocity = substep.end_velocity;
  if (substep.simultaneous) substep.free_angular_velocity = substep.end_angular_velocity;
  std::vector<BodyContact<double>> contacts;
  std::vector<double> gaps;
  std::vector<detail::Closing> closing;
  for (const NearPair& pair : substep.pairs) {
    if (pair.material.stiffness || (pair.leaving && !substep.simultaneous)) continue;
    // At a distance of only some roundings, a body that rests or slides beside it moves half that
    // distance with the mean of its velocities, which is not too late.
    const auto rounds = [&](const ManifoldPoint<double>& point, double gap) {
      const double way = -separation_speed(setup, state, pair, point.point) * substep.planned;
      return !substep.simultaneous && gap <= 16 * pair.near && way <= gap + 2 * pair.near;
    };
    const double falls = falling_away(setup, state, substep, pair);
    for (const auto& point : pair.manifold.points) {
      const double gap = std::max(point.distance, 0.0);
      const bool touches = point.distance <= pair.touch;
      double min_velocity = touches ? 0.0 : -(gap / substep.planned);
      if (falls > 0 && point.distance <= pair.near) min_velocity = -(2 * falls / substep.planned);
      contacts.push_back(detail::contact_at(pair, point, min_velocity));
      gaps.push_back(touches || rounds(point, gap) ? 0.0 : gap);
      if (substep.simultaneous)
        closing.push_back(detail::closing_of(setup, state, substep, pair, point.point));
    }
  }
  if (contacts.empty()) {
    state.touched.clear();
    state.last_impulses.clear();
    return;
  }
  const auto make = [&](std::size_t slot) {
    const bool mover = slot < setup.movers;
    const bool turns = slot < substep.end_angular_velocity.size();
    return detail::solver_body(
        setup, state, slot,
        mover ? substep.end_velocity[slot] : Vector3<double>(Vector3<double>::Zero()),
        turns ? substep.end_angular_velocity[slot] : Vector3<double>(Vector3<double>::Zero()));
  };
  const auto give = [&](std::size_t slot, const RigidBody<double>& body) {
    substep.end_velocity.set(slot, body.velocity);
    if (rotated_by_contacts(setup, slot))
      substep.end_angular_velocity.set(slot, body.angular_velocity);
  };
  double margin = 0;
  for (const NearPair& pair : substep.pairs) margin = std::max(margin, pair.closing_distance);
  const auto start = detail::warm_start(state, contacts, substep.planned, margin);
  // As long as no impact has divided this step, resting contacts get more iterations: a stack
  // depends on converged forces.
  const bool calm = setup.together && setup.one_by_one && substep.cuts == 0;
  const auto impulses =
      detail::solve_islands(setup, state, contacts, start, substep.planned,
                            calm ? detail::SolveFor::rest : detail::SolveFor::anything, make, give);
  // The impulse with which a very short substep stops an approach is not a lasting force.
  const bool lasts = substep.planned * 64 >= setup.step;
  if (lasts) {
    state.touched.clear();
    state.last_impulses.clear();
  }
  std::vector<std::size_t> hit_pairs;  // contacts of these
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactImpulse<double>& impulse = impulses[i];
    if (!(impulse.normal > 0)) continue;
    substep.pushing.push_back({contacts[i], impulse});
    const double came = substep.simultaneous ? closing[i].after(gaps[i], substep.planned) : 0;
    const bool still = detail::index(contacts[i].b) >= setup.movers;
    const bool hits = came > 0 && came > slowest_bounce(setup, still, contacts[i].normal);
    for (const int body : {contacts[i].a, contacts[i].b}) {
      const std::size_t slot = detail::index(body);
      if (slot >= setup.movers) continue;
      substep.contacted[slot] = true;
      if (gaps[i] > 0 || hits) substep.at_start[slot] = true;
    }
    // A hit is not a lasting force.
    if (lasts && !hits) {
      state.touched.push_back(contacts[i]);
      state.last_impulses.push_back({impulse.normal / substep.planned,
                                     Vector3<double>(impulse.tangential / substep.planned)});
    }
    if (!substep.simultaneous) continue;
    const double e = hits ? detail::restitution_of(setup, contacts[i]) : 0;
    substep.bounces.push_back({contacts[i], impulse});
    substep.bounces.back().contact.min_velocity = e * came;
    if (hits && !(e > 0)) hit_pairs.push_back(i);
  }
  if (std::find(substep.at_start.begin(), substep.at_start.end(), true) != substep.at_start.end()) {
    detail::push_on(setup, state, substep, contacts, impulses);
    detail::change_evenly(setup, state, substep, contacts, impulses);
  }
  // A pair that hits at several points hits once.
  for (std::size_t k = 0; k < hit_pairs.size();) {
    std::size_t next = k;
    while (next < hit_pairs.size() && contacts[hit_pairs[next]].a == contacts[hit_pairs[k]].a &&
           contacts[hit_pairs[next]].b == contacts[hit_pairs[k]].b)
      ++next;
    detail::record_hit(setup, state, substep, contacts, impulses, hit_pairs[k],
                       hit_pairs[next - 1] + 1);
    k = next;
  }
}
// [/forces-stage]

}  // namespace contact
