#include <contact/plan/plan_bounds.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE int only_axis(const Vector3<double>& v) {
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    if (v(k) == 0) continue;
    if (axis >= 0) return -1;
    axis = k;
  }
  return axis;
}

/// How far rounding of a normal or a quaternion can misplace a point, relative to its distance: in
/// a scene their length need only be 1 to 1e-12.
inline constexpr double pose_slack = 4e-12;

}  // namespace detail

CONTACT_SCENES_INLINE double outer_radius(const SceneShape& shape) {
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

// [distance]
CONTACT_SCENES_INLINE double distance_at_least(const SceneBody& body, const Vector3<double>& p) {
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

CONTACT_SCENES_INLINE MomentRange moment_range(const Matrix3<double>& inertia) {
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
