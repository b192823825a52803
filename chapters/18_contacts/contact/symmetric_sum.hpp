/// @file
/// A sum that depends neither on the order of its terms nor on a reversal of all signs.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/vector.hpp>

namespace contact {

// [symmetric-sum]
/// The sum of numbers, the same in every order to the last bit, and exactly reversed if all terms
/// are: a mirror-symmetric list of impulses has a mirror-symmetric sum.
///
/// Each term is split at a unit that depends on the largest term and the count only (Rump, Ogita
/// and Oishi 2008; Demmel and Nguyen 2015). The leading parts are multiples of the unit whose sum
/// has at most as many bits as S, so no addition of them rounds, in any order. The remainders,
/// which are exact, are split once more, and the rest is dropped. Only the last addition rounds.
/// The splitter is 1.5 times a power of two: both sides of it have the same spacing, and its last
/// bit is even, so splitting −x gives −1 times the parts of x.
/// @param terms up to 2^20. Recursive summation, in their order, if one is not finite or the sum of
/// their magnitudes may overflow
/// @return off by at most u of the sum plus 64 n³ u² of the largest term; 0 for no terms
template <std::floating_point S>
S symmetric_sum(const std::vector<S>& terms) {
  S largest(0);
  bool finite = true;
  for (const S& x : terms) {
    finite = finite && std::isfinite(x);
    largest = std::max(largest, std::abs(x));
  }
  S sums[2] = {S(0), S(0)};
  int exponent = 0;  // of a bound on n times the largest remainder
  std::frexp(largest, &exponent);
  int count_exponent = 0;
  std::frexp(S(terms.size()), &count_exponent);
  exponent += count_exponent;
  if (terms.size() < 3 || !finite || exponent + 2 > std::numeric_limits<S>::max_exponent) {
    for (const S& x : terms) sums[0] += x;
    return sums[0];
  }
  const S first = std::ldexp(S(1.5), exponent + 1);
  const S second =
      std::ldexp(S(1.5), exponent + 1 + count_exponent - (std::numeric_limits<S>::digits - 1));
  for (const S& x : terms) {
    const S leading = (first + x) - first;
    sums[0] += leading;
    sums[1] += (second + (x - leading)) - second;
  }
  return sums[0] + sums[1];
}
// [/symmetric-sum]

/// The same of vectors, component by component.
template <std::floating_point S>
Vector3<S> symmetric_vector_sum(const std::vector<Vector3<S>>& terms) {
  Vector3<S> sum;
  std::vector<S> components(terms.size());
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < terms.size(); ++i) components[i] = terms[i](k);
    sum(k) = symmetric_sum(components);
  }
  return sum;
}

}  // namespace contact
