/// @file
/// A sphere that moves in a straight line against a plane at rest: the offset plane.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include <contact/plane.hpp>
#include <contact/shapes.hpp>

namespace contact {

/// The first contact of a moving sphere.
template <Ring S>
struct MovingSphereHit {
  S t = S(0);  ///< fraction of the displacement at the contact, from 0 to 1
  Vector3<S> centre = Vector3<S>::Zero();  ///< of the sphere at that time, m
  Vector3<S> point = Vector3<S>::Zero();   ///< the contact point, on the plane itself, m
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector from the plane to the sphere
};

namespace detail {

/// The distance at the start and its change over the whole displacement; both, and the radius, are
/// divided by 8 if one of them would overflow.
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

/// When and where a moving sphere first touches a plane.
///
/// At the first contact the distance of the centre is r, so the centre is tested against the plane
/// moved by r towards it. The sign s of the distance d at the *start* gives the direction. With the
/// displacement D: gap = s d − r, closing = −s n·D, and t = gap / closing.
///
/// This holds for an infinite plane. The set of centres of spheres that touch a *polygon* is not
/// only the offset polygon: it has a cylinder of radius r around each edge and a sphere of radius r
/// around each vertex.
/// @param sphere at the start, m, with a radius that is not negative
/// @param displacement of the centre during the step (velocity × time step), m
/// @param plane with a unit normal
/// @return the first contact. A sphere that meets the plane at the start touches at t = 0, whatever
/// its displacement. Nothing if it starts clear of the plane and is at rest, moves along the plane
/// or away from it, or does not reach it. If the centre starts exactly on the plane, the normal is
/// the one opposed to the motion (the plane's own if the motion is along it).
/// @note In a floating-point type, t has an error of about 8 u (Σ|nᵢ cᵢ| + |k| + r + t Σ|nᵢ Dᵢ|) /
/// closing.
/// @see *Fundamentals of Computer Animation: Collision Detection and Response*, slides
/// "Sphere-Plane Collision" and "The Collision Point"
// [moving-sphere-plane]
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
  if (gap > closing) return std::nullopt;  // at rest, moving along or away, or too slow
  const S t = gap / closing;
  const Vector3<S> centre = sphere.centre + t * displacement;
  return MovingSphereHit<S>{t, centre, centre - sphere.radius * normal, normal};
}
// [/moving-sphere-plane]

}  // namespace contact
