#include <contact/stepped/stepped_state.hpp>

#include <cstddef>
#include <limits>
#include <variant>

#include <contact/capsule.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE StepShape step_shape(const SceneShape& shape) {
  const Vector3<double> zero = Vector3<double>::Zero();
  if (const auto* ball = std::get_if<BallShape>(&shape)) return Sphere<double>{zero, ball->radius};
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return OrientedBox<double>{zero, Matrix3<double>::Identity(), box->half_lengths};
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return capsule_along_z<double>({}, capsule->half_length, capsule->radius);
  if (const auto* hull = std::get_if<HullShape>(&shape)) return HullVertices{hull->points};
  const auto& half_space = std::get<HalfSpaceShape>(shape);
  return HalfSpace<double>{{half_space.normal, half_space.offset}};
}

CONTACT_SCENES_INLINE SteppedBody stepped_body(const SceneBody& from, std::size_t index) {
  SteppedBody body;
  body.body = index;
  body.shape = step_shape(from.shape);
  body.material = from.material;
  body.bounding_radius = outer_radius(from.shape);
  body.rotation_radius = rotation_radius(from.shape);
  const double inner = inner_radius(from.shape);
  body.core = inner > 0 ? inner : std::numeric_limits<double>::infinity();
  if (!from.moves) return body;
  body.mass = from.mass;
  const bool diagonal = from.inertia.isDiagonal(0);
  if (diagonal) {
    body.moments = from.inertia.diagonal();
  } else {
    const auto principal = principal_axes<double>(from.inertia);
    body.moments = principal.moments;
    body.axes = principal.rotation;
  }
  body.round = body.moments.x() == body.moments.y() && body.moments.y() == body.moments.z();
  return body;
}

}  // namespace detail

}  // namespace contact
