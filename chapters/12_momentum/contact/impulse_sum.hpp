/// @file
/// Sums of many impulses: five methods that differ in the error of a small total.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/exact.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Up to this many terms a pairwise sum is recursive.
inline constexpr std::size_t pairwise_block = 8;

template <Ring S>
S recursive_sum(const S* terms, std::size_t count) {
  S sum(0);
  for (std::size_t i = 0; i < count; ++i) sum = sum + terms[i];
  return sum;
}

template <Ring S>
S pairwise(const S* terms, std::size_t count) {
  if (count <= pairwise_block) return recursive_sum(terms, count);
  const std::size_t half = count / 2;
  return pairwise(terms, half) + pairwise(terms + half, count - half);
}

// [compensated]
/// The sum, corrected at the end by the sum of the rounding errors.
template <std::floating_point S>
S compensated(const S* terms, std::size_t count) {
  S sum(0);
  S lost(0);
  for (std::size_t i = 0; i < count; ++i) {
    const S x = terms[i];
    const S next = sum + x;
    // The smaller of the two loses digits. Both differences are exact.
    lost += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }
  return sum + lost;
}
// [/compensated]

/// The sum, with the rounding error of each addition subtracted from the next term.
template <std::floating_point S>
S kahan(const S* terms, std::size_t count) {
  S sum(0);
  S over(0);
  for (std::size_t i = 0; i < count; ++i) {
    const S x = terms[i] - over;
    const S next = sum + x;
    over = (next - sum) - x;
    sum = next;
  }
  return sum;
}

template <std::floating_point S>
bool every_term_is_finite(const std::vector<S>& terms) {
  return std::all_of(terms.begin(), terms.end(), [](const S& x) { return std::isfinite(x); });
}

/// The result of a method; if an intermediate sum overflowed, the terms are scaled down by a power
/// of two of more than twice their number, and the result is scaled back.
template <std::floating_point S, class Sum>
S without_overflow(const std::vector<S>& terms, Sum sum) {
  const S plain = sum(terms.data(), terms.size());
  if (std::isfinite(plain)) return plain;
  const int power = static_cast<int>(std::bit_width(terms.size())) + 1;
  std::vector<S> smaller(terms);
  for (S& x : smaller) x = std::ldexp(x, -power);
  return std::ldexp(sum(smaller.data(), smaller.size()), power);
}

}  // namespace detail

// [in-order]
/// The sum of impulses (or of other numbers of one unit) by recursive summation, in the order
/// given.
///
/// The error is at most γ(n − 1) Σ|Jᵢ| for n terms: small compared with the total if all terms have
/// one sign, and possibly larger than the total if they cancel. Exact if S is exact.
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition, section 4.2
template <Ring S>
S total_recursive(const std::vector<S>& terms) {
  if constexpr (std::floating_point<S>) {
    return detail::without_overflow(terms, detail::recursive_sum<S>);
  } else {
    return detail::recursive_sum(terms.data(), terms.size());
  }
}
// [/in-order]

// [pairwise]
/// The sum of impulses by pairwise summation.
///
/// Each term goes through about log₂ n additions instead of n, so the error is at most
/// γ(⌈log₂ n⌉ + 4) Σ|Jᵢ|. It costs no more than recursive summation. Exact if S is exact.
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Higham, section 4.1
template <Ring S>
S total_pairwise(const std::vector<S>& terms) {
  if constexpr (std::floating_point<S>) {
    return detail::without_overflow(terms, detail::pairwise<S>);
  } else {
    return detail::pairwise(terms.data(), terms.size());
  }
}
// [/pairwise]

/// The sum of impulses by compensated summation: the rounding error of each addition is computed,
/// and their sum is added at the end (Neumaier's form of Kahan's sum).
///
/// The error is at most u |ΣJᵢ| + γ(n − 1)² Σ|Jᵢ|, as if computed with twice the digits and then
/// rounded. So the result has right digits for totals down to about n² u² Σ|Jᵢ|.
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Neumaier, *Zeitschrift für Angewandte Mathematik und Mechanik* 54 (1974); the bound is that
/// of Ogita, Rump and Oishi, *SIAM Journal on Scientific Computing* 26 (2005), proposition 4.5
template <std::floating_point S>
S total_compensated(const std::vector<S>& terms) {
  return detail::without_overflow(terms, detail::compensated<S>);
}

/// Kahan's sum, the older form of compensated summation: the rounding error of an addition is
/// passed to the next term, and is lost if that term is much larger.
///
/// The error is at most (2 u + O(n u²)) Σ|Jᵢ|: much better than recursive summation, but not small
/// compared with a total whose terms cancel. For comparison; prefer total_compensated().
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Kahan, *Communications of the ACM* 8 (1965); Higham, section 4.3
template <std::floating_point S>
S total_kahan(const std::vector<S>& terms) {
  return detail::without_overflow(terms, detail::kahan<S>);
}

// [exactly]
/// The exact sum of impulses, rounded once to the nearest number.
/// @param terms finite, N·s; if one is not, the result is the recursive sum
/// @return N·s; 0 for no terms; ±∞ if the true sum is beyond the largest number
template <std::floating_point S>
S total_exactly(const std::vector<S>& terms) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  if (!detail::every_term_is_finite(terms))
    return detail::recursive_sum(terms.data(), terms.size());
  Exact sum;
  for (const S& x : terms) sum += Exact(double(x));
  return rounded<S>(sum);
}
// [/exactly]

// [total-impulse]
/// The sum of impulses with an error of at most 3 u of itself, however much cancels.
///
/// The compensated sum has an error of at most u |ΣJᵢ| + γ(n)² Σ|Jᵢ|. If the second term is below
/// u |sum|, the compensated sum is returned; otherwise too much has cancelled, and the sum is
/// computed again without rounding.
/// @param terms finite, N·s
/// @return N·s; 0 if the true sum is 0 (or there are no terms), and only then
template <std::floating_point S>
S total_impulse(const std::vector<S>& terms) {
  const std::size_t n = terms.size();
  const S sum = detail::compensated(terms.data(), n);
  S size(0);
  for (const S& x : terms) size += std::abs(x);
  const S u = tolerance::unit_roundoff<S>;
  // γ(n) < 1.1 n u for n u < 1/16. The size is itself a recursive sum, with a smaller relative
  // error than that.
  const S share = S(n) * u;
  const S uncertain = S(1.5) * share * share * size;
  if (std::isfinite(size) && share < S(0.0625) && uncertain <= u * std::abs(sum)) return sum;
  return total_exactly(terms);
}
// [/total-impulse]

}  // namespace contact
