/// @file
/// Code to break: a row of equal balls that touch.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The velocities of equal elastic balls that touch, in m/s, when no neighbours approach any more.
///
/// In one pass over the contacts each pair that approaches collides, as some physics engines do it.
/// @param velocities from left to right; to the right is positive
inline std::vector<double> one_pass(std::vector<double> velocities) {
  for (std::size_t i = 0; i + 1 < velocities.size(); ++i) {
    if (velocities[i] > velocities[i + 1]) std::swap(velocities[i], velocities[i + 1]);
  }
  return velocities;
}

}  // namespace given
