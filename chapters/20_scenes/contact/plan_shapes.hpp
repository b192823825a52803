/// @file
/// What a plan needs to know of a shape: how thick it is, how far it reaches, how far off a point
/// is. All of it on the safe side.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include <contact/error_free.hpp>
#include <contact/rotation.hpp>
#include <contact/scene.hpp>
#include <contact/tolerance.hpp>

namespace contact {

namespace detail {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double plan_u = tolerance::unit_roundoff<double>;

/// x ≥ 0 made larger than what it stands for, if that took at most n roundings, each off by at most
/// u of a result that is not negative. Twice γ(n) leaves room for this product's own rounding.
inline double rounded_up(double x, double n = 64) { return x * (1 + 2 * n * plan_u); }

/// x ≥ 0 made smaller in the same way.
inline double rounded_down(double x, double n = 64) { return x * (1 - 2 * n * plan_u); }

inline double length_of(const Vector3<double>& v) { return std::sqrt(v.dot(v)); }

/// The size of a place's coordinates: what its rounding is measured with.
inline double coordinate_size(const Vector3<double>& x) { return x.cwiseAbs().sum(); }

/// The sign of a − b − c, exactly.
inline int sign_of_rest(double a, double b, double c) {
  const auto first = two_sum(a, -b);
  // If the first difference is near c this is exact (Sterbenz); if not, its sign is right anyway.
  const double rest = (first.value - c) + first.error;
  return rest > 0 ? 1 : (rest < 0 ? -1 : 0);
}

/// The axis along which a vector points, if all its other coordinates are exactly 0.
inline int only_axis(const Vector3<double>& v) {
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    if (v(k) == 0) continue;
    if (axis >= 0) return -1;
    axis = k;
  }
  return axis;
}

/// The axis along which a half-space's normal points, if it is exactly an axis of the world.
inline int level_axis(const Vector3<double>& normal) {
  const int axis = only_axis(normal);
  return axis >= 0 && std::abs(normal(axis)) == 1 ? axis : -1;
}

/// How far a normal's or a quaternion's rounding can misplace a point, as a share of its distance:
/// a scene's need only be as long as 1 to 1e-12.
inline constexpr double pose_slack = 4e-12;

}  // namespace detail

/// Whether a body is a ball.
inline bool is_ball(const SceneBody& body) { return std::holds_alternative<BallShape>(body.shape); }

/// Whether a body is a half-space.
inline bool is_half_space(const SceneBody& body) {
  return std::holds_alternative<HalfSpaceShape>(body.shape);
}

// [inner-radius]
/// The thickness of a shape's core: the shape contains every point at most this far from some set
/// about its origin (a point for a ball, a segment for a capsule, a rectangle for a box).
/// @return m; ∞ for a half-space; 0 for a hull, of which this proves nothing
inline double inner_radius(const SceneShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->half_lengths.minCoeff();
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) return capsule->radius;
  return std::holds_alternative<HalfSpaceShape>(shape) ? detail::infinite : 0.0;
}
// [/inner-radius]

/// No point of a shape is farther than this from its origin, however it is turned.
/// @return m, rounded up; ∞ for a half-space
inline double outer_radius(const SceneShape& shape) {
  using detail::rounded_up;
  if (const auto* ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return rounded_up(detail::length_of(box->half_lengths));
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return rounded_up(capsule->radius + capsule->half_length);
  if (const auto* hull = std::get_if<HullShape>(&shape)) {
    double farthest = 0;
    for (const Vector3<double>& point : hull->points)
      farthest = std::max(farthest, point.dot(point));
    return rounded_up(std::sqrt(farthest));
  }
  return detail::infinite;
}

/// How far a spin can move a shape's points: 0 for a ball, which looks alike from all sides.
/// @return m, rounded up
inline double spin_arm(const SceneShape& shape) {
  return std::holds_alternative<BallShape>(shape) ? 0.0 : outer_radius(shape);
}

// [distance]
/// At most the distance of a point from a body as it lies when the scene begins; less than 0 only
/// inside a half-space or by rounding.
/// @param p in the world, m
/// @return m, rounded down by 128 u of the coordinates' sizes, and by pose_slack of the distance
/// where a direction is rounded
inline double distance_at_least(const SceneBody& body, const Vector3<double>& p) {
  const Vector3<double> d = p - body.position;
  double size = detail::coordinate_size(p) + detail::coordinate_size(body.position);
  double distance = 0;
  if (const auto* half_space = std::get_if<HalfSpaceShape>(&body.shape)) {
    distance = half_space->normal.dot(p) - half_space->offset;
    if (detail::level_axis(half_space->normal) < 0)
      distance -= detail::pose_slack * std::abs(distance);
    size = detail::coordinate_size(p) + std::abs(half_space->offset);
  } else if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
    const Vector3<double> seen = matrix_of(body.orientation).transpose() * d;
    const Vector3<double> outside =
        (seen.cwiseAbs() - box->half_lengths).cwiseMax(Vector3<double>::Zero());
    distance = detail::length_of(outside);
    size += detail::coordinate_size(box->half_lengths);
    if (!body.orientation.v.isZero(0)) distance -= detail::pose_slack * detail::length_of(d);
  } else if (const auto* capsule = std::get_if<CapsuleShape>(&body.shape)) {
    const Vector3<double> axis = matrix_of(body.orientation).col(2);
    const double along = std::clamp(d.dot(axis), -capsule->half_length, capsule->half_length);
    distance = detail::length_of(d - axis * along) - capsule->radius;
    size += capsule->radius + capsule->half_length;
    if (!body.orientation.v.isZero(0)) distance -= detail::pose_slack * detail::length_of(d);
  } else {
    const double radius = outer_radius(body.shape);
    distance = detail::length_of(d) - radius;
    size += radius;
  }
  return distance - 128 * detail::plan_u * size;
}
// [/distance]

/// The largest and the smallest moment of inertia of a body about any axis through its centre.
struct MomentRange {
  double least = 0;  ///< kg·m², rounded down
  double most = 0;   ///< kg·m², rounded up
};

/// The range of a moving body's moments. Exactly the diagonal's if nothing stands beside it.
inline MomentRange moment_range(const Matrix3<double>& inertia) {
  bool diagonal = true;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) diagonal = diagonal && (i == k || inertia(i, k) == 0);
  }
  if (diagonal) return {inertia.diagonal().minCoeff(), inertia.diagonal().maxCoeff()};
  const Vector3<double> moments = principal_axes<double>(inertia).moments;
  const double doubt = 64 * detail::plan_u * moments.maxCoeff();
  return {std::max(0.0, moments.minCoeff() - doubt), moments.maxCoeff() + doubt};
}

}  // namespace contact
