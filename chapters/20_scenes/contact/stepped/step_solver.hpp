/// @file
/// How the stages pass contacts to the solver of chapter 18: island by island, and only bodies that
/// have contacts.
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

/// A mover as a body of the solver, with the given velocity and angular velocity.
RigidBody<double> solver_body(const SteppedSetup& setup, const SteppedState& state,
                              std::size_t place, const Vector3<double>& velocity,
                              const Vector3<double>& spin);

/// The bodies of some contacts, renumbered: a body without a contact costs nothing.
struct ContactedBodies {
  std::vector<RigidBody<double>> bodies;
  std::vector<std::size_t> places;
  std::vector<int> number;  // by index in the list; −1: not among them

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

/// Contacts that are connected by moving bodies, each island as the contacts' indices. Islands are
/// independent of each other.
std::vector<std::vector<std::size_t>> islands(const SteppedSetup& setup, const SteppedState& state,
                                              const std::vector<BodyContact<double>>& contacts);

inline BodyContact<double> contact_at(const NearPair& pair, const ManifoldPoint<double>& point,
                                      double least_velocity) {
  return {static_cast<int>(pair.a), static_cast<int>(pair.b), point.point,
          pair.manifold.normal,     pair.material.friction,   least_velocity};
}

/// What contacts are solved for. Resting contacts get an exact solve by elimination, and a hundred
/// times the iterations where that does not suffice. Bounces get as many iterations as there is
/// work for, even in a crowd: an impulse with a residual loses energy. Impacts at one instant get
/// an exact solve too: until it is done, no time passes.
enum class SweepsFor { anything, rest, bounces, impacts };

/// Iterations for these contacts. Where no body has two contacts each is independent, and one
/// iteration solves it.
SweepLimits<double> sweep_limits(const SteppedSetup& setup,
                                 const std::vector<RigidBody<double>>& bodies,
                                 const std::vector<BodyContact<double>>& contacts, SweepsFor what);

/// Solves contacts that are named by the solver's numbers of bodies.
SolvedContacts<double> solve_swept(SteppedState& state,
                                   const std::vector<RigidBody<double>>& bodies,
                                   const std::vector<BodyContact<double>>& contacts,
                                   const std::vector<ContactImpulse<double>>& start,
                                   const SweepLimits<double>& limits);

/// Solves resting contacts: a few iterations, then elimination, and one iteration to check the
/// result. If it is not solved, the iterations continue from there.
SolvedContacts<double> solve_resting(SteppedState& state,
                                     const std::vector<RigidBody<double>>& bodies,
                                     const std::vector<BodyContact<double>>& contacts,
                                     const std::vector<ContactImpulse<double>>& start,
                                     const SweepLimits<double>& limits);

/// Whether the residual of the iterations needs an exact solve: no body may penetrate another by
/// much, and no bounce may lose much of its energy.
bool unfinished(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                const std::vector<BodyContact<double>>& contacts, double left, double time,
                SweepsFor what);

/// Removes the residual of the iterations by an exact solve, where that is better. Where it is not,
/// or takes too much work, and bodies would penetrate each other by more than most_left(): friction
/// only stays within its cones, or, if that fails too, is left out this time.
void finish_sweeps(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                   std::vector<BodyContact<double>> contacts, double time,
                   SolvedContacts<double>& solved);

/// Solves contacts that are named by indices in the list of bodies, island by island: iterating
/// over all would go on for islands that have converged. The bodies then move for that `time`.
/// `make(place)` returns a body before, `give(place, body)` takes a moving one after. Returns the
/// impulses.
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
    // The residual must not move anything through the thinnest body.
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

/// The same from the present velocities of the bodies, which are changed.
std::vector<ContactImpulse<double>> solve_now(const SteppedSetup& setup, SteppedState& state,
                                              const std::vector<BodyContact<double>>& contacts);

/// Records a hit: the sum of the impulses at all points of a pair, at their centre.
void note_hit(const SteppedSetup& setup, SteppedState& state, StepPart& part,
              const std::vector<BodyContact<double>>& contacts,
              const std::vector<ContactImpulse<double>>& impulses, std::size_t first,
              std::size_t last);

}  // namespace detail

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/step_solver.cpp"
#endif
