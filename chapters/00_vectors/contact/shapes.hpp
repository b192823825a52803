/// @file
/// The shapes of the book as plain data. This header has no algorithms, so that an exercise's
/// contract can use a shape without giving away the solution.
#pragma once

#include <contact/vector.hpp>

namespace contact {

/// The plane of all x with normal · x = offset.
///
/// A normal that is not a unit vector is a programming error: make planes with the functions of
/// contact/plane.hpp, which check their input.
template <Ring S>
struct Plane {
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, no unit of measure; points to the front
  S offset = S(0);  ///< signed distance of the plane from the origin along normal, m
};

/// All points from start to end, both included.
template <Ring S>
struct Segment {
  Vector3<S> start = Vector3<S>::Zero();  ///< m
  Vector3<S> end = Vector3<S>::Zero();    ///< m
};

/// All points origin + t direction with t ≥ 0. The direction need not be a unit vector: t is in
/// multiples of its length.
template <Ring S>
struct Ray {
  Vector3<S> origin = Vector3<S>::Zero();     ///< m
  Vector3<S> direction = Vector3<S>::Zero();  ///< m for each unit of t
};

/// All points at most radius from centre.
template <Ring S>
struct Sphere {
  Vector3<S> centre = Vector3<S>::Zero();  ///< m
  S radius = S(0);                         ///< m, not negative
};

/// The triangle a, b, c. Seen from its front, to which (b − a) × (c − a) points, the vertices are
/// counter-clockwise.
template <Ring S>
struct Triangle {
  Vector3<S> a = Vector3<S>::Zero();  ///< m
  Vector3<S> b = Vector3<S>::Zero();  ///< m
  Vector3<S> c = Vector3<S>::Zero();  ///< m
};

/// Where a ray or a segment intersects something.
template <Ring S>
struct RayHit {
  S t = S(0);  ///< in multiples of the direction as given; for a segment, from 0 to 1
  Vector3<S> point = Vector3<S>::Zero();  ///< m
};

/// Where a ray or a segment intersects a triangle.
template <Ring S>
struct TriangleHit {
  S t = S(0);  ///< as in RayHit
  Vector3<S> barycentric =
      Vector3<S>::Zero();  ///< weights of a, b and c in that order; their sum is 1
};

}  // namespace contact
