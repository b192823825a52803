/// @file
/// Line, ray and segment against a capsule.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/capsule.hpp>
#include <contact/convex_part.hpp>
#include <contact/passage.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// |m + t w|² − r² for a ball, with m from its centre to the start of the line.
template <class T>
ConvexPart<T> ball_part(const Triple<T>& m, const Triple<T>& w, const T& radius) {
  const Triple<T> skew = cross(m, w);
  const T square = radius * radius;
  ConvexPart<T> part;
  part.round = true;
  part.a = dot(w, w);
  part.b = dot(m, w);
  part.c = dot(m, m) - square;
  part.depth = square * part.a - dot(skew, skew);
  return part;
}

// [capsule-parts]
/// A capsule as three convex parts: the balls about the ends of its core, and between them the
/// cylinder. The caps of the cylinder are inside the balls.
struct CapsuleParts {
  const DoubleLine& line;
  const DoubleCore& core;

  int count() const { return core.start == core.end ? 1 : 3; }
  template <class T>
  ConvexPart<T> part(int k) const {
    const Triple<T> w = line.direction<T>();
    if (k < 2) return ball_part(line.from<T>(k == 0 ? core.start : core.end), w, T(core.radius));
    return CylinderParts{line, core, true}.part<T>(0);
  }
  // [/capsule-parts]
  bool is_body() const { return line.finite() && core.is_body(); }

  /// Away from the nearest point of the core.
  Vector3<double> normal(double t, int) const {
    const Vector3<double> p = line.at(t, core.start), axis = core.end - core.start;
    if (core.radius == 0 || !all_finite(axis)) return Vector3<double>::Zero();
    const Vector3<double> unit = unit_or_zero(axis);
    const double along = unit.dot(p);
    if (!(along > 0)) return unit_or_zero(p);
    if (along >= unit.dot(axis)) return unit_or_zero(line.at(t, core.end));
    return unit_or_zero(core.off_axis(p));
  }
};

template <FloatOrDouble S, LineOf<S> Line, class Answer>
auto ask_capsule(const Line& line, const Capsule<S>& capsule, const Answer& answer) {
  const DoubleLine in_double(line);
  const DoubleCore core(capsule.core, capsule.radius);
  const CapsuleParts parts{in_double, core};
  return parts.is_body() ? answer(parts) : decltype(answer(parts)){};
}

}  // namespace detail

// [capsule-by-textbook]
/// A ray against a capsule as it is often written: the wall first, by the textbook's quadratic; if
/// that is met beyond an end of the core, the ball there.
///
/// Limits: those of passage_by_textbook for a cylinder. It gives the first t ≥ 0 of a surface, so a
/// start inside finds the way out, and a ray along the axis, whose a rounds to 0, asks only one
/// ball: the one next to its start. A core of length 0 makes a ball, and a negative radius counts
/// as its magnitude. Nothing for a direction of 0 and for NaN; overflow and underflow may lose the
/// hit.
///
/// Source: Ericson, *Real-Time Collision Detection* (2005), section 5.3.7.
template <std::floating_point S>
std::optional<S> capsule_hit_by_textbook(const Ray<S>& ray, const Capsule<S>& capsule) {
  const Vector3<S> e = capsule.core.end - capsule.core.start;
  const Vector3<S> m = ray.origin - capsule.core.start;
  const S ee = e.dot(e), ew = e.dot(ray.direction), em = e.dot(m);
  const S a = ee * ray.direction.dot(ray.direction) - ew * ew;
  const S b = ee * m.dot(ray.direction) - ew * em;
  const S c = ee * (m.dot(m) - capsule.radius * capsule.radius) - em * em;
  S along = em;
  if (a != S(0)) {
    const S discriminant = b * b - a * c;
    if (!(discriminant >= S(0))) return std::nullopt;
    const S t = (-b - std::sqrt(discriminant)) / a;
    along = em + t * ew;
    if (S(0) <= along && along <= ee) return t >= S(0) ? std::optional<S>(t) : std::nullopt;
  } else if (c > S(0)) {
    return std::nullopt;
  }
  const Vector3<S> from = along < ee / S(2) ? m : Vector3<S>(m - e);
  const S square = ray.direction.dot(ray.direction), half = from.dot(ray.direction);
  const S rest = half * half - square * (from.dot(from) - capsule.radius * capsule.radius);
  if (!(rest >= S(0))) return std::nullopt;
  const S t = (-half - std::sqrt(rest)) / square;
  return t >= S(0) ? std::optional<S>(t) : std::nullopt;
}
// [/capsule-by-textbook]

/// Whether a ray or a segment meets a solid capsule. Touching counts.
///
/// Right for every finite input. A core of length 0 makes a ball, a radius of 0 a segment; a
/// direction of 0 is a point. No for a negative radius and for numbers that are not finite.
template <FloatOrDouble S, LineOf<S> Line>
bool hits_capsule(const Line& line, const Capsule<S>& capsule) {
  return detail::ask_capsule(line, capsule, [](const detail::CapsuleParts& parts) {
    return detail::meets_parts(parts.count(), parts, parts.line.extent);
  });
}

/// Where the unbounded line through a ray or a segment enters and leaves a capsule: the book's
/// choice. Decision and t as for a cylinder; no face has a number. The normal points away from the
/// nearest point of the core; 0 for a radius of 0 and where a difference of coordinates overflows.
/// A direction of 0 in the capsule has entry −∞, exit ∞. Nothing for what hits_capsule denies.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<Passage<S>> passage(const Line& line, const Capsule<S>& capsule) {
  return detail::ask_capsule(line, capsule, [](const detail::CapsuleParts& parts) {
    std::optional<detail::PartPassage> found = detail::passage_in_parts(parts.count(), parts);
    if (found) {  // a cap of the cylinder is inside a ball
      found->entry.face = std::min(found->entry.face, -1);
      found->exit.face = std::min(found->exit.face, -1);
    }
    return detail::passage_with_normals<S>(
        found, [&](double t, int face) { return parts.normal(t, face); });
  });
}

/// What a ray or a segment meets first of a solid capsule. Decision and `inside` are exact; nothing
/// where hits_capsule says no. A t beyond the largest number is that number.
template <FloatOrDouble S, LineOf<S> Line>
std::optional<BodyHit<S>> first_hit(const Line& line, const Capsule<S>& capsule) {
  return detail::ask_capsule(
      line, capsule, [](const detail::CapsuleParts& parts) -> std::optional<BodyHit<S>> {
        auto hit = detail::hit_with_normal<S>(
            parts.line, detail::passage_in_parts(parts.count(), parts, parts.line.extent),
            [&](double t, int face) { return parts.normal(t, face); });
        if (hit) hit->face = -1;
        return hit;
      });
}

}  // namespace contact
