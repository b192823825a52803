/// @file
/// Random planes and numbers, and error bounds of signed distances.
#pragma once

#include <contact/plane.hpp>

#include "support/generators.hpp"
#include "support/oracle_planes.hpp"
#include "support/rounding.hpp"

namespace reference {

using contact::Plane;
using contact::Triangle;
using contact::Vector3;
using generators::Family;
using oracle::ExactPlane;
using oracle::Rational;
using oracle::Vector;
using rounding::eta;
using rounding::gamma;

/// Σ |aᵢ bᵢ|.
inline Rational absolute_dot(const Vector& a, const Vector& b) {
  return abs(a.x() * b.x()) + abs(a.y() * b.y()) + abs(a.z() * b.z());
}

/// The families whose numbers fit into a float (huge and tiny do not: they would be ∞ and 0).
template <class S>
bool fits(Family family) {
  return sizeof(S) == sizeof(double) || (family != Family::huge && family != Family::tiny);
}

/// A random plane of type S near a triangle: through its vertices, or facing along its normal.
template <class S>
std::optional<Plane<S>> plane_of(const Triangle<S>& t) {
  const ExactPlane plane =
      oracle::plane_through(oracle::exact(t.a), oracle::exact(t.b), oracle::exact(t.c));
  if (!plane.exists()) return std::nullopt;
  return contact::plane_from_points(t.a, t.b, t.c);
}

/// Bound on the error of |n·x − k| in type S: four successive roundings, three products that may
/// underflow.
template <class S>
Rational distance_bound(const Plane<S>& plane, const Vector3<S>& x) {
  return gamma<S>(4) * (absolute_dot(oracle::exact(plane.normal), oracle::exact(x)) +
                        abs(oracle::exact(plane.offset))) +
         3 * eta<S>() / 2;
}

}  // namespace reference
