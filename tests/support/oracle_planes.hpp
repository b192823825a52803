/// @file
/// Right answers about planes, for the tests of the book and of its exercises. It shares no code
/// with the reference.
///
/// A plane here is N · x = K with N of any length, so nothing is rounded: the distances and times
/// that need |N| are Surds.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>

#include "support/oracle.hpp"

namespace oracle {

/// N · x = K, with N not 0 unless the points it came from are collinear.
struct ExactPlane {
  Vector normal = Vector::Zero();
  Rational offset{0};

  bool exists() const { return normal != Vector::Zero(); }
};

inline Rational dot(const Vector& a, const Vector& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// Through three points; the front sees them counter-clockwise.
inline ExactPlane plane_through(const Vector& a, const Vector& b, const Vector& c) {
  const Vector normal = cross(b - a, c - a);
  return {normal, dot(normal, a)};
}
/// Through a point, facing along a normal of any length.
inline ExactPlane plane_facing(const Vector& normal, const Vector& point) {
  return {normal, dot(normal, point)};
}
/// A stored plane as its numbers say; its normal is a unit vector only up to rounding.
template <std::floating_point S>
ExactPlane plane_as_stored(const contact::Plane<S>& plane) {
  return {exact(plane.normal), exact(plane.offset)};
}

/// N · x − K.
inline Rational value(const ExactPlane& plane, const Vector& x) {
  return dot(plane.normal, x) - plane.offset;
}
/// -1 behind, 0 on, 1 in front.
inline int side(const ExactPlane& plane, const Vector& x) { return sign(value(plane, x)); }

/// (N · x − K) / |N|.
inline Surd distance(const ExactPlane& plane, const Vector& x) {
  return divided_by_root(value(plane, x), dot(plane.normal, plane.normal));
}
/// N / |N|.
inline std::array<Surd, 3> unit_normal(const ExactPlane& plane) {
  const Rational squared = dot(plane.normal, plane.normal);
  return {divided_by_root(plane.normal.x(), squared), divided_by_root(plane.normal.y(), squared),
          divided_by_root(plane.normal.z(), squared)};
}
/// K / |N|.
inline Surd unit_offset(const ExactPlane& plane) {
  return divided_by_root(plane.offset, dot(plane.normal, plane.normal));
}

/// The one common point of a segment and a plane, t from 0 to 1; nothing if there is none or if
/// there are many.
inline std::optional<contact::RayHit<Rational>> crossing(const contact::Segment<Rational>& segment,
                                                         const ExactPlane& plane) {
  const Rational start = value(plane, segment.start);
  const Rational end = value(plane, segment.end);
  if (start == end) return std::nullopt;  // parallel, in the plane or beside it
  const Rational t = start / (start - end);
  if (t < 0 || t > 1) return std::nullopt;
  const Vector way = segment.end - segment.start;
  return contact::RayHit<Rational>{t, Vector(segment.start + way * t)};
}

/// Whether a sphere meets a plane: |N · c − K| against r |N|, compared as numbers with a root.
/// Nothing meets what is no plane.
inline bool meets(const contact::Sphere<Rational>& sphere, const ExactPlane& plane) {
  if (!plane.exists()) return false;
  const Rational length_squared = dot(plane.normal, plane.normal);
  return compare(Surd{abs(value(plane, sphere.centre)), 0, 0},
                 Surd{0, sphere.radius, length_squared}) <= 0;
}

/// When a moving sphere first touches a plane, as part of the displacement, 0 to 1. Zero if it
/// touches at the start.
inline std::optional<Surd> first_touch(const contact::Sphere<Rational>& sphere,
                                       const Vector& displacement, const ExactPlane& plane) {
  if (meets(sphere, plane)) return Surd{0, 0, 0};
  const int front = side(plane, sphere.centre);
  const Rational closing = -front * dot(plane.normal, displacement);
  if (closing <= 0) return std::nullopt;
  const Rational squared = dot(plane.normal, plane.normal);
  const Surd t{abs(value(plane, sphere.centre)) / closing, -sphere.radius / closing, squared};
  if (sign(t + Rational(-1)) > 0) return std::nullopt;
  return t;
}

}  // namespace oracle
