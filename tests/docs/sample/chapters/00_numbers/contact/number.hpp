/// @file
/// A scalar, and nothing else.
#pragma once

#include <concepts>

namespace contact {

/// A number that can be added.
template <class T>
concept Number = std::floating_point<T>;

/// Twice a number.
/// @param x any number
template <Number T>
T twice(T x) {
  return x + x;
}

}  // namespace contact
