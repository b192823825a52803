/// @file
/// A stage: continuous detection. The part ends at the first moment at which two bodies meet.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <contact/ballistic.hpp>
#include <contact/rotation.hpp>
#include <contact/stage_contacts.hpp>
#include <contact/stage_rotation.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

/// How a body moves through a part: evenly accelerated, and turning evenly.
struct PartMotion {
  Vector3<double> position = Vector3<double>::Zero();
  Vector3<double> velocity = Vector3<double>::Zero();
  Vector3<double> acceleration = Vector3<double>::Zero();
  Rotor<double> orientation;
  Vector3<double> spin = Vector3<double>::Zero();  // 0 for a ball: it looks alike from all sides
  double swing = 0;  // how fast turning changes the velocity of a point of it at most, m/s²

  Vector3<double> position_at(double t) const {
    return position + (velocity + acceleration * (t / 2)) * t;
  }
};

inline PartMotion part_motion(const SteppedSetup& setup, const SteppedState& state,
                              const StepPart& part, std::size_t place) {
  PartMotion motion;
  motion.position = position_of(setup, state, place);
  motion.orientation = orientation_of(setup, state, place);
  if (place >= setup.movers || sleeps(state, place)) return motion;
  motion.velocity = state.velocity[place];
  if (part.at_start[place])
    motion.velocity = part.end_velocity[place];
  else
    motion.acceleration = (part.end_velocity[place] - state.velocity[place]) / part.planned;
  if (!setup.rotation || setup.bodies[place].spin_arm == 0) return motion;
  motion.spin = mean_spin(state, part, place, part.length);
  motion.swing = motion.spin.dot(motion.spin) * setup.bodies[place].spin_arm;
  return motion;
}

inline StepShape shape_at(const SteppedBody& body, const PartMotion& motion, double t) {
  const bool turns = motion.swing > 0;
  return shape_in_world(body, motion.position_at(t),
                        turns ? normalised(exponential_step(motion.orientation, motion.spin, t))
                              : motion.orientation);
}

/// A shape as the points of which it is the hull, with a ball about each.
struct ShapeCorners {
  std::vector<Vector3<double>> points;
  double radius = 0;
};

inline ShapeCorners corners_of(const Sphere<double>& shape) {
  return {{shape.centre}, shape.radius};
}
inline ShapeCorners corners_of(const Capsule<double>& shape) {
  return {{shape.core.start, shape.core.end}, shape.radius};
}
inline ShapeCorners corners_of(const OrientedBox<double>& shape) {
  ShapeCorners corners;
  for (int k = 0; k < 8; ++k) corners.points.push_back(box_corner(shape, k));
  return corners;
}
inline ShapeCorners corners_of(const HullCorners& shape) { return {shape.points, 0}; }
inline ShapeCorners corners_of(const HalfSpace<double>& shape) {
  return {{Vector3<double>(shape.boundary.normal * shape.boundary.offset)}, 0};
}

/// How far the corners of a shape are along a direction, and how fast each moves along it.
struct CornerRates {
  std::vector<double> height;
  std::vector<double> rate;
};

inline CornerRates corner_rates(const StepShape& shape, const PartMotion& motion, double t,
                                const Vector3<double>& n, double sign) {
  const ShapeCorners corners = std::visit([](const auto& one) { return corners_of(one); }, shape);
  const Vector3<double> centre = motion.position_at(t);
  const double rate = n.dot(Vector3<double>(motion.velocity + motion.acceleration * t));
  CornerRates result;
  for (const Vector3<double>& point : corners.points) {
    const Vector3<double> arm = point - centre;
    result.height.push_back(n.dot(point) - sign * corners.radius);
    result.rate.push_back(motion.swing > 0 ? rate + n.dot(Vector3<double>(motion.spin.cross(arm)))
                                           : rate);
  }
  return result;
}

}  // namespace detail

// [time-of-impact]
/// When a pair first touches in a part; nothing if not before the given time.
///
/// Seen along the normal between their nearest points, each corner of the one is above each corner
/// of the other. How fast such a height changes is known, and turning changes that rate by no more
/// than ω² r. Until the first of these heights is used up the bodies cannot touch: advance there,
/// and look again. A ball and a plane take one look, what turns or comes at a slant takes a few.
/// @param before s
/// @return s; never later than the touch, and earlier only after 64 looks
inline std::optional<double> pair_impact(const SteppedSetup& setup, const SteppedState& state,
                                         const StepPart& part, const NearPair& pair,
                                         double before) {
  const detail::PartMotion a = detail::part_motion(setup, state, part, pair.a);
  const detail::PartMotion b = detail::part_motion(setup, state, part, pair.b);
  double t = 0;
  for (int look = 0; look < 64; ++look) {
    const StepShape one = detail::shape_at(setup.bodies[pair.a], a, t);
    const StepShape other = detail::shape_at(setup.bodies[pair.b], b, t);
    const Gap<double> gap = gap_of_shapes(one, other);
    const bool leaves = look == 0 && pair.leaving;
    if (!leaves && gap.distance <= pair.touch) return t;
    const Vector3<double>& n = gap.normal;
    const detail::CornerRates above = detail::corner_rates(one, a, t, n, 1);
    const detail::CornerRates below = detail::corner_rates(other, b, t, n, -1);
    const double bend = n.dot(Vector3<double>(a.acceleration - b.acceleration)) - a.swing - b.swing;
    double closes = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < above.height.size(); ++i) {
      for (std::size_t k = 0; k < below.height.size(); ++k) {
        const auto time = closing_time<double>(std::max(above.height[i] - below.height[k], 0.0),
                                               above.rate[i] - below.rate[k], bend);
        if (time) closes = std::min(closes, *time);
      }
    }
    if (!(t + closes < before)) return std::nullopt;
    if (leaves && !(closes > 0)) return std::nullopt;
    t += closes;
  }
  return t;
}
// [/time-of-impact]

// [continuous-stage]
/// Ends the part where the first of the pairs that are apart comes to touch. What touches already
/// is kept apart by its contacts.
inline void find_first_impact(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  if (part.at_once) return;
  bool cut = false;
  for (const NearPair& pair : part.pairs) {
    if (pair.touching && (!pair.leaving || pair.material.stiffness)) continue;
    const auto time = pair_impact(setup, state, part, pair, part.length);
    if (!time) continue;
    part.length = *time;
    cut = true;
  }
  if (cut) ++part.cuts;
}
// [/continuous-stage]

}  // namespace contact
