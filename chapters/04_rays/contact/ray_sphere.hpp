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
/// difference of squares has lost 2 log₂ m bits: at m = 10⁸ in double, 3000 in float, none is left,
/// and the line is said to miss, or to touch anywhere. Squares of numbers beyond 1e154 overflow.
/// Nothing for a negative radicand and for NaN; a sphere of radius 0 by luck only.
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
/// or −B − √ cancels too. A direction of 0 divides 0 by 0 and gives nothing or NaN.
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

// [by-nearest-point]
/// The same by the point of the line nearest to the centre: the discriminant is a (r² − f·f), with
/// f from the centre to that point; then q = −(b + sign(b) √), t = q/a and c/q.
///
/// In f one vector is subtracted instead of squares, so the radicand loses log₂ m bits from a
/// distance of m radii, half as many; the roots do not cancel.
///
/// Limits: rounded, so a line that nearly touches may be found or missed. From 10¹⁶ radii (double)
/// f has no digit left. Nothing for a direction of 0 and for NaN.
///
/// Source: Haines, Günther and Akenine-Möller, *Precision Improvements for Ray/Sphere
/// Intersection*, Ray Tracing Gems (2019), chapter 7.
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

// [terms]
/// The coefficients of |m + t d|² − r² = a t² + 2 b t + c, and a quarter of its discriminant.
template <Ring T>
struct SphereTerms {
  T a;      ///< d·d
  T b;      ///< d·m
  T c;      ///< m·m − r²: the start is outside (> 0), on the surface, or inside (< 0)
  T depth;  ///< b² − a c = r² a − |d × m|²: the line misses (< 0), touches, or crosses
};
// [/terms]

/// The terms of a line in exact numbers.
inline SphereTerms<Exact> exact_sphere_terms(const Ray<Exact>& ray, const Sphere<double>& sphere) {
  const Vector3<Exact> m = ray.origin - exact_vector(sphere.centre);
  const Exact r(sphere.radius);
  const Exact a = ray.direction.dot(ray.direction);
  const Exact b = ray.direction.dot(m);
  const Exact c = m.dot(m) - r * r;
  return {a, b, c, b * b - a * c};
}

/// A sphere of floats or doubles, unchanged, as doubles.
template <FloatOrDouble S>
Sphere<double> in_double(const Sphere<S>& sphere) {
  return {sphere.centre.template cast<double>(), static_cast<double>(sphere.radius)};
}

/// Whether every number is finite and the radius is not negative.
template <std::floating_point S>
bool is_ball(const Sphere<S>& sphere) {
  return all_finite(sphere.centre) && is_finite(sphere.radius) && sphere.radius >= S(0);
}

/// How the unbounded line through a ray or a segment meets a ball. Right for every finite input. A
/// direction of 0 is a point: crosses if that is in the ball, else misses. An input that is not
/// finite, and a negative radius: misses.
template <FloatOrDouble S, LineOf<S> Line>
LineMeets sphere_crossing(const Line& line, const Sphere<S>& sphere) {
  if (!is_finite(line) || !is_ball(sphere)) return LineMeets::misses;
  const SphereTerms<Exact> x = exact_sphere_terms(exact_ray_of(line), in_double(sphere));
  if (x.a.sign() == 0) return x.c.sign() > 0 ? LineMeets::misses : LineMeets::crosses;
  return x.depth.sign() < 0 ? LineMeets::misses
                            : (x.depth.sign() == 0 ? LineMeets::touches : LineMeets::crosses);
}

/// Whether a ray or a segment meets a solid ball. Touching counts.
///
/// Right for every finite input: only signs are computed, no root. A line that starts inside meets
/// it; a direction of 0 and a segment of one point are points. An input that is not finite, and a
/// negative radius: no.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_sphere(const Line& line, const Sphere<S>& sphere) {
  if (!is_finite(line) || !is_ball(sphere)) return false;
  const SphereTerms<Exact> x = exact_sphere_terms(exact_ray_of(line), in_double(sphere));
  if (x.c.sign() <= 0) return true;
  if (x.b.sign() >= 0 || x.depth.sign() < 0) return false;
  return !has_end<Line> || (x.a + x.b).sign() >= 0 || (x.a + x.b + x.b + x.c).sign() <= 0;
}

/// Where the unbounded line through a ray or a segment enters and leaves a ball: the book's choice.
///
/// The decision is right for every finite input, as that of sphere_crossing. No face numbers; a
/// direction of 0 in the ball has entry −∞, exit ∞ and normals 0.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Sphere<S>& sphere) {
  if (sphere_crossing(line, sphere) == LineMeets::misses) return std::nullopt;
  const Ray<Exact> ray = exact_ray_of(line);
  const SphereTerms<Exact> x = exact_sphere_terms(ray, in_double(sphere));
  Passage<S> found;
  if (x.a.sign() == 0) {
    found.exit = std::numeric_limits<S>::infinity();
    found.entry = -found.exit;
    return found;
  }
  const S root = std::sqrt(quotient<S>(x.depth, x.a * x.a));
  const S middle = quotient<S>(-x.b, x.a);
  const Ray<S>& rounded = ray_of(line);
  return detail::passage_of_roots<S>(Vector3<S>(rounded.origin - sphere.centre), rounded.direction,
                                     middle - root, middle + root);
}

/// What a ray or a segment meets first of a solid ball. The decision is that of hits_sphere, also
/// `inside`.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Sphere<S>& sphere) {
  if (!hits_sphere(line, sphere)) return std::nullopt;
  return first_hit(line, *passage(line, sphere));
}

}  // namespace contact
