/// @file
/// A sphere that moves in a straight line against a plane that does not move: the offset-plane
/// trick.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include <contact/plane.hpp>
#include <contact/shapes.hpp>

namespace contact {

/// The first touch of a moving sphere.
template <Ring S>
struct MovingSphereHit {
  S t = S(0);  ///< part of the displacement covered at the touch, from 0 to 1
  Vector3<S> centre = Vector3<S>::Zero();  ///< of the sphere at that time, m
  Vector3<S> point = Vector3<S>::Zero();   ///< the contact point, on the plane itself, m
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector from the plane to the sphere
};

namespace detail {

/// The start distance and the change of distance over the whole displacement; both divided by 8
/// with the radius if one of them would overflow.
template <std::floating_point S>
struct Approach {
  S distance;
  S change;
  S radius;
};

template <std::floating_point S>
Approach<S> approach(const Sphere<S>& sphere, const Vector3<S>& displacement,
                     const Plane<S>& plane) {
  const S distance = plane.normal.dot(sphere.centre) - plane.offset;
  const S change = plane.normal.dot(displacement);
  if (std::isfinite(distance) && std::isfinite(change)) return {distance, change, sphere.radius};
  const S eighth = S(1) / S(8);
  return {plane.normal.dot(Vector3<S>(sphere.centre * eighth)) - plane.offset * eighth,
          plane.normal.dot(Vector3<S>(displacement * eighth)), sphere.radius * eighth};
}

}  // namespace detail

// [moving-sphere-plane]
/// When and where a moving sphere first touches a plane.
///
/// The sphere touches when its centre is at the distance r, so the centre alone, a particle, is
/// tested against the plane moved by r towards it. Which way to move it is the sign of the distance
/// at the *start*. With s that sign, d the distance and D the displacement: gap = s d − r, closing
/// = −s n·D, and t = gap / closing.
///
/// This holds for a plane without end. The set of centres that touch a *polygon* is not only the
/// offset polygon: it has a cylinder of radius r round each edge and a sphere of radius r round
/// each vertex.
/// @param sphere where it starts, m, with a radius that is not negative
/// @param displacement of the centre during the step (velocity × time step), m
/// @param plane with a unit normal
/// @return the first touch. A sphere that meets the plane at the start touches at t = 0, wherever
/// it is going. Nothing if it starts clear of the plane and rests, goes along it, goes away, or
/// does not get there. If the centre starts exactly on the plane, the normal is the one against the
/// motion (the plane's own if the motion is along it).
/// @note In a floating-point type, t has an error of about 8 u (Σ|nᵢ cᵢ| + |k| + r + t Σ|nᵢ Dᵢ|) /
/// closing.
/// @see *Fundamentals of Computer Animation: Collision Detection and Response*, slides
/// "Sphere-Plane Collision" and "The Collision Point"
template <std::floating_point S>
std::optional<MovingSphereHit<S>> moving_sphere_plane(const Sphere<S>& sphere,
                                                      const Vector3<S>& displacement,
                                                      const Plane<S>& plane) {
  const auto [distance, change, radius] = detail::approach(sphere, displacement, plane);
  const bool front = distance > S(0) || (distance == S(0) && change <= S(0));
  const Vector3<S> normal = front ? plane.normal : Vector3<S>(-plane.normal);
  const S gap = (front ? distance : -distance) - radius;
  const S closing = front ? -change : change;
  if (gap <= S(0)) {  // already touching
    const Vector3<S> point = sphere.centre - signed_distance(plane, sphere.centre) * plane.normal;
    return MovingSphereHit<S>{S(0), sphere.centre, point, normal};
  }
  if (gap > closing) return std::nullopt;  // at rest, going along or away, or too slow to arrive
  const S t = gap / closing;
  const Vector3<S> centre = sphere.centre + t * displacement;
  return MovingSphereHit<S>{t, centre, centre - sphere.radius * normal, normal};
}
// [/moving-sphere-plane]

}  // namespace contact
