/// @file
/// Scalars, vectors and matrices: the types that every other header uses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <concepts>
#include <type_traits>

namespace contact {

/// A number with +, −, × and an order: enough for every predicate that is polynomial in its input.
///
/// float, double and long double are such numbers (rounded), and so are exact types. Integers are
/// excluded on purpose: they overflow silently. An exact type that is used inside a vector must
/// also specialise `Eigen::NumTraits`.
template <class S>
concept Ring = !std::integral<S> && std::regular<S> && std::totally_ordered<S> &&
               std::constructible_from<S, int> && requires(const S a, const S b) {
  { a + b } -> std::convertible_to<S>;
  { a - b } -> std::convertible_to<S>;
  { a* b } -> std::convertible_to<S>;
  { -a } -> std::convertible_to<S>;
};

/// A Ring that can also divide: float, double, long double, or an exact field such as the
/// rationals.
///
/// A function that needs a square root finds `sqrt` by argument-dependent lookup, so it compiles
/// for the floating-point types and for multiple-precision floats, and not for the rationals.
template <class S>
concept Scalar = Ring<S> && requires(const S a, const S b) {
  { a / b } -> std::convertible_to<S>;
};

/// A column of two coordinates, x and y.
template <Ring S>
using Vector2 = Eigen::Matrix<S, 2, 1>;

/// A column of three coordinates, x, y and z, in a right-handed frame.
template <Ring S>
using Vector3 = Eigen::Matrix<S, 3, 1>;

/// Three rows of three numbers.
template <Ring S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

/// Whether x is a number: neither NaN nor an infinity. Always true for an exact type.
template <Ring S>
bool is_finite(const S& x) {
  if constexpr (std::floating_point<S>) {
    return std::isfinite(x);
  } else {
    return true;
  }
}

/// Whether every entry of v is finite.
/// @param v any dense Eigen vector or matrix
template <class Derived>
bool all_finite(const Eigen::DenseBase<Derived>& v) {
  for (Eigen::Index column = 0; column < v.cols(); ++column) {
    for (Eigen::Index row = 0; row < v.rows(); ++row) {
      const typename Derived::Scalar entry = v.derived().coeff(row, column);
      if (!is_finite(entry)) return false;
    }
  }
  return true;
}

}  // namespace contact
