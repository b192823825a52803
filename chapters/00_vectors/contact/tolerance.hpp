/// @file
/// Every tolerance of the book, each with its meaning.
///
/// @warning None of these decides a question of geometry. "Is it on the plane?" has an exact answer
/// for the stored numbers; a change to a tolerance changes bounds on rounding, but not the meaning
/// of touching.
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

/// γ(n) = n u / (1 − n u): the bound on the relative error of n successive roundings (Higham,
/// *Accuracy and Stability of Numerical Algorithms*, 2nd edition, lemma 3.1).
/// @param n how many roundings; n u must be far below 1
template <std::floating_point S>
constexpr S gamma(int n) {
  return S(n) * unit_roundoff<S> / (S(1) - S(n) * unit_roundoff<S>);
}

/// The largest deviation from 1 of the squared length of a stored unit normal. Normalising takes at
/// most the equivalent of four successive roundings (square, two sums, root, quotient; the root
/// halves the errors before it), so |n|² is off by less than 8 u; the factor 16 leaves room for a
/// normal that has been rotated once. For an assertion only: a longer normal scales every distance.
template <std::floating_point S>
inline constexpr S unit_normal = S(16) * unit_roundoff<S>;

}  // namespace contact::tolerance
