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

  void clear() {
    for (const std::size_t place : places) number[place] = -1;
    bodies.clear();
    places.clear();
  }
};

/// Contacts that hang together by bodies that move, each island by the contacts' indices. What
/// happens in one has nothing to do with another.
inline std::vector<std::vector<std::size_t>> islands(
    const SteppedSetup& setup, const SteppedState& state,
    const std::vector<BodyContact<double>>& contacts) {
  const std::size_t none = contacts.size();
  std::vector<std::size_t> towards(contacts.size());  // a contact of the same island, or itself
  std::vector<std::size_t> first(setup.bodies.size(), none);  // of a body
  const auto root = [&](std::size_t i) {
    while (towards[i] != i) i = towards[i] = towards[towards[i]];
    return i;
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    towards[i] = i;
    for (const int body : {contacts[i].a, contacts[i].b}) {
      const std::size_t place = index(body);
      if (place >= setup.movers || sleeps(state, place)) continue;
      if (first[place] == none) first[place] = i;
      const auto [low, high] = std::minmax({root(first[place]), root(i)});
      towards[high] = low;
    }
  }
  std::vector<std::vector<std::size_t>> found;
  std::vector<std::size_t> number(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::size_t top = root(i);  // not after i
    if (top == i) {
      number[i] = found.size();
      found.emplace_back();
    }
    found[number[top]].push_back(i);
  }
  return found;
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

/// So many contacts are solved at once, so that what is its own mirror image stays so. In larger
/// islands that would take too many sweeps.
inline constexpr std::size_t most_at_once = 8;

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
  limits.at_once = !alone && contacts.size() <= most_at_once;
  const std::size_t most = calm ? 100 * sweep_work : sweep_work;
  const auto many = static_cast<int>(most / (contacts.size() + 1));
  limits.sweeps =
      std::min(calm ? 100 * limits.sweeps : limits.sweeps, std::max(many, least_sweeps));
  SolvedContacts<double> solved = solve_contacts<double>(bodies, contacts, start, limits);
  count_sweeps(state, contacts.size(), solved.report.sweeps);
  return solved;
}

/// Solves contacts that are named by the bodies' places, island by island: a sweep over all would
/// go on for those that have long been right. `make(place)` is a body before, `give(place, body)`
/// takes one that moves after. Gives back the impulses.
template <class Make, class Give>
std::vector<ContactImpulse<double>> solve_islands(const SteppedSetup& setup, SteppedState& state,
                                                  const std::vector<BodyContact<double>>& contacts,
                                                  const std::vector<ContactImpulse<double>>& start,
                                                  bool calm, const Make& make, const Give& give) {
  std::vector<ContactImpulse<double>> impulses(contacts.size());
  ContactedBodies bodies(setup.bodies.size());
  for (const std::vector<std::size_t>& island : islands(setup, state, contacts)) {
    bodies.clear();
    std::vector<BodyContact<double>> named;
    std::vector<ContactImpulse<double>> before;
    for (const std::size_t i : island) {
      named.push_back(contacts[i]);
      named.back().a = bodies.add(index(contacts[i].a), make);
      named.back().b = bodies.add(index(contacts[i].b), make);
      if (!start.empty()) before.push_back(start[i]);
    }
    const auto solved = solve_numbered(setup, state, bodies.bodies, named, before, calm);
    for (std::size_t k = 0; k < island.size(); ++k) impulses[island[k]] = solved.impulses[k];
    for (std::size_t k = 0; k < bodies.places.size(); ++k) {
      const std::size_t place = bodies.places[k];
      if (place < setup.movers && !sleeps(state, place)) give(place, solved.bodies[k]);
    }
  }
  return impulses;
}

/// The same from the velocities that bodies have now, and these are changed.
inline std::vector<ContactImpulse<double>> solve_now(
    const SteppedSetup& setup, SteppedState& state,
    const std::vector<BodyContact<double>>& contacts) {
  const auto make = [&](std::size_t place) {
    return solver_body(setup, state, place, velocity_of(setup, state, place),
                       spin_of(state, place));
  };
  const auto give = [&](std::size_t place, const RigidBody<double>& body) {
    state.velocity.set(place, body.velocity);
    if (turned_by_contacts(setup, place)) state.spin[place] = body.spin;
  };
  return solve_islands(setup, state, contacts, {}, false, make, give);
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
  const auto impulses = detail::solve_now(setup, state, contacts);
  for (const auto& [first, last] : hits)
    detail::note_hit(setup, state, part, contacts, impulses, first, last);
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
  const auto give = [&](std::size_t place, const RigidBody<double>& body) {
    part.end_velocity.set(place, body.velocity);
    if (turned_by_contacts(setup, place)) part.end_spin[place] = body.spin;
  };
  double margin = 0;
  for (const NearPair& pair : part.pairs) margin = std::max(margin, pair.reach);
  const auto start = detail::warm_start(state, contacts, part.planned, margin);
  // As long as no impact has cut this step, what rests is worth more sweeps: a stack stands on
  // forces that have settled.
  const bool calm = setup.together && setup.one_by_one && part.cuts == 0;
  const auto impulses = detail::solve_islands(setup, state, contacts, start, calm, make, give);
  // What a very short part needed to stop an approach is no force that lasts.
  const bool lasts = part.planned * 64 >= setup.step;
  if (lasts) {
    state.touched.clear();
    state.pushed.clear();
  }
  std::vector<std::size_t> hit_pairs;  // their contacts
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactImpulse<double>& impulse = impulses[i];
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
    detail::note_hit(setup, state, part, contacts, impulses, hit_pairs[k], hit_pairs[next - 1] + 1);
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
  detail::solve_now(setup, state, part.bounces);
}
// [/bounces-stage]

}  // namespace contact
