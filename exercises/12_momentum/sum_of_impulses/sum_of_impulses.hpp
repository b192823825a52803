/// @file
/// Exercise: an accurate sum of impulses.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The sum of all impulses, in N·s. Zero for none.
///
/// The error may be at most 2 u |J| + 2 n² u² Σ|Jᵢ|, for n impulses with the sum J and u = 2⁻⁵³, as
/// if computed with twice the digits and rounded at the end. No intermediate sum overflows.
///
/// @param impulses N·s, finite, in any order; up to about 10,000
double total(const std::vector<double>& impulses);

}  // namespace exercise
