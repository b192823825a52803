/// @file
/// The swept volume of a moving sphere in a step: a capsule.
#pragma once

#include <concepts>

#include <contact/entry_time.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/shapes.hpp>
#include <contact/sphere_capsule_impact.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Whether the segments from 0 to u and from d to d + v have points at most `radius_sum` apart.
///
/// The squared distance of two of their points is a convex quadratic over a square of parameters.
/// Its minimum is on the boundary of the square, where an end of one segment is closest to the
/// other, or inside, at the common perpendicular of both lines.
inline bool segments_within(const Vector3<Exact>& d, const Vector3<Exact>& u,
                            const Vector3<Exact>& v, const Exact& radius_sum) {
  const Vector3<Exact> none = Vector3<Exact>::Zero();
  const auto end_meets = [&](const Vector3<Exact>& end, const Vector3<Exact>& segment) {
    return CapsuleQuestion{end, none, segment, radius_sum}.meets_at_start();
  };
  if (end_meets(d, u) || end_meets(d + v, u)) return true;
  if (end_meets(-d, v) || end_meets(u - d, v)) return true;
  const Vector3<Exact> across = u.cross(v);
  const Exact determinant = across.dot(across);
  if (determinant.sign() == 0) return false;
  const Exact on_u = d.cross(v).dot(across);
  const Exact on_v = d.cross(u).dot(across);
  if (on_u.sign() < 0 || determinant < on_u || on_v.sign() < 0 || determinant < on_v) return false;
  const Exact apart = d.dot(across);
  return (apart * apart - radius_sum * radius_sum * determinant).sign() <= 0;
}

}  // namespace detail

// [swept-volumes]
/// Whether the volumes that two spheres sweep in a step have a point in common.
///
/// If not, the spheres do not touch in the step. If so, they may: one can have left before the
/// other arrives. Swept volumes ignore time; sphere_sphere_impact(), which uses the relative
/// motion, does not. They are enough where one of the spheres is at rest: it is at each of its
/// positions at all times, so the other touches it where their volumes meet. In the relative motion
/// that is always so.
/// @param a, b at the start, m, finite, with radii that are not negative
/// @param displacement_a, displacement_b in the step, m, finite
/// @return right for every finite input; touching counts
/// @see *Interaction and Normals*, slide "Collision detection: swept volume"
template <std::floating_point S>
bool swept_spheres_meet(const Sphere<S>& a, const Vector3<S>& displacement_a, const Sphere<S>& b,
                        const Vector3<S>& displacement_b) {
  return detail::segments_within(exact_vector_difference(b.centre, a.centre),
                                 exact_vector(displacement_a), exact_vector(displacement_b),
                                 Exact(double(a.radius)) + Exact(double(b.radius)));
}
// [/swept-volumes]

}  // namespace contact
