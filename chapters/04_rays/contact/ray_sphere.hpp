/// @file
/// Line, ray and segment against a ball: by the lecture's formula, by the textbook's, by the
/// nearest point, and with a decision that is never wrong.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <contact/exact.hpp>
#include <contact/passage.hpp>
#include <contact/shapes.hpp>
#include <contact/sphere_terms.hpp>
#include <contact/vector.hpp>
#include <limits>
#include <optional>

namespace contact {

namespace detail {

/// Both ends of a passage through a sphere, with normals from the centre.
template <std::floating_point S>
Passage<S> passage_of_roots(const Vector3<S>& m, const Vector3<S>& d, const S& low, const S& high) {
  Passage<S> found;
  found.entry = low;
  found.exit = high;
  found.entry_normal = Vector3<S>(m + d * low).normalized();
  found.exit_normal = Vector3<S>(m + d * high).normalized();
  return found;
}

}  // namespace detail

// [by-lecture]
/// The line through a sphere by t = −D·M ± √((D·M)² − (M·M − r²)), with M from the centre to the
/// origin: the formula for a unit direction.
///
/// Limits: with a direction of another length it is wrong. From a distance of m radii the
/// difference of squares has lost 2 log₂ m bits: at m = 10⁸ in double, 4000 in float, none is left,
/// and the line is said to miss, or to touch anywhere. Squares of numbers beyond 1e154 overflow.
/// Nothing for a negative radicand and for NaN; a sphere of radius 0 by luck only. A direction of 0
/// in the sphere gives t = ±√(r² − M·M); infinities, nothing or t that are infinite or NaN. A
/// negative radius counts as its magnitude.
///
/// Source: *Fundamentals of Computer Animation*, slides "Ray-Sphere".
template <std::floating_point S>
std::optional<Passage<S>> passage_by_lecture(const Ray<S>& ray, const Sphere<S>& sphere) {
  const Vector3<S> m = ray.origin - sphere.centre;
  const S along = ray.direction.dot(m);
  const S radicand = along * along - (m.dot(m) - sphere.radius * sphere.radius);
  if (!(radicand >= S(0))) return std::nullopt;
  const S root = std::sqrt(radicand);
  return detail::passage_of_roots<S>(m, ray.direction, -along - root, -along + root);
}
// [/by-lecture]

// [by-textbook]
/// The same by t = (−B ± √(B² − 4AC)) / 2A with A = D·D, B = 2 D·M, C = M·M − r², for a direction
/// of any length.
///
/// Limits: the radicand cancels as in passage_by_lecture. From inside or near the surface −B + √
/// or −B − √ cancels too. A direction of 0 divides 0 by 0 and gives nothing or NaN. Infinities,
/// overflow, NaN and a negative radius as above.
///
/// Source: *Interaction and Normals*, slides "Line-Sphere".
template <std::floating_point S>
std::optional<Passage<S>> passage_by_textbook(const Ray<S>& ray, const Sphere<S>& sphere) {
  const Vector3<S> m = ray.origin - sphere.centre;
  const S a = ray.direction.dot(ray.direction);
  const S b = S(2) * ray.direction.dot(m);
  const S c = m.dot(m) - sphere.radius * sphere.radius;
  const S discriminant = b * b - S(4) * a * c;
  if (!(discriminant >= S(0))) return std::nullopt;
  const S root = std::sqrt(discriminant);
  return detail::passage_of_roots<S>(m, ray.direction, (-b - root) / (S(2) * a),
                                     (-b + root) / (S(2) * a));
}
// [/by-textbook]

/// The same by the point of the line nearest to the centre: the discriminant is a (r² − f·f), with
/// f from the centre to that point; then q = −(b + sign(b) √), t = q/a and c/q.
///
/// In f one vector is subtracted instead of squares, so the radicand loses log₂ m bits from a
/// distance of m radii, half as many; the roots do not cancel.
///
/// Limits: rounded, so a line that nearly touches may be found or missed. From 10¹⁶ radii (double)
/// f has no digit left. Nothing for a direction of 0 and for NaN; infinities, overflow and a
/// negative radius as above.
///
/// Source: Haines, Günther and Akenine-Möller, *Precision Improvements for Ray/Sphere
/// Intersection*, Ray Tracing Gems (2019), chapter 7.
// [by-nearest-point]
template <std::floating_point S>
std::optional<Passage<S>> passage_by_nearest_point(const Ray<S>& ray, const Sphere<S>& sphere) {
  const Vector3<S> m = ray.origin - sphere.centre;
  const S a = ray.direction.dot(ray.direction);
  const S b = ray.direction.dot(m);
  const Vector3<S> f = m - ray.direction * (b / a);
  const S discriminant = a * (sphere.radius * sphere.radius - f.dot(f));
  if (!(discriminant >= S(0))) return std::nullopt;
  const S root = std::sqrt(discriminant);
  const S c = m.dot(m) - sphere.radius * sphere.radius;
  const S q = b > S(0) ? -b - root : -b + root;
  const S one = q / a;
  const S other = q == S(0) ? S(0) : c / q;
  return detail::passage_of_roots<S>(m, ray.direction, std::min(one, other), std::max(one, other));
}
// [/by-nearest-point]

/// How an unbounded line meets a ball.
enum class LineMeets {
  misses,   ///< no common point
  touches,  ///< one common point: the line is a tangent, or the ball is a point on the line
  crosses   ///< a common segment; also a direction of 0 from a point inside or on the surface
};

// [sphere-crossing]
/// How the unbounded line through a ray or a segment meets a ball.
///
/// Right for every finite input: the sign of the discriminant from floating point if its error
/// bound allows, else from exact arithmetic. A direction of 0 is a point: crosses if that is in the
/// ball, else misses. An input that is not finite, and a negative radius: misses.
template <FloatOrDouble S, LineOf<S> Line>
LineMeets sphere_crossing(const Line& line, const Sphere<S>& sphere) {
  if (!is_finite(line) || !is_ball(sphere)) return LineMeets::misses;
  const auto stored = in_double(line);
  const Sphere<double> ball = in_double(sphere);
  const detail::RoughSphere rough(ray_of(stored), ball);
  const int sign = detail::depth_sign(stored, ball, rough);
  if (sign != 0) return sign < 0 ? LineMeets::misses : LineMeets::crosses;
  const SphereTerms<Exact> x = detail::exact_terms(exact_ray_of(stored), ball);
  if (x.a.sign() != 0) return LineMeets::touches;
  return x.c.sign() > 0 ? LineMeets::misses : LineMeets::crosses;
}
// [/sphere-crossing]

// [hits-sphere]
/// Whether a ray or a segment meets a solid ball. Touching counts.
///
/// Right for every finite input: only signs are computed, no root. A line that starts inside meets
/// it; a direction of 0 and a segment of one point are points; a ball of radius 0 is a point. An
/// input that is not finite, and a negative radius: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_sphere(const Line& line, const Sphere<S>& sphere) {
  return detail::decide_sphere(line, sphere);
}
// [/hits-sphere]

// [sphere-passage]
/// Where the unbounded line through a ray or a segment enters and leaves a ball: the book's choice.
///
/// The decision is that of sphere_crossing. No face numbers. A direction of 0 in the ball has entry
/// −∞, exit ∞ and normals 0; a ball of radius 0 has normals along the line.
///
/// Limits: each t is within 2^-40 of the larger magnitude of both, and then rounded to S; a tangent
/// has entry = exit. A t beyond the largest number is infinite. The normals are unit vectors to a
/// few u, and each of their coordinates is within 2^-20 of the exact one.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Sphere<S>& sphere) {
  const LineMeets meets = sphere_crossing(line, sphere);
  if (meets == LineMeets::misses) return std::nullopt;
  const auto stored = in_double(line);
  const Sphere<double> ball = in_double(sphere);
  Passage<S> found;
  if (detail::is_point(stored)) {
    found.exit = std::numeric_limits<S>::infinity();
    found.entry = -found.exit;
    return found;
  }
  const detail::SphereRoots roots =
      detail::sphere_roots(stored, ball, detail::RoughSphere(ray_of(stored), ball));
  found.entry = static_cast<S>(roots.entry);
  found.exit = static_cast<S>(roots.exit);
  found.entry_normal = roots.entry_normal.template cast<S>();
  found.exit_normal = roots.exit_normal.template cast<S>();
  return found;
}
// [/sphere-passage]

namespace detail {

/// The hit of a line that meets the ball.
template <FloatOrDouble S, class Line>
BodyHit<S> hit_of_meeting(const Line& line, const Sphere<S>& sphere) {
  const auto stored = contact::in_double(line);
  const Sphere<double> ball = contact::in_double(sphere);
  const RoughSphere rough(ray_of(stored), ball);
  BodyHit<S> hit;
  hit.point = start_of(line);
  hit.inside = rough.x.c < -rough.c_bound;
  if (!hit.inside && !(rough.x.c > rough.c_bound)) {
    const SphereTerms<Exact> x = exact_terms(exact_ray_of(stored), ball);
    hit.inside = x.c.sign() < 0 || (x.c.sign() == 0 && (x.b.sign() > 0 || x.a.sign() == 0));
  }
  if (hit.inside) return hit;
  const SphereRoots roots = sphere_roots(stored, ball, rough);
  const double last = has_end<Line> ? 1.0 : std::numeric_limits<double>::infinity();
  hit.t = static_cast<S>(std::clamp(roots.entry, 0.0, last));
  hit.normal = roots.entry_normal.template cast<S>();
  const Vector3<double> point = ball.centre + roots.entry_normal * ball.radius;
  if (roots.entry != 0) hit.point = point.template cast<S>();
  return hit;
}

}  // namespace detail

// [first-hit-sphere]
/// What a ray or a segment meets first of a solid ball.
///
/// The decision is that of hits_sphere. `inside` is exact too: the start is inside, or on the
/// surface while the line leaves. From the surface inwards, or along it: t = 0 and not inside.
///
/// Limits: t and the normal as in passage; t is from 0 and, for a segment, to 1. The point is off
/// by at most 2^-20 radii, and by a few roundings of its coordinates, also if t is infinite.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Sphere<S>& sphere) {
  if (!detail::decide_sphere(line, sphere)) return std::nullopt;
  return detail::hit_of_meeting(line, sphere);
}
// [/first-hit-sphere]

}  // namespace contact
