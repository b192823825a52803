#include <contact/stepped/stage_time_of_impact.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <contact/ballistic.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stage_motion.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The motion of a body in a substep: constant acceleration, and the rotation of its stage.
struct SubstepMotion {
  Vector3<double> position = Vector3<double>::Zero();
  Vector3<double> velocity = Vector3<double>::Zero();
  Vector3<double> acceleration = Vector3<double>::Zero();
  bool turns = false;     // false for a ball: it looks the same in every orientation
  double swing = 0;       // largest acceleration of a point of it by rotation, m/s²
  double unforeseen = 0;  // and by deviation from angular_velocity_at(), m/s²

  Vector3<double> position_at(double t) const {
    return position + (velocity + acceleration * (t / 2)) * t;
  }
};

/// Orientation of a mover after a time of the substep, bit for bit as its stage rotates it.
CONTACT_SCENES_INLINE Quaternion<double> orientation_at(const SteppedSetup& setup,
                                                        const SteppedState& state,
                                                        const Substep& substep, std::size_t slot,
                                                        double t) {
  return setup.gyroscopic ? rotated_freely(setup, state, substep, slot, t)
                          : rotated_uniformly(state, substep, slot, t);
}

CONTACT_SCENES_INLINE Vector3<double> angular_velocity_at(const SteppedSetup& setup,
                                                          const SteppedState& state,
                                                          const Substep& substep, std::size_t slot,
                                                          double t,
                                                          const Quaternion<double>& orientation) {
  const Vector3<double> mean = mean_angular_velocity(state, substep, slot, t);
  if (!setup.gyroscopic || setup.bodies[slot].round)
    return contact_angular_velocity(state, substep, slot, t);
  const SteppedBody& body = setup.bodies[slot];
  const Vector3<double> momentum = angular_momentum_of(body, state.orientation[slot], mean);
  const Vector3<double> pushed = contact_angular_velocity(state, substep, slot, t) - mean;
  return pushed + free_angular_velocity<double>(
                      momentum, body.moments, Matrix3<double>(matrix_of(orientation) * body.axes));
}

/// Bounds the acceleration by rotation of a point at the distance r from the centre. A constant
/// angular velocity gives ω² r; a torque adds dω/dt r. Without torque the angular velocity may
/// still change: by Euler's equations no faster than ω²/√3 times the largest |I₂ − I₃|/I₁, and by
/// its energy ω² grows by at most the ratio of its moments, and by less without torque.
CONTACT_SCENES_INLINE void bound_swing(const SteppedSetup& setup, const SteppedState& state,
                                       const Substep& substep, std::size_t slot,
                                       SubstepMotion& motion) {
  const SteppedBody& body = setup.bodies[slot];
  const Vector3<double> first = mean_angular_velocity(state, substep, slot, 0);
  const Vector3<double>& last = substep.end_angular_velocity[slot];
  double square = std::max(first.dot(first), last.dot(last));
  double push = size_of(last - first) / substep.planned;
  double own = 0;
  if (setup.gyroscopic && !body.round) {
    const Vector3<double>& m = body.moments;
    const double ratio = m.maxCoeff() / m.minCoeff();
    square = first == last ? largest_free_square(body, orientation_of(setup, state, slot), first)
                           : square * ratio;
    push *= ratio;
    const Vector3<double> apart(m.y() - m.z(), m.z() - m.x(), m.x() - m.y());
    own = square * apart.cwiseAbs().cwiseQuotient(m).maxCoeff() / std::sqrt(3.0);
  }
  motion.turns = square > 0;
  motion.unforeseen = push * std::sqrt(square) * substep.planned * body.rotation_radius;
  motion.swing = (square + own + push) * body.rotation_radius + motion.unforeseen;
}

CONTACT_SCENES_INLINE SubstepMotion substep_motion(const SteppedSetup& setup,
                                                   const SteppedState& state,
                                                   const Substep& substep, std::size_t slot) {
  SubstepMotion motion;
  motion.position = position_of(setup, state, slot);
  if (slot >= setup.movers || sleeps(state, slot)) return motion;
  motion.velocity = first_velocity(state, substep, slot);
  motion.acceleration = (substep.end_velocity[slot] - motion.velocity) / substep.planned;
  if (setup.rotation && setup.bodies[slot].rotation_radius > 0)
    bound_swing(setup, state, substep, slot, motion);
  return motion;
}

/// A shape as the points whose hull it is, with a ball around each.
struct ShapeCorners {
  std::vector<Vector3<double>> points;
  double radius = 0;
};

CONTACT_SCENES_INLINE ShapeCorners corners_of(const Sphere<double>& shape) {
  return {{shape.centre}, shape.radius};
}

CONTACT_SCENES_INLINE ShapeCorners corners_of(const Capsule<double>& shape) {
  return {{shape.core.start, shape.core.end}, shape.radius};
}

CONTACT_SCENES_INLINE ShapeCorners corners_of(const OrientedBox<double>& shape) {
  ShapeCorners corners;
  for (int k = 0; k < 8; ++k) corners.points.push_back(box_corner(shape, k));
  return corners;
}

CONTACT_SCENES_INLINE ShapeCorners corners_of(const HullVertices& shape) {
  return {shape.points, 0};
}

CONTACT_SCENES_INLINE ShapeCorners corners_of(const HalfSpace<double>& shape) {
  return {{Vector3<double>(shape.boundary.normal * shape.boundary.offset)}, 0};
}

/// The coordinates of a shape's vertices along a direction, and their rates.
struct CornerRates {
  std::vector<double> height;
  std::vector<double> rate;
};

/// A body of a pair at a time of the substep.
struct MovedBody {
  StepShape shape;
  Vector3<double> centre = Vector3<double>::Zero();
  Vector3<double> velocity = Vector3<double>::Zero();
  Vector3<double> angular_velocity = Vector3<double>::Zero();
  double unforeseen = 0;  // additional speed that one of its points may have, m/s
};

CONTACT_SCENES_INLINE MovedBody moved_body(const SteppedSetup& setup, const SteppedState& state,
                                           const Substep& substep, std::size_t slot,
                                           const SubstepMotion& motion, double t) {
  MovedBody body;
  body.centre = motion.position_at(t);
  body.velocity = motion.velocity + motion.acceleration * t;
  body.unforeseen = motion.unforeseen * t;
  Quaternion<double> orientation = orientation_of(setup, state, slot);
  if (motion.turns) {
    orientation = orientation_at(setup, state, substep, slot, t);
    body.angular_velocity = angular_velocity_at(setup, state, substep, slot, t, orientation);
  }
  body.shape = shape_in_world(setup.bodies[slot], body.centre, orientation);
  return body;
}

/// @param n unit
/// @param sign 1: lower bounds along n; −1: upper bounds
CONTACT_SCENES_INLINE CornerRates corner_rates(const MovedBody& body, const Vector3<double>& n,
                                               double sign) {
  const ShapeCorners corners =
      std::visit([](const auto& one) { return corners_of(one); }, body.shape);
  const double rate = n.dot(body.velocity) - sign * body.unforeseen;
  const bool turns = body.angular_velocity != Vector3<double>::Zero();
  CornerRates result;
  for (const Vector3<double>& point : corners.points) {
    const Vector3<double> lever_arm = point - body.centre;
    result.height.push_back(n.dot(point) - sign * corners.radius);
    result.rate.push_back(
        turns ? rate + n.dot(Vector3<double>(body.angular_velocity.cross(lever_arm))) : rate);
  }
  return result;
}

}  // namespace detail

// [time-of-impact]
CONTACT_SCENES_INLINE std::optional<double> pair_impact(const SteppedSetup& setup,
                                                        const SteppedState& state,
                                                        const Substep& substep,
                                                        const NearPair& pair, double before) {
  const detail::SubstepMotion a = detail::substep_motion(setup, state, substep, pair.a);
  const detail::SubstepMotion b = detail::substep_motion(setup, state, substep, pair.b);
  double t = 0;
  for (int look = 0; look < 64; ++look) {
    const auto one = detail::moved_body(setup, state, substep, pair.a, a, t);
    const auto other = detail::moved_body(setup, state, substep, pair.b, b, t);
    const SignedDistance<double> gap = signed_distance_of_shapes(one.shape, other.shape);
    const bool leaves = look == 0 && pair.leaving;
    if (!leaves && gap.distance <= pair.touch) return t;
    const Vector3<double>& n = gap.normal;
    const auto above = detail::corner_rates(one, n, 1);
    const auto below = detail::corner_rates(other, n, -1);
    const double bend = n.dot(Vector3<double>(a.acceleration - b.acceleration)) - a.swing - b.swing;
    const auto used_up = [&](double least) {  // when a height of at least this is zero
      double first = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < above.height.size(); ++i) {
        for (std::size_t k = 0; k < below.height.size(); ++k) {
          const auto time = closing_time<double>(std::max(above.height[i] - below.height[k], least),
                                                 above.rate[i] - below.rate[k], bend);
          if (time) first = std::min(first, *time);
        }
      }
      return first;
    };
    const double closes = used_up(0);
    if (leaves && !(closes > 0)) {
      const double deep = std::min(setup.bodies[pair.a].core, setup.bodies[pair.b].core) / 16;
      const double soon = used_up(deep);
      return soon < before ? std::optional(soon) : std::nullopt;
    }
    if (!(t + closes < before)) return std::nullopt;
    t += closes;
  }
  return t;
}
// [/time-of-impact]

// [continuous-stage]
CONTACT_SCENES_INLINE void find_first_impact(const SteppedSetup& setup, SteppedState& state,
                                             Substep& substep) {
  if (substep.simultaneous) return;
  bool cut = false;
  for (const NearPair& pair : substep.pairs) {
    if (pair.touching && (!pair.leaving || pair.material.stiffness)) continue;
    const auto time = pair_impact(setup, state, substep, pair, substep.length);
    if (!time) continue;
    substep.length = *time;
    cut = true;
  }
  if (cut) ++substep.cuts;
}
// [/continuous-stage]

}  // namespace contact
