/// @file
/// The range of sizes and coordinates that constructions of shapes accept.
#pragma once

#include <concepts>
#include <limits>

#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The largest coordinate, and the inverse of the smallest size, that the constructions of shapes
/// accept: 2^250 for double and long double, 2^25 for float. In this range no product of a distance
/// or a separation test overflows.
template <std::floating_point S>
inline constexpr S furthest_coordinate = std::numeric_limits<S>::digits > 24 ? S(0x1p250)
                                                                             : S(0x1p25);

namespace detail {

/// Throws unless x is a size in range: finite, not negative, and greater than 0 if `positive`.
template <std::floating_point S>
void require_extent(const char* argument, const S& x, bool positive) {
  require_finite(argument, x);
  if (x < S(0) || (positive && !(x > S(0)))) {
    throw_invalid_argument(argument, number_text(x),
                           positive ? "must be greater than 0" : "must not be negative");
  }
  if (x > furthest_coordinate<S> || (x > S(0) && x < S(1) / furthest_coordinate<S>)) {
    throw_invalid_argument(argument, number_text(x), "is out of range");
  }
}

/// Throws unless all coordinates of x are in range.
template <std::floating_point S>
void require_position(const char* argument, const Vector3<S>& x) {
  require_finite(argument, x);
  if (x.cwiseAbs().maxCoeff() > furthest_coordinate<S>) {
    throw_invalid_argument(argument, vector_text(x), "is out of range");
  }
}

}  // namespace detail

}  // namespace contact
