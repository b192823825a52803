/// @file
/// A line in the plane.
#pragma once

#include <contact/number.hpp>

namespace contact {

// [line]
/// A line a x + b y = c, in metres.
template <Number T>
struct Line {
  /// The first coefficient.
  T a;
  // [second]
  /// The second coefficient.
  T b;
  // [/second]
  /// The offset.
  T c;
};
// [/line]

/// The value a x + b y − c: its sign is the side of the point.
/// @param line any line
template <Number T>
T side(const Line<T>& line, T x, T y) {
  return line.a * x + line.b * y - line.c;
}

}  // namespace contact
