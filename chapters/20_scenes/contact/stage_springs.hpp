/// @file
/// A stage: contacts that give way. Springs and dampers push while two surfaces overlap.
#pragma once

#include <algorithm>
#include <cstddef>

#include <contact/rigid_impulse.hpp>
#include <contact/spring_damper.hpp>
#include <contact/stage_contacts.hpp>
#include <contact/step_solver.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

/// Gives an impulse at a point to the velocities that two bodies have at the end of the part.
inline void push_apart(const SteppedSetup& setup, const SteppedState& state, StepPart& part,
                       const NearPair& pair, const RigidBody<double>& a, const RigidBody<double>& b,
                       const Vector3<double>& point, const Vector3<double>& impulse) {
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
/// Springs and dampers of the pairs that overlap, at the middle of the part: leapfrog. A spring
/// alone keeps its energy but for the square of the part's share of its period, and a part is
/// at most 1/128 of a radian of the stiffest spring long.
///
/// The damper sees the velocity at the end of the part, so that no damper is too strong for a part
/// (16's implicit damper). A pair's spring is shared by the points at which it touches. Friction
/// stops what slides within the part, if Coulomb's bound lets it.
inline void push_springs(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
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
