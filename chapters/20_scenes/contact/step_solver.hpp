/// @file
/// How the stages hand contacts to 18's solver: island by island, and only bodies that have
/// contacts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <contact/contact_finish.hpp>
#include <contact/contact_solver.hpp>
#include <contact/rigid_body.hpp>
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
  if (!body.round) {
    const Matrix3<double> turn = matrix_of(state.orientation[place]) * body.axes;
    solid.inertia = rotated<double>(solid.inertia, turn);
    solid.inverse_inertia = rotated<double>(solid.inverse_inertia, turn);
  }
  // What a mirror forbids, no push does: a spin that nobody keeps would take energy along.
  for (int k = 0; k < 3; ++k) {
    if (setup.turns[static_cast<std::size_t>(k)]) continue;
    solid.inverse_inertia.row(k).setZero();
    solid.inverse_inertia.col(k).setZero();
  }
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

/// Sweeps are as many as this many contacts may take together, but not fewer than a few. In a crowd
/// the few are fewer, and more if somebody would come through somebody else.
inline constexpr std::size_t sweep_work = 40000;
inline constexpr int least_sweeps = 50;
inline constexpr std::size_t crowd_work = 100000;
inline constexpr int least_crowd_sweeps = 4;

/// What contacts are solved for. What rests is finished by elimination, and gets a hundred times
/// the sweeps where that does not end it. Bounces get as many as there is work for, even in a
/// crowd: an impulse that is not finished loses energy. Impacts at one moment are finished too:
/// until they are, no time passes.
enum class SweepsFor { anything, rest, bounces, impacts };
inline constexpr std::size_t bounce_work = 5000;
inline constexpr int bounce_sweeps = 100;
inline constexpr int sweeps_before_finish = 100;

/// So many contacts are solved at once, so that what is its own mirror image stays so. In larger
/// islands that would take too many sweeps.
inline constexpr std::size_t most_at_once = 8;

/// How sweeps of these contacts go. Where no body has two contacts each is on its own, and a sweep
/// goes all the way to its answer.
inline SweepLimits<double> sweep_limits(const SteppedSetup& setup,
                                        const std::vector<RigidBody<double>>& bodies,
                                        const std::vector<BodyContact<double>>& contacts,
                                        SweepsFor what) {
  SweepLimits<double> limits = setup.sweeps;
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
  std::size_t work = setup.one_by_one ? sweep_work : crowd_work;
  const int least = setup.one_by_one ? least_sweeps : least_crowd_sweeps;
  if (what == SweepsFor::rest) {
    if (!alone) limits.relaxation = 1.8;
    limits.sweeps *= 100;
    work *= 100;
  } else if (what == SweepsFor::bounces) {
    limits.sweeps = bounce_sweeps;
    work = bounce_work;
  }
  const auto many = static_cast<int>(work / (contacts.size() + 1));
  limits.sweeps = std::min(limits.sweeps, std::max(many, least));
  return limits;
}

/// Solves contacts that are named by the bodies' numbers.
inline SolvedContacts<double> solve_swept(SteppedState& state,
                                          const std::vector<RigidBody<double>>& bodies,
                                          const std::vector<BodyContact<double>>& contacts,
                                          const std::vector<ContactImpulse<double>>& start,
                                          const SweepLimits<double>& limits) {
  SolvedContacts<double> solved = solve_contacts<double>(bodies, contacts, start, limits);
  count_sweeps(state, contacts.size(), solved.report.sweeps);
  return solved;
}

/// Solves what rests: a few sweeps, then elimination, and one sweep looks whether that was the end.
/// If not, sweeps go on from there.
inline SolvedContacts<double> solve_resting(SteppedState& state,
                                            const std::vector<RigidBody<double>>& bodies,
                                            const std::vector<BodyContact<double>>& contacts,
                                            const std::vector<ContactImpulse<double>>& start,
                                            const SweepLimits<double>& limits) {
  SweepLimits<double> few = limits;
  few.sweeps = std::min(limits.sweeps, sweeps_before_finish);
  auto swept = solve_swept(state, bodies, contacts, start, few);
  if (!(swept.report.last_change > limits.tolerance)) return swept;
  auto finished = finish_contacts<double>(bodies, contacts, swept.impulses);
  if (finished) {
    SweepLimits<double> one = limits;
    one.sweeps = 1;
    one.relaxation = 1;
    const auto look = solve_swept(state, bodies, contacts, finished->impulses, one);
    finished->report = look.report;
    if (look.report.last_change <= 8 * std::max(limits.tolerance, look.report.rounding))
      return *finished;
  }
  SweepLimits<double> many = limits;
  many.sweeps -= few.sweeps;
  if (many.sweeps < 1) return finished ? *finished : swept;
  swept =
      solve_swept(state, bodies, contacts, finished ? finished->impulses : swept.impulses, many);
  if (finished && finished->report.last_change < swept.report.last_change) return *finished;
  return swept;
}

/// Between bodies whose masses differ by more than this, sweeps get nowhere, and where something
/// rubs too they are finished. Among others more sweeps cost less.
inline constexpr double unlike_masses = 64;

/// Whether what the sweeps have left is to be finished: nothing may come far into somebody else,
/// and no bounce may lose much of its energy.
inline bool unfinished(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                       const std::vector<BodyContact<double>>& contacts, double left, double time,
                       SweepsFor what) {
  double fastest = 0;
  bool rubs = false;
  for (const BodyContact<double>& contact : contacts) {
    fastest = std::max(fastest, contact.least_velocity);
    rubs = rubs || contact.friction > 0;
  }
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const RigidBody<double>& body : bodies) {
    if (!(body.inverse_mass > 0)) continue;
    least = std::min(least, body.mass);
    most = std::max(most, body.mass);
  }
  const bool unlike = most >= unlike_masses * least;
  if (rubs && !unlike) return false;
  if (left * time > most_left(setup)) return true;
  if (what == SweepsFor::impacts || (what == SweepsFor::anything && unlike && setup.one_by_one))
    return left > 8 * setup.sweeps.tolerance;
  return what == SweepsFor::bounces &&
         left > (rubs ? fastest / 64 : std::max(8 * setup.sweeps.tolerance, fastest * 0x1p-30));
}

/// Finishes what sweeps have left, where that is better. Where it is not, or is too much, and
/// bodies would come into each other by more than most_left(): friction is only kept in its cones,
/// or, if that is no way out either, nothing rubs this time.
inline void finish_sweeps(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                          std::vector<BodyContact<double>> contacts, double time,
                          SolvedContacts<double>& solved) {
  auto all = finish_contacts<double>(bodies, contacts, solved.impulses);
  if (!all && solved.report.last_change * time > most_left(setup)) {
    all = finish_contacts<double>(bodies, contacts, solved.impulses, FrictionLaw::cones);
    for (BodyContact<double>& contact : contacts) contact.friction = 0;
    if (!all) all = finish_contacts<double>(bodies, contacts, solved.impulses);
  }
  if (all) solved = std::move(*all);
}

/// Solves contacts that are named by the bodies' places, island by island: a sweep over all would
/// go on for those that have long been right. What moves then moves for that `time`. `make(place)`
/// is a body before, `give(place, body)` takes one that moves after. Gives back the impulses.
template <class Make, class Give>
std::vector<ContactImpulse<double>> solve_islands(const SteppedSetup& setup, SteppedState& state,
                                                  const std::vector<BodyContact<double>>& contacts,
                                                  const std::vector<ContactImpulse<double>>& start,
                                                  double time, SweepsFor what, const Make& make,
                                                  const Give& give) {
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
    const auto limits = sweep_limits(setup, bodies.bodies, named, what);
    auto solved = what == SweepsFor::rest
                      ? solve_resting(state, bodies.bodies, named, before, limits)
                      : solve_swept(state, bodies.bodies, named, before, limits);
    if (unfinished(setup, bodies.bodies, named, solved.report.last_change, time, what))
      finish_sweeps(setup, bodies.bodies, named, time, solved);
    // What they have left must not bring anything through the thinnest.
    for (int more = 0; more < 100 && solved.report.last_change * time > setup.thinnest / 16; ++more)
      solved = solve_swept(state, bodies.bodies, named, solved.impulses, limits);
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
    if (turned_by_contacts(setup, place)) state.spin.set(place, body.spin);
  };
  return solve_islands(setup, state, contacts, {}, 0.0, SweepsFor::impacts, make, give);
}

/// Notes a hit: the impulses at all points of a pair together, at their middle.
inline void note_hit(const SteppedSetup& setup, SteppedState& state, StepPart& part,
                     const std::vector<BodyContact<double>>& contacts,
                     const std::vector<ContactImpulse<double>>& impulses, std::size_t first,
                     std::size_t last) {
  SceneHit hit;
  hit.time = static_cast<double>(state.step) * setup.step + (part.whole - part.left);
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

}  // namespace contact
