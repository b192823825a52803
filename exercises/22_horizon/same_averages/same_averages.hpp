/// @file
/// Exercise: whether two samples of an average agree.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// What two samples say about two averages.
enum class Comparison {
  too_few,  ///< a sample has fewer than two values, so its spread is unknown
  agree,    ///< the means differ by at most the limit
  differ    ///< the means differ by more than the limit
};

/// Compares the means of two independent samples, for example of the hits per second that each run
/// of two programs counted. The values of a sample are from independent runs.
///
/// They differ if the distance of the means is more than `limit` standard errors of the difference
/// of the two means, and agree if it is as much or less. The square of this standard error is s1^2
/// / n1 + s2^2 / n2, where n values have the unbiased variance s^2: the sum of the squared
/// distances from their mean, divided by n − 1. (Welch's statistic: neither the variances nor the
/// numbers of values need be equal.)
///
/// If all values of each sample are equal, the standard error is 0: then equal means agree, and
/// others differ.
///
/// The answer is the same if a number is added to all values of both samples. In the tests this
/// number is up to 1e12 times as large as the spread, and the two sides of the comparison differ by
/// more than a hundredth, or all of these quantities are exact in double.
///
/// @param first in any order, at most 1e9 in magnitude; may be empty
/// @param second likewise
/// @param limit standard errors, greater than 0
Comparison compare(const std::vector<double>& first, const std::vector<double>& second,
                   double limit);

}  // namespace exercise
