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
#include <contact/plan/plan_bounds.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/stepped/substep_motion.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

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
