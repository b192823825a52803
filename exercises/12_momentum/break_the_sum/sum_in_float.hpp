/// @file
/// Code to break: a sum of impulses.
#pragma once

#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The sum of all impulses, in N s, added in the order of the list in single precision, as physics
/// engines add them.
inline double sum_in_float(const std::vector<double>& impulses) {
  float sum = 0;
  for (const double impulse : impulses) sum += static_cast<float>(impulse);
  return static_cast<double>(sum);
}

}  // namespace given
