/// @file
/// Exercise: the first triangle that a ray hits.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The triangle of a list that is hit, and the parameter on the ray.
struct FirstHit {
  int index = 0;  ///< the first triangle of the list has index 0
  double t = 0;   ///< in multiples of the direction as given, not negative
};

/// The triangle that the ray meets first, or nothing if it meets none.
///
/// A hit of one triangle is defined as in the exercise `ray_triangle`: touching counts, both sides
/// count, and a parallel ray, a zero direction and a triangle without area give nothing. If several
/// triangles are hit at the same t, it is the one that is first in the list.
std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles);

}  // namespace exercise
