/// @file
/// Stages: what the contacts of a part do. Impacts at one moment, the forces that hold bodies on
/// each other, and the bounces of impacts that are taken all at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <contact/contact_solver.hpp>
#include <contact/rigid_body.hpp>
#include <contact/stage_contacts.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

/// A mover as the solver wants it, with the given velocity and spin.
inline RigidBody<double> solver_body(const SteppedSetup& setup, const SteppedState& state,
                                     std::size_t place, const Vector3<double>& velocity,
                                     const Vector3<double>& spin) {
  const SteppedBody& body = setup.bodies[place];
  RigidBody<double> solid;
  solid.position = position_of(setup, state, place);
  if (place >= setup.movers || sleeps(state, place)) return solid;  // nothing moves it
  solid.mass = body.mass;
  solid.inverse_mass = 1 / body.mass;
  solid.velocity = velocity;
  if (!turned_by_contacts(setup, place)) return solid;
  const Vector3<double> inverse = body.moments.cwiseInverse();
  const auto& m = body.moments;
  solid.spin = spin;
  solid.inertia = diagonal<double>(m.x(), m.y(), m.z());
  solid.inverse_inertia = diagonal<double>(inverse.x(), inverse.y(), inverse.z());
  if (body.round) return solid;
  const Matrix3<double> turn = matrix_of(state.orientation[place]) * body.axes;
  solid.inertia = rotated<double>(solid.inertia, turn);
  solid.inverse_inertia = rotated<double>(solid.inverse_inertia, turn);
  return solid;
}

/// The bodies of some contacts, numbered anew: a body without a contact costs nothing.
struct ContactedBodies {
  std::vector<RigidBody<double>> bodies;
  std::vector<std::size_t> places;
  std::vector<int> number;  // by place; −1: not among them

  explicit ContactedBodies(std::size_t count) : number(count, -1) {}

  template <class Make>
  int add(std::size_t place, const Make& make) {
    if (number[place] < 0) {
      number[place] = static_cast<int>(bodies.size());
      bodies.push_back(make(place));
      places.push_back(place);
    }
    return number[place];
  }
};

/// The contacts with the bodies' numbers in place of their places.
template <class Make>
std::vector<BodyContact<double>> numbered(std::vector<BodyContact<double>> contacts,
                                          ContactedBodies& bodies, const Make& make) {
  for (BodyContact<double>& contact : contacts) {
    contact.a = bodies.add(index(contact.a), make);
    contact.b = bodies.add(index(contact.b), make);
  }
  return contacts;
}

inline BodyContact<double> contact_at(const NearPair& pair, const ManifoldPoint<double>& point,
                                      double least_velocity) {
  return {static_cast<int>(pair.a), static_cast<int>(pair.b), point.point,
          pair.manifold.normal,     pair.material.friction,   least_velocity};
}

inline void count_sweeps(SteppedState& state, std::size_t contacts, int sweeps) {
  state.counts.contacts += contacts;
  state.counts.sweeps += static_cast<std::uint64_t>(sweeps);
}

/// Sweeps are as many as this many contacts may take together, but not fewer than a few.
inline constexpr std::size_t sweep_work = 40000;
inline constexpr int least_sweeps = 50;

/// Solves contacts that are named by the bodies' numbers. Where no body has two contacts each is on
/// its own, and a sweep goes all the way to its answer.
inline SolvedContacts<double> solve_numbered(const SteppedSetup& setup, SteppedState& state,
                                             const std::vector<RigidBody<double>>& bodies,
                                             const std::vector<BodyContact<double>>& contacts,
                                             const std::vector<ContactImpulse<double>>& start,
                                             bool calm = false) {
  SweepLimits<double> limits = setup.sweeps;
  if (calm) limits.relaxation = 1.8;
  std::vector<int> count(bodies.size(), 0);
  bool alone = true;
  for (const BodyContact<double>& contact : contacts) {
    for (const int body : {contact.a, contact.b}) {
      const bool moves = bodies[index(body)].inverse_mass > 0;
      alone = alone && !(moves && ++count[index(body)] > 1);
    }
  }
  if (alone) limits.relaxation = 1;
  const std::size_t most = calm ? 100 * sweep_work : sweep_work;
  const auto many = static_cast<int>(most / (contacts.size() + 1));
  limits.sweeps =
      std::min(calm ? 100 * limits.sweeps : limits.sweeps, std::max(many, least_sweeps));
  SolvedContacts<double> solved = solve_contacts<double>(bodies, contacts, start, limits);
  count_sweeps(state, contacts.size(), solved.report.sweeps);
  return solved;
}

/// Notes a hit: the impulses at all points of a pair together, at their middle.
inline void note_hit(const SteppedSetup& setup, SteppedState& state, StepPart& part,
                     const std::vector<BodyContact<double>>& contacts,
                     const std::vector<ContactImpulse<double>>& impulses, std::size_t first,
                     std::size_t last) {
  SceneHit hit;
  hit.time = static_cast<double>(state.step) * setup.step + (setup.step - part.left);
  hit.first = setup.bodies[index(contacts[first].a)].body;
  hit.second = setup.bodies[index(contacts[first].b)].body;
  for (std::size_t i = first; i < last; ++i) {
    hit.point += contacts[i].point / static_cast<double>(last - first);
    hit.impulse += contacts[i].normal * impulses[i].normal + impulses[i].tangential;
  }
  part.hits.push_back(hit);
  ++state.counts.hits;
}

}  // namespace detail

// [impacts-stage]
/// Impacts of pairs that touch now and approach: each leaves with e times the speed with which it
/// came, or with none if that is slower than rest. All that touch at this moment are solved
/// together. Such a part has no length: velocities change, and no time passes.
inline void solve_impacts(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  if (part.at_once) return;
  std::vector<BodyContact<double>> contacts;
  std::vector<std::pair<std::size_t, std::size_t>> hits;  // first and one past the last contact
  bool approaches = false;
  for (const NearPair& pair : part.pairs) {
    if (!pair.touching || pair.material.stiffness) continue;
    const std::size_t first = contacts.size();
    bool hit = false;
    bool lay_down = false;
    for (const auto& point : pair.manifold.points) {
      if (point.distance > pair.touch) continue;
      const double speed = parting_speed(setup, state, pair, point.point);
      const bool fast = speed < -setup.rest_speed;
      contacts.push_back(
          detail::contact_at(pair, point, fast ? -(pair.material.restitution * speed) : 0.0));
      hit = hit || fast;
      approaches = approaches || speed < -setup.slow_speed;
      if (!fast && speed < -setup.slow_speed && pair.material.restitution > 0) lay_down = true;
    }
    if (hit) hits.push_back({first, contacts.size()});
    if (lay_down && !hit) ++state.counts.rests;
  }
  if (!approaches) return;
  const auto make = [&](std::size_t place) {
    return detail::solver_body(setup, state, place, velocity_of(setup, state, place),
                               spin_of(state, place));
  };
  detail::ContactedBodies bodies(setup.bodies.size());
  const auto named = detail::numbered(contacts, bodies, make);
  const auto solved = detail::solve_numbered(setup, state, bodies.bodies, named, {});
  for (std::size_t i = 0; i < bodies.places.size(); ++i) {
    const std::size_t place = bodies.places[i];
    if (place >= setup.movers || sleeps(state, place)) continue;
    state.velocity[place] = solved.bodies[i].velocity;
    if (turned_by_contacts(setup, place)) state.spin[place] = solved.bodies[i].spin;
  }
  for (const auto& [first, last] : hits)
    detail::note_hit(setup, state, part, contacts, solved.impulses, first, last);
  part.length = 0;
  ++part.cuts;
}
// [/impacts-stage]

namespace detail {

/// The forces of the part before, as impulses of this one: each for the contact of the same pair
/// that is nearest to where it was.
inline std::vector<ContactImpulse<double>> warm_start(
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
      const auto& force = state.pushed[static_cast<std::size_t>(then - state.touched.begin())];
      start[i] = {force.normal * length, Vector3<double>(force.tangential * length)};
    }
  }
  return start;
}

}  // namespace detail

// [forces-stage]
/// The forces that last: what holds bodies on each other, and rubs them, through this part.
///
/// Points that touch do not come closer. A gap may close, and no more. A force acts evenly, so its
/// body moves with the mean of the velocities at both ends of the part. What closes a gap acts at
/// the start: its body has its end velocity all through, and does not come too far.
///
/// Where all impacts of the step are taken at once, each first comes to touch. How it bounces
/// then is the business of the bounces stage.
inline void solve_forces(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  std::vector<BodyContact<double>> contacts;
  std::vector<double> gaps;
  std::vector<double> speeds;
  for (const NearPair& pair : part.pairs) {
    if (pair.material.stiffness || (pair.leaving && !part.at_once)) continue;
    for (const auto& point : pair.manifold.points) {
      const double gap = std::max(point.distance, 0.0);
      const bool touches = point.distance <= pair.touch;
      contacts.push_back(detail::contact_at(pair, point, touches ? 0.0 : -(gap / part.planned)));
      gaps.push_back(touches ? 0.0 : gap);
      speeds.push_back(parting_speed(setup, state, pair, point.point));
    }
  }
  if (contacts.empty()) {
    state.touched.clear();
    state.pushed.clear();
    return;
  }
  const auto make = [&](std::size_t place) {
    const bool mover = place < setup.movers;
    const bool turns = place < part.end_spin.size();
    return detail::solver_body(
        setup, state, place,
        mover ? part.end_velocity[place] : Vector3<double>(Vector3<double>::Zero()),
        turns ? part.end_spin[place] : Vector3<double>(Vector3<double>::Zero()));
  };
  detail::ContactedBodies bodies(setup.bodies.size());
  const auto named = detail::numbered(contacts, bodies, make);
  double margin = 0;
  for (const NearPair& pair : part.pairs) margin = std::max(margin, pair.reach);
  const auto start = detail::warm_start(state, contacts, part.planned, margin);
  // As long as no impact has cut this step, what rests is worth more sweeps: a stack stands on
  // forces that have settled.
  const bool calm = setup.together && setup.one_by_one && part.cuts == 0;
  const auto solved = detail::solve_numbered(setup, state, bodies.bodies, named, start, calm);
  for (std::size_t i = 0; i < bodies.places.size(); ++i) {
    const std::size_t place = bodies.places[i];
    if (place >= setup.movers || sleeps(state, place)) continue;
    part.end_velocity[place] = solved.bodies[i].velocity;
    if (turned_by_contacts(setup, place)) part.end_spin[place] = solved.bodies[i].spin;
  }
  // What a very short part needed to stop an approach is no force that lasts.
  const bool lasts = part.planned * 64 >= setup.step;
  if (lasts) {
    state.touched.clear();
    state.pushed.clear();
  }
  std::vector<std::size_t> hit_pairs;  // their contacts
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactImpulse<double>& impulse = solved.impulses[i];
    if (!(impulse.normal > 0)) continue;
    const bool hits = part.at_once && speeds[i] < -setup.rest_speed;
    for (const int body : {contacts[i].a, contacts[i].b}) {
      const std::size_t place = detail::index(body);
      if (place >= setup.movers) continue;
      part.pushed[place] = true;
      if (gaps[i] > 0 || hits) part.at_start[place] = true;
    }
    if (lasts) {
      state.touched.push_back(contacts[i]);
      state.pushed.push_back(
          {impulse.normal / part.planned, Vector3<double>(impulse.tangential / part.planned)});
    }
    if (!part.at_once) continue;
    const double e = setup
                         .material[setup.bodies[detail::index(contacts[i].a)].material *
                                       setup.scene.materials.size() +
                                   setup.bodies[detail::index(contacts[i].b)].material]
                         .restitution;
    part.bounces.push_back(contacts[i]);
    part.bounces.back().least_velocity = hits ? -(e * speeds[i]) : 0.0;
    if (hits) hit_pairs.push_back(i);
  }
  // A pair that hits at several points hits once.
  for (std::size_t k = 0; k < hit_pairs.size();) {
    std::size_t next = k;
    while (next < hit_pairs.size() && contacts[hit_pairs[next]].a == contacts[hit_pairs[k]].a &&
           contacts[hit_pairs[next]].b == contacts[hit_pairs[k]].b)
      ++next;
    detail::note_hit(setup, state, part, contacts, solved.impulses, hit_pairs[k],
                     hit_pairs[next - 1] + 1);
    k = next;
  }
}
// [/forces-stage]

// [bounces-stage]
/// Of impacts that were taken all at once: now that they touch, they leave as restitution says.
inline void solve_bounces(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  bool any = false;
  for (const BodyContact<double>& contact : part.bounces) any = any || contact.least_velocity > 0;
  if (!any) return;
  const auto make = [&](std::size_t place) {
    return detail::solver_body(setup, state, place, velocity_of(setup, state, place),
                               spin_of(state, place));
  };
  detail::ContactedBodies bodies(setup.bodies.size());
  const auto named = detail::numbered(part.bounces, bodies, make);
  const auto solved = detail::solve_numbered(setup, state, bodies.bodies, named, {});
  for (std::size_t i = 0; i < bodies.places.size(); ++i) {
    const std::size_t place = bodies.places[i];
    if (place >= setup.movers || sleeps(state, place)) continue;
    state.velocity[place] = solved.bodies[i].velocity;
    if (turned_by_contacts(setup, place)) state.spin[place] = solved.bodies[i].spin;
  }
}
// [/bounces-stage]

}  // namespace contact
