#include <contact/scene/scene_solids.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <contact/capsule.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_hull.hpp>
#include <contact/inertia.hpp>
#include <contact/pose.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

CONTACT_SCENES_INLINE std::optional<MassProperties<double>> hull_matter(
    const std::vector<Vector3<double>>& points) {
  const Hull hull = convex_hull(points);
  if (hull.dimension < 3) return std::nullopt;
  std::vector<VertexIndices> faces;
  for (const auto& [a, b, c] : triangles(hull)) {
    faces.push_back(
        {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  }
  return mesh_mass<double>(1.0, points, faces);
}

}  // namespace detail

// [solid]
CONTACT_SCENES_INLINE double solid_volume(const SceneShape& shape) {
  constexpr double pi = 3.141592653589793;
  if (const auto* ball = std::get_if<BallShape>(&shape))
    return 4 * pi * ball->radius * ball->radius * ball->radius / 3;
  if (const auto* box = std::get_if<BoxShape>(&shape))
    return 8 * box->half_lengths.x() * box->half_lengths.y() * box->half_lengths.z();
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape)) {
    const double disc = pi * capsule->radius * capsule->radius;
    return disc * (2 * capsule->half_length) + 4 * disc * capsule->radius / 3;
  }
  if (const auto* hull = std::get_if<HullShape>(&shape)) {
    const auto matter = detail::hull_matter(hull->points);
    return matter ? matter->mass : 0;
  }
  return 0;
}

CONTACT_SCENES_INLINE Matrix3<double> solid_inertia(const SceneShape& shape, double mass) {
  if (const auto* ball = std::get_if<BallShape>(&shape))
    return sphere_inertia<double>(mass, ball->radius);
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    const Vector3<double> size = 2.0 * box->half_lengths;
    return box_inertia<double>(mass, size);
  }
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return capsule_inertia<double>(mass, capsule->radius, 2 * capsule->half_length);
  if (const auto* hull = std::get_if<HullShape>(&shape)) {
    detail::require_size("mass", mass);
    if (const auto matter = detail::hull_matter(hull->points))
      return matter->inertia * (mass / matter->mass);
  }
  return Matrix3<double>::Zero();
}
// [/solid]

CONTACT_SCENES_INLINE double bounding_radius(const SceneShape& shape) {
  if (const auto* ball = std::get_if<BallShape>(&shape)) return ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->half_lengths.norm();
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return capsule->half_length + capsule->radius;
  if (const auto* hull = std::get_if<HullShape>(&shape)) {
    double radius = 0;
    for (const Vector3<double>& point : hull->points) radius = std::max(radius, point.norm());
    return radius;
  }
  return std::numeric_limits<double>::infinity();
}

namespace detail {

/// Support function: how far a body extends from its origin in a direction of the world, m.
CONTACT_SCENES_INLINE double scene_reach(const SceneBody& body, const Vector3<double>& direction) {
  const Vector3<double> d = matrix_of(body.orientation).transpose() * direction;
  if (const auto* ball = std::get_if<BallShape>(&body.shape)) return ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&body.shape))
    return d.cwiseAbs().dot(box->half_lengths);
  if (const auto* capsule = std::get_if<CapsuleShape>(&body.shape))
    return std::abs(d.z()) * capsule->half_length + capsule->radius;
  double support = -std::numeric_limits<double>::infinity();
  for (const Vector3<double>& point : std::get<HullShape>(body.shape).points)
    support = std::max(support, d.dot(point));
  return support;
}

/// The signed distance of a point of the world from a ball, a box or a capsule: negative inside.
CONTACT_SCENES_INLINE double scene_point_gap(const Vector3<double>& point, const SceneBody& body) {
  const Vector3<double> p =
      matrix_of(body.orientation).transpose() * Vector3<double>(point - body.position);
  if (const auto* ball = std::get_if<BallShape>(&body.shape)) return p.norm() - ball->radius;
  if (const auto* box = std::get_if<BoxShape>(&body.shape)) {
    const Vector3<double> beyond = p.cwiseAbs() - box->half_lengths;
    const double inside = beyond.maxCoeff();
    return inside < 0 ? inside : beyond.cwiseMax(0.0).norm();
  }
  const auto& capsule = std::get<CapsuleShape>(body.shape);
  const double z = std::clamp(p.z(), -capsule.half_length, capsule.half_length);
  return Vector3<double>(p.x(), p.y(), p.z() - z).norm() - capsule.radius;
}

/// A box or a capsule in its pose.
using SceneSolid = std::variant<OrientedBox<double>, Capsule<double>>;

CONTACT_SCENES_INLINE SceneSolid scene_solid(const SceneBody& body) {
  const auto frame = frame_of<double>({body.position, body.orientation});
  if (const auto* box = std::get_if<BoxShape>(&body.shape))
    return OrientedBox<double>{frame.origin, frame.axes, box->half_lengths};
  const auto& capsule = std::get<CapsuleShape>(body.shape);
  return capsule_along_z<double>(frame, capsule.half_length, capsule.radius);
}

/// A body as the points whose hull is its core, and the distance of its surface from the core.
struct SceneCore {
  std::vector<Vector3<double>> points;
  double radius = 0;
};

CONTACT_SCENES_INLINE SceneCore scene_core(const SceneBody& body) {
  if (const auto* ball = std::get_if<BallShape>(&body.shape))
    return {{body.position}, ball->radius};
  SceneCore core;
  if (const auto* hull = std::get_if<HullShape>(&body.shape)) {
    const Matrix3<double> axes = matrix_of(body.orientation);
    for (const int vertex : convex_hull(hull->points).vertices) {
      const Vector3<double> lever_arm = axes * hull->points[static_cast<std::size_t>(vertex)];
      core.points.emplace_back(body.position + lever_arm);
    }
    return core;
  }
  const SceneSolid solid = scene_solid(body);
  if (const auto* box = std::get_if<OrientedBox<double>>(&solid)) {
    for (int k = 0; k < 8; ++k) core.points.push_back(box_corner(*box, k));
    return core;
  }
  const auto& capsule = std::get<Capsule<double>>(solid);
  return {{capsule.core.start, capsule.core.end}, capsule.radius};
}

// [origin-gap]
/// Faces so narrow that rounding decides their orientation are left out; their
/// neighbours are equally near.
CONTACT_SCENES_INLINE double origin_gap(const std::vector<Vector3<double>>& points) {
  const Hull hull = convex_hull(points);
  const auto corner = [&](int i) -> const Vector3<double>& {
    return points[static_cast<std::size_t>(i)];
  };
  const Vector3<double> origin = Vector3<double>::Zero();
  double nearest_plane = -std::numeric_limits<double>::infinity();
  double nearest = std::numeric_limits<double>::infinity();
  for (int f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    const Vector3<double>& first = corner(face.front());
    Vector3<double> normal = origin;
    double size = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vector3<double>& from = corner(face[k]);
      const Vector3<double>& to = corner(face[(k + 1) % face.size()]);
      normal += Vector3<double>(from - first).cross(Vector3<double>(to - first));
      size = std::max({size, from.cwiseAbs().maxCoeff(), Vector3<double>(from - first).norm()});
      nearest = std::min(nearest, closest_point<double>(origin, Segment<double>{from, to}).norm());
    }
    const double length = normal.norm();
    if (!(length > 0x1p-40 * size * size)) continue;
    normal /= length;
    const double height = -normal.dot(first);  // of the origin above the face
    nearest_plane = std::max(nearest_plane, height);
    if (!(height > 0)) continue;
    bool over_face = true;
    for (std::size_t k = 0; k < face.size() && over_face; ++k) {
      const Vector3<double>& from = corner(face[k]);
      const Vector3<double> along = corner(face[(k + 1) % face.size()]) - from;
      over_face = normal.dot(along.cross(Vector3<double>(origin - from))) >= 0;
    }
    if (over_face) nearest = std::min(nearest, height);
  }
  return nearest_plane > 0 ? nearest : nearest_plane;
}

/// The signed distance of two bodies of which one is a hull, by the Minkowski difference of their
/// cores: they overlap where it contains the origin, and otherwise their distance is its distance
/// from the origin.
CONTACT_SCENES_INLINE double hull_gap(const SceneBody& a, const SceneBody& b) {
  const SceneCore core_a = scene_core(a);
  const SceneCore core_b = scene_core(b);
  std::vector<Vector3<double>> differences;
  differences.reserve(core_a.points.size() * core_b.points.size());
  for (const Vector3<double>& p : core_a.points) {
    for (const Vector3<double>& q : core_b.points) differences.emplace_back(p - q);
  }
  return origin_gap(differences) - (core_a.radius + core_b.radius);
}
// [/origin-gap]

}  // namespace detail

// [starting-gap]
CONTACT_SCENES_INLINE std::optional<double> starting_gap(const SceneBody& a, const SceneBody& b) {
  const auto* ground_a = std::get_if<HalfSpaceShape>(&a.shape);
  const auto* ground_b = std::get_if<HalfSpaceShape>(&b.shape);
  if (ground_a && ground_b) return std::nullopt;
  if (ground_a) return starting_gap(b, a);
  if (ground_b) {
    const Vector3<double> down = -ground_b->normal;
    return ground_b->normal.dot(a.position) - ground_b->offset - detail::scene_reach(a, down);
  }
  if (std::holds_alternative<HullShape>(a.shape) || std::holds_alternative<HullShape>(b.shape))
    return std::min(detail::hull_gap(a, b), detail::hull_gap(b, a));
  const auto* ball_a = std::get_if<BallShape>(&a.shape);
  const auto* ball_b = std::get_if<BallShape>(&b.shape);
  if (ball_a && ball_b)
    return Vector3<double>(a.position - b.position).norm() - (ball_a->radius + ball_b->radius);
  if (ball_a) return detail::scene_point_gap(a.position, b) - ball_a->radius;
  if (ball_b) return detail::scene_point_gap(b.position, a) - ball_b->radius;
  return std::visit(
      [](const auto& x, const auto& y) {
        return std::min(signed_distance(x, y).distance, signed_distance(y, x).distance);
      },
      detail::scene_solid(a), detail::scene_solid(b));
}

CONTACT_SCENES_INLINE double touching_slack(const SceneBody& a, const SceneBody& b) {
  double scale = 0;
  for (const SceneBody* body : {&a, &b}) {
    if (const auto* ground = std::get_if<HalfSpaceShape>(&body->shape)) {
      scale += std::abs(ground->offset);
    } else {
      scale += body->position.cwiseAbs().sum() + bounding_radius(body->shape);
    }
  }
  return 0x1p-49 * scale;
}
// [/starting-gap]

}  // namespace contact
