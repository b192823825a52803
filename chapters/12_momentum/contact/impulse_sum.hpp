/// @file
/// Adding up many impulses: five ways that differ in what rounding leaves of a small total.
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

/// How many terms a pairwise sum adds in order before it splits no further.
inline constexpr std::size_t pairwise_block = 8;

template <Ring S>
S in_order(const S* terms, std::size_t count) {
  S sum(0);
  for (std::size_t i = 0; i < count; ++i) sum = sum + terms[i];
  return sum;
}

template <Ring S>
S pairwise(const S* terms, std::size_t count) {
  if (count <= pairwise_block) return in_order(terms, count);
  const std::size_t half = count / 2;
  return pairwise(terms, half) + pairwise(terms + half, count - half);
}

// [compensated]
/// The sum, and beside it the sum of what each addition cut off.
template <std::floating_point S>
S compensated(const S* terms, std::size_t count) {
  S sum(0);
  S lost(0);
  for (std::size_t i = 0; i < count; ++i) {
    const S x = terms[i];
    const S next = sum + x;
    // The smaller of the two loses its last digits. Both differences are exact.
    lost += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }
  return sum + lost;
}
// [/compensated]

/// The sum, with what each addition cut off taken from the next term.
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

/// The result of a way of summing; if a sum overflowed on the way, that of the terms divided by a
/// power of two that is more than twice their number, multiplied back.
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
/// The sum of impulses (or of anything else in one unit), added in the order given.
///
/// Off by at most γ(n − 1) Σ|Jᵢ| for n terms: nothing to worry about when all push the same way,
/// and everything that is left when they cancel. Exact if S is exact.
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition, section 4.2
template <Ring S>
S total_in_order(const std::vector<S>& terms) {
  if constexpr (std::floating_point<S>) {
    return detail::without_overflow(terms, detail::in_order<S>);
  } else {
    return detail::in_order(terms.data(), terms.size());
  }
}
// [/in-order]

// [pairwise]
/// The sum of impulses, added half by half.
///
/// Each term goes through about log₂ n additions in place of n, so the sum is off by at most
/// γ(⌈log₂ n⌉ + 4) Σ|Jᵢ|. It costs no more than adding in order. Exact if S is exact.
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

/// The sum of impulses with the digits that each addition cuts off kept and added at the end
/// (Neumaier's form of Kahan's compensated sum).
///
/// Off by at most u |ΣJᵢ| + γ(n − 1)² Σ|Jᵢ|: as if it had been computed with twice the digits and
/// then rounded. So it is good down to totals of about n² u² Σ|Jᵢ|, and not beyond.
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Neumaier, *Zeitschrift für Angewandte Mathematik und Mechanik* 54 (1974); the bound is that
/// of Ogita, Rump and Oishi, *SIAM Journal on Scientific Computing* 26 (2005), proposition 4.5
template <std::floating_point S>
S total_compensated(const std::vector<S>& terms) {
  return detail::without_overflow(terms, detail::compensated<S>);
}

/// Kahan's sum, the older form of the compensated one: what an addition cuts off is handed to the
/// next term. Where that is so large that it vanishes in it, it is lost.
///
/// Off by at most (2 u + O(n u²)) Σ|Jᵢ|: far better than in order, and no better than the sizes of
/// the terms allow if they cancel. Here to be compared; prefer total_compensated().
/// @param terms finite, N·s
/// @return N·s; 0 for no terms; ±∞ only if the true sum is about as large as that
/// @see Kahan, *Communications of the ACM* 8 (1965); Higham, section 4.3
template <std::floating_point S>
S total_kahan(const std::vector<S>& terms) {
  return detail::without_overflow(terms, detail::kahan<S>);
}

// [exactly]
/// The sum of impulses without rounding, until it is rounded once, to the nearest number.
/// @param terms finite, N·s; if one is not, the rounded sum in order
/// @return N·s; 0 for no terms; ±∞ if the true sum is beyond the largest number
template <std::floating_point S>
S total_exactly(const std::vector<S>& terms) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  if (!detail::every_term_is_finite(terms)) return detail::in_order(terms.data(), terms.size());
  Exact sum;
  for (const S& x : terms) sum += Exact(double(x));
  return rounded<S>(sum);
}
// [/exactly]

// [total-impulse]
/// The sum of impulses, never off by more than 3 u of itself, whatever cancels.
///
/// The compensated sum has an error of at most u |ΣJᵢ| + γ(n)² Σ|Jᵢ|. If the second part is below
/// u |sum| it is returned; if not, too much has cancelled, and the sum is computed again without
/// rounding.
/// @param terms finite, N·s
/// @return N·s; 0 if the true sum is 0 (or there are no terms), and only then
template <std::floating_point S>
S total_impulse(const std::vector<S>& terms) {
  const std::size_t n = terms.size();
  const S sum = detail::compensated(terms.data(), n);
  S size(0);
  for (const S& x : terms) size += std::abs(x);
  const S u = tolerance::unit_roundoff<S>;
  // γ(n) < 1.1 n u for n u < 1/16. The size is itself a sum in order, and off by less than as much.
  const S share = S(n) * u;
  const S uncertain = S(1.5) * share * share * size;
  if (std::isfinite(size) && share < S(0.0625) && uncertain <= u * std::abs(sum)) return sum;
  return total_exactly(terms);
}
// [/total-impulse]

}  // namespace contact
