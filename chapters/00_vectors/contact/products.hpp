/// @file
/// Dot and cross products: by definition, compensated, and exact.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/error_free.hpp>
#include <contact/exact.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [dot-in-order]
/// u · v = Σ uᵢ vᵢ by recursive summation. With v = (1, 1, ...) it is the sum of u.
///
/// Off by at most γ(n) Σ|uᵢ vᵢ| for n coordinates, plus half the smallest positive number for each
/// product that underflows. The bound is relative to the *terms*: when they cancel, no digit of u ·
/// v need be right, nor its sign. Exact if S is exact.
/// @param u n coordinates
/// @param v as many
/// @return in the unit of u times that of v; 0 for no coordinates
///
/// Source: Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition, section 3.1.
template <Ring S, int N>
S dot_recursive(const Eigen::Matrix<S, N, 1>& u, const Eigen::Matrix<S, N, 1>& v) {
  S sum(0);
  for (Eigen::Index i = 0; i < u.size(); ++i) sum = sum + u[i] * v[i];
  return sum;
}
// [/dot-in-order]

// [dot-compensated]
/// u · v with the rounding errors of all products and sums added at the end.
///
/// Off by at most u |u · v| + γ(n)² Σ|uᵢ vᵢ| (with u the unit roundoff), as if it had been computed
/// with twice the digits and rounded once. So it is inaccurate only where all digits of the type
/// have cancelled.
///
/// Limits: no product or sum overflows; a product that underflows costs up to the smallest positive
/// number.
///
/// Source: Ogita, Rump and Oishi (2005), algorithm 5.3 and proposition 5.5.
template <std::floating_point S, int N>
S dot_compensated(const Eigen::Matrix<S, N, 1>& u, const Eigen::Matrix<S, N, 1>& v) {
  S sum(0);
  S lost(0);
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const WithError<S> product = two_product(u[i], v[i]);
    const WithError<S> next = two_sum(sum, product.value);
    lost += product.error + next.error;
    sum = next.value;
  }
  return sum + lost;
}
// [/dot-compensated]

/// u · v computed exactly and rounded once, to the nearest number.
/// @param u n finite coordinates
/// @param v as many
/// @return ±∞ if the true value is beyond the largest number; 0 if it is 0, or nearer to 0 than to
/// any other number
template <std::floating_point S, int N>
S dot_exactly(const Eigen::Matrix<S, N, 1>& u, const Eigen::Matrix<S, N, 1>& v) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  Exact sum;
  for (Eigen::Index i = 0; i < u.size(); ++i) sum += Exact(double(u[i])) * Exact(double(v[i]));
  return rounded<S>(sum);
}

/// a b − c d with a relative error of at most 2 u.
///
/// The first fused multiply-add finds the rounding error of the product c d, the second subtracts
/// the rounded product from a b without rounding a b; then the error is added.
///
/// Limits: each product is 0 because a factor is, or is far enough from the ends of the number
/// range (`product_keeps_its_digits`).
///
/// Source: Kahan; the bound is that of Jeannerod, Louvet and Muller, *Further analysis of Kahan's
/// algorithm for the accurate computation of 2 × 2 determinants*, Mathematics of Computation 82
/// (2013).
// [difference-of-products]
template <std::floating_point S>
S difference_of_products(S a, S b, S c, S d) {
  const S cd = c * d;
  const S lost = std::fma(-c, d, cd);  // cd − c d
  return std::fma(a, b, -cd) + lost;
}
// [/difference-of-products]

/// Whether a b is 0 because a factor is, or so far inside the number range that neither it nor its
/// rounding error over- or underflows.
template <std::floating_point S>
bool product_keeps_its_digits(S a, S b) {
  using Limits = std::numeric_limits<S>;
  if (a == S(0) || b == S(0)) return true;
  const S size = std::abs(a * b);
  return size <= Limits::max() / S(4) &&
         size >= std::ldexp(S(1), Limits::min_exponent + 2 * Limits::digits);
}

// [dot-accurately]
/// u · v with a relative error of at most 3 u (u the unit roundoff), whatever cancels; a subnormal
/// result is the nearest number.
///
/// Two products are a difference of products. For more, this is a floating-point filter: the
/// compensated value is returned if its error bound is small enough. Otherwise the product is
/// computed again exactly, which is slow.
/// @param u n finite coordinates, n u < 1/16
/// @param v as many
template <std::floating_point S, int N>
S dot_accurately(const Eigen::Matrix<S, N, 1>& u, const Eigen::Matrix<S, N, 1>& v) {
  if (u.size() == 2 && product_keeps_its_digits(u[0], v[0]) &&
      product_keeps_its_digits(u[1], v[1])) {
    return difference_of_products(u[0], v[0], -u[1], v[1]);
  }
  const S sum = dot_compensated(u, v);
  S size(0);
  for (Eigen::Index i = 0; i < u.size(); ++i) size += std::abs(u[i] * v[i]);
  const S unit = tolerance::unit_roundoff<S>;
  const S share = S(u.size()) * unit;
  // γ(n) < 1.1 n u, and the size is off by less than as much. Then what may have underflowed.
  const S uncertain =
      S(1.5) * share * share * size + S(2 * u.size()) * tolerance::underflow_unit<S>;
  if (std::isfinite(size) && std::isfinite(sum) && share < S(0.0625) &&
      uncertain <= unit * std::abs(sum)) {
    return sum;
  }
  return dot_exactly(u, v);
}
// [/dot-accurately]

/// a b − c d computed exactly and rounded once.
template <std::floating_point S>
S difference_of_products_exactly(S a, S b, S c, S d) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  return rounded<S>(Exact(double(a)) * Exact(double(b)) - Exact(double(c)) * Exact(double(d)));
}

/// u × v by its definition: two products and a difference for each coordinate.
///
/// Each coordinate is off by at most γ(2) (|product| + |product|), plus the smallest positive
/// number. This is small relative to |u||v|, but not relative to u × v when u and v are nearly
/// parallel. A product that overflows makes ∞ or NaN. Exact if S is exact.
// [cross-in-order]
template <Ring S>
Vector3<S> cross_plain(const Vector3<S>& u, const Vector3<S>& v) {
  return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
          u.x() * v.y() - u.y() * v.x()};
}
// [/cross-in-order]

// [cross-accurately]
/// u × v, each coordinate with a relative error of at most 2 u (u the unit roundoff), so that only
/// parallel vectors give 0; a subnormal coordinate is the nearest number.
///
/// Where a product would over- or underflow, the coordinate is computed exactly. That is slow and
/// rare.
/// @param u finite
/// @param v finite
/// @return in the unit of u times that of v; ±∞ where a coordinate is beyond the largest number
template <std::floating_point S>
Vector3<S> cross_accurately(const Vector3<S>& u, const Vector3<S>& v) {
  const auto coordinate = [](S a, S b, S c, S d) {
    if (product_keeps_its_digits(a, b) && product_keeps_its_digits(c, d)) {
      return difference_of_products(a, b, c, d);
    }
    return difference_of_products_exactly(a, b, c, d);
  };
  return {coordinate(u.y(), v.z(), u.z(), v.y()), coordinate(u.z(), v.x(), u.x(), v.z()),
          coordinate(u.x(), v.y(), u.y(), v.x())};
}
// [/cross-accurately]

/// u × v computed exactly; each coordinate is rounded once.
template <std::floating_point S>
Vector3<S> cross_exactly(const Vector3<S>& u, const Vector3<S>& v) {
  return {difference_of_products_exactly(u.y(), v.z(), u.z(), v.y()),
          difference_of_products_exactly(u.z(), v.x(), u.x(), v.z()),
          difference_of_products_exactly(u.x(), v.y(), u.y(), v.x())};
}

}  // namespace contact
