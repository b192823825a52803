/// @file
/// Exercise: what does the ray hit first?
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Which triangle of a list is hit, and where on the ray.
struct FirstHit {
  int index = 0;  ///< the first triangle of the list has index 0
  double t = 0;   ///< in lengths of the direction as given, not negative
};

/// The triangle that the ray meets first, or nothing if it meets none.
///
/// What counts as meeting one triangle is as in the exercise before: touching counts, both sides
/// count, and a parallel ray, a direction of length zero and a triangle without area give nothing.
/// If several triangles are met at the same t, it is the one that stands first in the list.
std::optional<FirstHit> first_hit(const contact::Ray<double>& ray,
                                  const std::vector<contact::Triangle<double>>& triangles);

}  // namespace exercise
