/// @file
/// Every tolerance of the book, in one place, each with what it means.
///
/// @warning None of these decides a question of geometry. "Is it on the plane?" has an exact answer
/// for the numbers that are stored; moving a tolerance here moves bounds on rounding, and never
/// what touching means.
#pragma once

#include <concepts>
#include <limits>

namespace contact::tolerance {

/// Unit roundoff u: one rounded +, −, ×, ÷ or √ is off by at most u times its result (when it does
/// not underflow). 2^-24 for float, 2^-53 for double.
template <std::floating_point S>
inline constexpr S unit_roundoff = std::numeric_limits<S>::epsilon() / S(2);

/// The smallest positive number of the type, η: one rounded × or ÷ that underflows is off by at
/// most η / 2. Sums and differences never underflow with an error.
template <std::floating_point S>
inline constexpr S underflow_unit = std::numeric_limits<S>::denorm_min();

/// γ(n) = n u / (1 − n u): the factor that bounds n roundings in a row (Higham, *Accuracy and
/// Stability of Numerical Algorithms*, 2nd edition, lemma 3.1).
/// @param n how many roundings; n u must be far below 1
template <std::floating_point S>
constexpr S gamma(int n) {
  return S(n) * unit_roundoff<S> / (S(1) - S(n) * unit_roundoff<S>);
}

/// How far the squared length of a stored unit normal may be from 1. Normalising costs four
/// roundings in a row at most (square, two sums, root, quotient, with the root halving what comes
/// before it), so |n|² is off by less than 8 u; the factor 16 leaves room for a normal that has
/// been rotated once. For an assertion only: a longer normal scales every distance.
template <std::floating_point S>
inline constexpr S unit_normal = S(16) * unit_roundoff<S>;

}  // namespace contact::tolerance
