/// @file
/// How the stages hand contacts to 18's solver: island by island, and only bodies that have
/// contacts.
#pragma once

#include <cstddef>
#include <vector>

#include <contact/contact_finish.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rotation.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// A mover as the solver wants it, with the given velocity and spin.
RigidBody<double> solver_body(const SteppedSetup& setup, const SteppedState& state,
                              std::size_t place, const Vector3<double>& velocity,
                              const Vector3<double>& spin);

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
std::vector<std::vector<std::size_t>> islands(const SteppedSetup& setup, const SteppedState& state,
                                              const std::vector<BodyContact<double>>& contacts);

inline BodyContact<double> contact_at(const NearPair& pair, const ManifoldPoint<double>& point,
                                      double least_velocity) {
  return {static_cast<int>(pair.a), static_cast<int>(pair.b), point.point,
          pair.manifold.normal,     pair.material.friction,   least_velocity};
}

/// What contacts are solved for. What rests is finished by elimination, and gets a hundred times
/// the sweeps where that does not end it. Bounces get as many as there is work for, even in a
/// crowd: an impulse that is not finished loses energy. Impacts at one moment are finished too:
/// until they are, no time passes.
enum class SweepsFor { anything, rest, bounces, impacts };

/// How sweeps of these contacts go. Where no body has two contacts each is on its own, and a sweep
/// goes all the way to its answer.
SweepLimits<double> sweep_limits(const SteppedSetup& setup,
                                 const std::vector<RigidBody<double>>& bodies,
                                 const std::vector<BodyContact<double>>& contacts, SweepsFor what);

/// Solves contacts that are named by the bodies' numbers.
SolvedContacts<double> solve_swept(SteppedState& state,
                                   const std::vector<RigidBody<double>>& bodies,
                                   const std::vector<BodyContact<double>>& contacts,
                                   const std::vector<ContactImpulse<double>>& start,
                                   const SweepLimits<double>& limits);

/// Solves what rests: a few sweeps, then elimination, and one sweep looks whether that was the end.
/// If not, sweeps go on from there.
SolvedContacts<double> solve_resting(SteppedState& state,
                                     const std::vector<RigidBody<double>>& bodies,
                                     const std::vector<BodyContact<double>>& contacts,
                                     const std::vector<ContactImpulse<double>>& start,
                                     const SweepLimits<double>& limits);

/// Whether what the sweeps have left is to be finished: nothing may come far into somebody else,
/// and no bounce may lose much of its energy.
bool unfinished(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                const std::vector<BodyContact<double>>& contacts, double left, double time,
                SweepsFor what);

/// Finishes what sweeps have left, where that is better. Where it is not, or is too much, and
/// bodies would come into each other by more than most_left(): friction is only kept in its cones,
/// or, if that is no way out either, nothing rubs this time.
void finish_sweeps(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                   std::vector<BodyContact<double>> contacts, double time,
                   SolvedContacts<double>& solved);

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
std::vector<ContactImpulse<double>> solve_now(const SteppedSetup& setup, SteppedState& state,
                                              const std::vector<BodyContact<double>>& contacts);

/// Notes a hit: the impulses at all points of a pair together, at their middle.
void note_hit(const SteppedSetup& setup, SteppedState& state, StepPart& part,
              const std::vector<BodyContact<double>>& contacts,
              const std::vector<ContactImpulse<double>>& impulses, std::size_t first,
              std::size_t last);

}  // namespace detail

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/step_solver.cpp"
#endif
