/// @file
/// The first hit in a scene of many bodies, and the bullet: a fast body as a segment.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/capsule.hpp>
#include <contact/entry_order.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/oriented_box.hpp>
#include <contact/passage.hpp>
#include <contact/ray_box.hpp>
#include <contact/ray_capsule.hpp>
#include <contact/ray_cone.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/ray_sphere.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// What a ray or a segment meets first of a triangle. It is a surface: `inside` is false, the face
/// is 0, and the normal is on the side that the line comes from. The decision is that of
/// intersect_exact: a line in the plane of the triangle gives nothing, nor do a direction of 0, a
/// triangle without area and numbers that are not finite. A t beyond the largest number is that
/// number; the normal is 0 where an edge overflows.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Triangle<S>& triangle) {
  const std::optional<TriangleHit<S>> met = intersect_exact<S>(line, triangle);
  if (!met) return std::nullopt;
  const detail::DoubleLine in_double(line);
  const Vector3<double> a = triangle.a.template cast<double>();
  Vector3<double> normal = detail::unit_or_zero(
      detail::unit_or_zero(triangle.b.template cast<double>() - a)
          .cross(detail::unit_or_zero(triangle.c.template cast<double>() - a)));
  Vector3<double> along = in_double.second;
  if (in_double.extent == detail::LineExtent::segment) {
    along -= in_double.start;
    if (!all_finite(along)) along = in_double.second / 2 - in_double.start / 2;
  }
  if (normal.dot(detail::unit_or_zero(along)) > 0) normal = -normal;
  const double t = detail::in_range(static_cast<double>(met->t), 0);
  BodyHit<S> hit;
  hit.t = detail::to_scalar<S>(t);
  hit.point = in_double.at(t, Vector3<double>::Zero()).template cast<S>();
  hit.normal = normal.template cast<S>();
  hit.face = 0;
  return hit;
}

/// What a ray or a segment meets first of a body of any kind. Degenerate input as for that kind: a
/// line or a body that is not finite gives nothing.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Primitive<S>& body) {
  return std::visit([&line](const auto& shape) { return first_hit(line, shape); }, body);
}

// [first-in-scene]
/// A hit, and which body.
template <Ring S>
struct IndexedHit {
  std::size_t index = 0;  ///< of the body in the scene
  BodyHit<S> hit;         ///< where the line meets it
};

/// The body that a ray or a segment meets first: smallest t; of equal t, the lowest index.
///
/// Whether a body is met is exact for each, and so is the order: entries that are closer than their
/// errors are compared without rounding. A body that the line starts in has t = 0. Nothing in an
/// empty scene and for a line that is not finite; what is not a body (not finite, a negative
/// radius, a box with low > high) is not met.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<IndexedHit<S>> first_in_scene(const Line& line, std::span<const Primitive<S>> scene) {
  const detail::DoubleLine in_double(line);
  std::optional<IndexedHit<S>> first;
  Entered<S> earliest{nullptr, 0};
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const std::optional<BodyHit<S>> hit = first_hit(line, scene[i]);
    if (!hit) continue;
    const Entered<S> entered{&scene[i], detail::entry_key<S>(in_double, scene[i])};
    if (first && !entered_before<S>(in_double, entered, earliest)) continue;
    first = IndexedHit<S>{i, *hit};
    earliest = entered;
  }
  return first;
}

/// All bodies that the line meets, in the order in which it enters them; of equal t, by index. None
/// where first_in_scene gives nothing.
template <FloatOrDouble S, LineOf<S> Line>
std::vector<IndexedHit<S>> all_in_scene(const Line& line, std::span<const Primitive<S>> scene) {
  const detail::DoubleLine in_double(line);
  std::vector<std::pair<Entered<S>, IndexedHit<S>>> met;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (const auto hit = first_hit(line, scene[i])) {
      met.push_back({{&scene[i], detail::entry_key<S>(in_double, scene[i])}, {i, *hit}});
    }
  }
  std::stable_sort(met.begin(), met.end(), [&in_double](const auto& a, const auto& b) {
    return entered_before<S>(in_double, a.first, b.first);
  });
  std::vector<IndexedHit<S>> hits;
  for (const auto& [entered, hit] : met) hits.push_back(hit);
  return hits;
}
// [/first-in-scene]

// [bullet]
/// What a body meets that moves by a displacement in each step.
template <Ring S>
struct BulletHit {
  int step = 0;           ///< the step in which it meets the body, from 0
  std::size_t index = 0;  ///< of the body
  BodyHit<S> hit;         ///< t within the step, from 0 to 1; in samples 1 and `inside`
};

/// A bullet sampled at the end of each step: it meets a body if a sample is in it. The positions
/// are start + (k + 1) displacement.
///
/// Limits: what is thinner than a displacement may be between two samples and is missed. Triangles,
/// which have no inside, are never met. A displacement of 0 is a bullet at rest. Nothing for steps
/// ≤ 0; a sample that is not finite, also because it overflows, meets nothing.
template <FloatOrDouble S>
std::optional<BulletHit<S>> bullet_by_samples(const Vector3<S>& start,
                                              const Vector3<S>& displacement, int steps,
                                              std::span<const Primitive<S>> scene) {
  for (int k = 0; k < steps; ++k) {
    const Vector3<S> sample = start + displacement * S(k + 1);
    const auto met = first_in_scene<S>(Ray<S>{sample, Vector3<S>::Zero()}, scene);
    if (!met) continue;
    BulletHit<S> found{k, met->index, met->hit};
    found.hit.t = S(1);
    return found;
  }
  return std::nullopt;
}

/// The same with the segment of each step as a line: nothing on the path is missed, because each
/// step starts at the stored point where the one before ended.
///
/// What it leaves out: the radius of the bullet (ball_first_hit), its rotation, the motion of the
/// walls, and everything that bends the path within a step (chapter *Time of impact*). A step with
/// an end that is not finite, also because it overflows, meets nothing, as does a triangle a bullet
/// at rest. Nothing for steps ≤ 0.
template <FloatOrDouble S>
std::optional<BulletHit<S>> bullet_by_segments(const Vector3<S>& start,
                                               const Vector3<S>& displacement, int steps,
                                               std::span<const Primitive<S>> scene) {
  for (int k = 0; k < steps; ++k) {
    const Segment<S> path{start + displacement * S(k), start + displacement * S(k + 1)};
    if (const auto met = first_in_scene<S>(path, scene)) {
      return BulletHit<S>{k, met->index, met->hit};
    }
  }
  return std::nullopt;
}
// [/bullet]

}  // namespace contact
