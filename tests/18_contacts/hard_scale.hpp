/// @file
/// Hard cases of extreme sizes say what their lengths are measured in.
#pragma once

#include "support/hard_cases.hpp"

namespace hard_scale {

/// The field "length": the size of the bodies, m; 1 if a case has none.
inline double unit_of_length(const hard_cases::Case& c) {
  return c.has("length") ? c.number("length") : 1.0;
}

}  // namespace hard_scale
