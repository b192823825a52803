#include <contact/stepped/stage_motion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE double largest_free_square(const Vector3<double>& moments,
                                                 const Vector3<double>& angular_velocity) {
  const Vector3<double> square = angular_velocity.cwiseProduct(angular_velocity);
  Vector3<double> sorted = moments;
  std::sort(sorted.data(), sorted.data() + 3);
  const double energy = moments.dot(square);  // twice
  const double by_energy = energy / sorted(0);
  const double apart = sorted(2) - sorted(0);
  if (!(apart > 0)) return by_energy;
  const Vector3<double> less = Vector3<double>::Constant(sorted(2)) - moments;
  const double left = moments.cwiseProduct(less).dot(square);
  return std::min(by_energy, left / (sorted(0) * apart) + energy / sorted(1));
}

// [moving-stage]
/// Every mover moves on to the end of the substep, with constant acceleration: exact for a flight,
/// and for a sliding block. A substep that an impact cuts short ends with the velocity at that
/// instant.
CONTACT_SCENES_INLINE void move_bodies(const SteppedSetup& setup, SteppedState& state,
                                       Substep& substep) {
  const double share = substep.length / substep.planned;
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    const Vector3<double> first = first_velocity(state, substep, i);
    const Vector3<double> end = substep.end_velocity[i];
    const Vector3<double> change = end - first;
    state.position.add(i, Vector3<double>(first + change * (share / 2)) * substep.length);
    state.velocity.set(i, share < 1 ? Vector3<double>(first + change * share) : end);
  }
}
// [/moving-stage]

// [turning-stage]
CONTACT_SCENES_INLINE void rotate_bodies(const SteppedSetup& setup, SteppedState& state,
                                         Substep& substep) {
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    state.orientation[i] = detail::rotated_uniformly(state, substep, i, substep.length);
    state.angular_velocity.set(i,
                               detail::contact_angular_velocity(state, substep, i, substep.length));
  }
}
// [/turning-stage]

// [gyroscopic-stage]
namespace detail {

/// The orientation of a torque-free body after a time, by four exponentials of intermediate angular
/// velocities: of order 4, and its angular momentum is conserved.
///
/// Source: Celledoni, Marthinsen and Owren, *Commutator-free Lie group methods*, Future Generation
/// Computer Systems 19 (2003).
CONTACT_SCENES_INLINE Quaternion<double> free_turn(const Quaternion<double>& q,
                                                   const Vector3<double>& momentum,
                                                   const SteppedBody& body, double h) {
  const auto angular_velocity_at = [&](const Quaternion<double>& r) {
    return free_angular_velocity<double>(momentum, body.moments,
                                         Matrix3<double>(matrix_of(r) * body.axes));
  };
  const Vector3<double> k1 = angular_velocity_at(q);
  const Quaternion<double> half = exponential<double>(k1 * (h / 2)) * q;
  const Vector3<double> k2 = angular_velocity_at(half);
  const Vector3<double> k3 = angular_velocity_at(exponential<double>(k2 * (h / 2)) * q);
  const Vector3<double> k4 = angular_velocity_at(exponential<double>(k3 * h - k1 * (h / 2)) * half);
  const Vector3<double> both = (k2 + k3) * 2;
  const Vector3<double> first = (k1 * 3 + both - k4) * (h / 12);
  const Vector3<double> second = (k4 * 3 + both - k1) * (h / 12);
  return normalised(exponential<double>(second) * (exponential<double>(first) * q));
}

CONTACT_SCENES_INLINE Quaternion<double> rotated_freely(const SteppedSetup& setup,
                                                        const SteppedState& state,
                                                        const Substep& substep, std::size_t i,
                                                        double length) {
  const SteppedBody& body = setup.bodies[i];
  Quaternion<double> q = state.orientation[i];
  const Vector3<double> mean = mean_angular_velocity(state, substep, i, length);
  if (body.round || mean == Vector3<double>::Zero())
    return normalised(exponential_step(q, mean, length));
  const Vector3<double> momentum = angular_momentum_of(body, q, mean);
  // For a needle, a small change of orientation changes the angular velocity by much: in proportion
  // to the ratio of its moments, and the error of the fourth order grows with that.
  const double ratio = body.moments.maxCoeff() / body.moments.minCoeff();
  const double fastest = std::sqrt(largest_free_square(body, q, mean) * ratio);
  const double looks = std::ceil(fastest * length / gyroscopic_angle);
  const auto count = static_cast<std::uint64_t>(std::min(std::max(looks, 1.0), 4096.0));
  const double h = length / static_cast<double>(count);
  for (std::uint64_t k = 0; k < count; ++k) q = free_turn(q, momentum, body, h);
  return q;
}

}  // namespace detail

CONTACT_SCENES_INLINE void rotate_with_gyroscopic_term(const SteppedSetup& setup,
                                                       SteppedState& state, Substep& substep) {
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    const SteppedBody& body = setup.bodies[i];
    Vector3<double> angular_velocity =
        detail::contact_angular_velocity(state, substep, i, substep.length);
    const Quaternion<double> turned =
        detail::rotated_freely(setup, state, substep, i, substep.length);
    if (!body.round && angular_velocity != Vector3<double>::Zero()) {
      const Vector3<double> momentum =
          detail::angular_momentum_of(body, state.orientation[i], angular_velocity);
      const Matrix3<double> principal = matrix_of(turned) * body.axes;
      angular_velocity = free_angular_velocity<double>(momentum, body.moments, principal);
    }
    state.orientation[i] = turned;
    state.angular_velocity.set(i, angular_velocity);
  }
}
// [/gyroscopic-stage]

// [pushing-out-stage]
CONTACT_SCENES_INLINE void correct_positions(const SteppedSetup& setup, SteppedState& state,
                                             Substep& substep) {
  std::vector<Vector3<double>> moved;  // of each mover, so far
  const auto lightness = [&](std::size_t slot) {
    return slot < setup.movers && !sleeps(state, slot) ? 1 / setup.bodies[slot].mass : 0.0;
  };
  for (int round = 0; round < position_iterations; ++round) {
    for (const NearPair& pair : substep.pairs) {
      const double slack = 0x1p10 * pair.touch;
      if (pair.material.stiffness || !pair.touching || pair.distance >= -slack) continue;
      if (moved.empty()) moved.assign(setup.movers, Vector3<double>::Zero());
      const double a = lightness(pair.a);
      const double b = lightness(pair.b);
      const Vector3<double>& n = pair.manifold.normal;
      double depth = -pair.distance - slack - n.dot(moved[pair.a]);
      if (pair.b < setup.movers) depth += n.dot(moved[pair.b]);
      if (!(depth > 0) || !(a + b > 0)) continue;
      const Vector3<double> way = n * (depth / 2 / (a + b));
      if (a > 0) moved[pair.a] += way * a;
      if (b > 0) moved[pair.b] -= way * b;
    }
    if (moved.empty()) return;
  }
  for (std::size_t i = 0; i < setup.movers; ++i) {
    state.position.add(i, moved[i]);
    // The energy of being lifted comes from the motion, and that of being lowered goes into it.
    const Vector3<double> v = state.velocity[i];
    const double square = v.dot(v);
    const double work = 2 * setup.scene.gravity.dot(moved[i]);
    if (work == 0 || !(square > std::abs(work))) continue;
    state.velocity.set(i, v * std::sqrt(1 + work / square));
  }
}
// [/pushing-out-stage]

}  // namespace contact
