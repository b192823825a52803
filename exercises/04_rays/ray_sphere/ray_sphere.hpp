/// @file
/// Exercise: the part of a ray that is in a ball.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The points origin + t·direction with entry ≤ t ≤ exit.
struct Inside {
  double entry;  ///< in multiples of the direction as given; 0 if the ray starts in the ball
  double exit;   ///< the same, not less than entry
};

/// The part of the ray that is in the sphere, which is a solid ball. Nothing, if the ray misses it.
///
/// - Touching counts: then entry and exit are equal. The same holds for a ray that starts on the
///   sphere and leads away from it: both are 0. Rounding may turn a touch into a miss or a
///   crossing, so the tests ask for it only with whole numbers of at most 100, and a ray that
///   starts on the sphere or whose direction is a power of two along one axis.
/// - The ball may be far away. If the line passes the centre at 3/4 of the radius or nearer, or at
///   5/4 or further, the answer must be right for a distance of up to 10⁹ radii.
/// - If origin, centre and radius are whole numbers of at most 10⁶, the radius is positive, and the
///   line passes the centre at 3/4 of the radius or nearer, then entry and exit have nine correct
///   digits, also if they are small.
///
/// @param ray origin in m; direction of any length but not zero, in m for each unit of t
/// @param sphere centre and radius in m; the radius may be 0
std::optional<Inside> ray_sphere(const contact::Ray<double>& ray,
                                 const contact::Sphere<double>& sphere);

}  // namespace exercise
