/// @file
/// Exercise: a sum of impulses in which the small ones are not lost.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The sum of all impulses, in N·s. Zero for none.
///
/// It may be off by 2 u |J| + 2 n² u² Σ|Jᵢ|, for n impulses with the sum J and u = 2⁻⁵³: as if it
/// had been computed with twice the digits and rounded at the end. No sum on the way overflows.
///
/// @param impulses N·s, finite, in no particular order; up to about ten thousand
double total(const std::vector<double>& impulses);

}  // namespace exercise
