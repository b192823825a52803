/// @file
/// How the stages pass contacts to the solver of chapter 18: island by island, and only bodies that
/// have contacts.
#pragma once

#include <cstddef>
#include <vector>

#include <contact/contact_active_set.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_body.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// A mover as a body of the solver, with the given velocity and angular velocity.
RigidBody<double> solver_body(const SteppedSetup& setup, const SteppedState& state,
                              std::size_t slot, const Vector3<double>& velocity,
                              const Vector3<double>& angular_velocity);

/// The bodies of some contacts, renumbered: a body without a contact costs nothing.
struct ContactedBodies {
  std::vector<RigidBody<double>> bodies;
  std::vector<std::size_t> slots;
  std::vector<int> number;  // by index in the list; −1: not among them

  explicit ContactedBodies(std::size_t count) : number(count, -1) {}

  template <class Make>
  int add(std::size_t slot, const Make& make) {
    if (number[slot] < 0) {
      number[slot] = static_cast<int>(bodies.size());
      bodies.push_back(make(slot));
      slots.push_back(slot);
    }
    return number[slot];
  }

  void clear() {
    for (const std::size_t slot : slots) number[slot] = -1;
    bodies.clear();
    slots.clear();
  }
};

/// Contacts that are connected by moving bodies, each island as the contacts' indices. Islands are
/// independent of each other.
std::vector<std::vector<std::size_t>> islands(const SteppedSetup& setup, const SteppedState& state,
                                              const std::vector<BodyContact<double>>& contacts);

inline BodyContact<double> contact_at(const NearPair& pair, const ManifoldPoint<double>& point,
                                      double min_velocity) {
  return {static_cast<int>(pair.a), static_cast<int>(pair.b), point.point,
          pair.manifold.normal,     pair.material.friction,   min_velocity};
}

/// What contacts are solved for. Resting contacts get an exact solve by elimination, and a hundred
/// times the iterations where that does not suffice. Bounces get as many iterations as there is
/// work for, even in a crowd: an impulse with a residual loses energy. Impacts at one instant get
/// an exact solve too: until it is done, no time passes.
enum class SolveFor { anything, rest, bounces, impacts };

/// Iterations for these contacts. Where no body has two contacts each is independent, and one
/// iteration solves it.
SolverSettings<double> solver_settings(const SteppedSetup& setup,
                                       const std::vector<RigidBody<double>>& bodies,
                                       const std::vector<BodyContact<double>>& contacts,
                                       SolveFor what);

/// Solves contacts that are named by the solver's numbers of bodies.
SolvedContacts<double> solve_iteratively(SteppedState& state,
                                         const std::vector<RigidBody<double>>& bodies,
                                         const std::vector<BodyContact<double>>& contacts,
                                         const std::vector<ContactImpulse<double>>& start,
                                         const SolverSettings<double>& limits);

/// Solves resting contacts: a few iterations, then elimination, and one iteration to check the
/// result. If it is not solved, the iterations continue from there.
SolvedContacts<double> solve_resting(SteppedState& state,
                                     const std::vector<RigidBody<double>>& bodies,
                                     const std::vector<BodyContact<double>>& contacts,
                                     const std::vector<ContactImpulse<double>>& start,
                                     const SolverSettings<double>& limits);

/// The largest number of contacts that settle() solves exactly.
inline constexpr std::size_t max_settled_contacts = 64;

/// Replaces the result of iterations that have not settled by an exact solve, where that is closer
/// to the solution. An island of more contacts keeps what the iterations have reached.
void settle(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
            const std::vector<BodyContact<double>>& contacts, SolvedContacts<double>& solved);

/// Whether the residual of the iterations needs an exact solve: no body may penetrate another by
/// much, and no bounce may lose much of its energy.
bool unfinished(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                const std::vector<BodyContact<double>>& contacts, double left, double time,
                SolveFor what);

/// Removes the residual of the iterations by an exact solve, where that is better. Where it is not,
/// or takes too much work, and bodies would penetrate each other by more than max_residual():
/// friction only stays within its cones, or, if that fails too, is left out this time.
void solve_residual(const SteppedSetup& setup, const std::vector<RigidBody<double>>& bodies,
                    std::vector<BodyContact<double>> contacts, double time,
                    SolvedContacts<double>& solved);

/// Solves contacts that are named by indices in the list of bodies, island by island: iterating
/// over all would go on for islands that have converged. The bodies then move for that `time`.
/// `make(slot)` returns a body before, `give(slot, body)` takes a moving one after. Returns the
/// impulses.
template <class Make, class Give>
std::vector<ContactImpulse<double>> solve_islands(const SteppedSetup& setup, SteppedState& state,
                                                  const std::vector<BodyContact<double>>& contacts,
                                                  const std::vector<ContactImpulse<double>>& start,
                                                  double time, SolveFor what, const Make& make,
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
    const auto limits = solver_settings(setup, bodies.bodies, named, what);
    auto solved = what == SolveFor::rest
                      ? solve_resting(state, bodies.bodies, named, before, limits)
                      : solve_iteratively(state, bodies.bodies, named, before, limits);
    settle(setup, bodies.bodies, named, solved);
    if (unfinished(setup, bodies.bodies, named, solved.report.last_change, time, what))
      solve_residual(setup, bodies.bodies, named, time, solved);
    // The residual must not move anything through the thinnest body.
    for (int more = 0; more < 100 && solved.report.last_change * time > setup.thinnest / 16; ++more)
      solved = solve_iteratively(state, bodies.bodies, named, solved.impulses, limits);
    if (!(solved.report.residual * setup.step <= min_error(setup)))
      state.counts.doubts.add(RunDoubt::unsettled, static_cast<double>(state.step) * setup.step);
    for (std::size_t k = 0; k < island.size(); ++k) impulses[island[k]] = solved.impulses[k];
    for (std::size_t k = 0; k < bodies.slots.size(); ++k) {
      const std::size_t slot = bodies.slots[k];
      if (slot < setup.movers && !sleeps(state, slot)) give(slot, solved.bodies[k]);
    }
  }
  return impulses;
}

/// The same from the present velocities of the bodies, which are changed.
std::vector<ContactImpulse<double>> solve_now(const SteppedSetup& setup, SteppedState& state,
                                              const std::vector<BodyContact<double>>& contacts);

/// Records a hit: the sum of the impulses at all points of a pair, at their centre.
void record_hit(const SteppedSetup& setup, SteppedState& state, Substep& substep,
                const std::vector<BodyContact<double>>& contacts,
                const std::vector<ContactImpulse<double>>& impulses, std::size_t first,
                std::size_t last);

}  // namespace detail

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/step_solver.cpp"
#endif
