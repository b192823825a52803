/// @file
/// Two contacts at once: complementarity by its four cases.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include <contact/invalid_argument.hpp>
#include <contact/products.hpp>
#include <contact/vector.hpp>

namespace contact {

// [two-contacts]
/// The symmetric matrix of two contacts, 1/kg: what a unit impulse at one does to the normal
/// velocity at itself (the diagonal, the inverse effective masses) and at the other.
template <Ring S>
struct TwoContactMatrix {
  S first = S(0);     ///< of the first contact on itself, not negative
  S coupling = S(0);  ///< of one on the other; negative if an impulse at one closes the other
  S second = S(0);    ///< of the second contact on itself, not negative
};

/// Which of two contacts push.
enum class TwoContactCase { none, first, second, both };

/// The impulses of two contacts.
template <Ring S>
struct TwoContactImpulses {
  TwoContactCase pushes = TwoContactCase::none;  ///< which of them are not 0
  S first = S(0);                                ///< N·s, not negative
  S second = S(0);                               ///< N·s, not negative
};
// [/two-contacts]

namespace detail {

/// a b + c d; for floating-point numbers with a relative error of at most 3 u and the exact sign.
template <Ring S>
S sum_of_two_products(const S& a, const S& b, const S& c, const S& d) {
  if constexpr (std::floating_point<S>) {
    return dot_accurately<S, 2>(Eigen::Matrix<S, 2, 1>(a, c), Eigen::Matrix<S, 2, 1>(b, d));
  } else {
    return a * b + c * d;
  }
}

}  // namespace detail

// [four-cases]
/// The impulses x ≥ 0 with velocities A x + b ≥ 0 of which at each contact one is 0: the linear
/// complementarity problem of two contacts, by its four cases.
///
/// None pushes: both velocities b are at least 0. One pushes: its impulse makes its velocity 0, and
/// that of the other must not be negative then. Both push: Cramer's rule. In doubles every decision
/// is exact for the numbers as stored, because the sign of a sum of two products is; and each
/// impulse has a relative error of at most 8 u, whatever cancels.
///
/// For a positive definite A exactly one case holds, or several that give the same velocities and
/// impulses. If A is singular, the two contacts do the same or the opposite. If they do the same,
/// one of them suffices, and the first is taken that does. If they do the opposite, like the jaws
/// of a vice, and both close, there is no solution. A determinant below 0, which only rounding
/// makes, counts as 0.
/// @param velocity_first, velocity_second b: normal velocities minus the least ones, m/s
/// @return nothing if there is no solution: then iterate over the two contacts, which ends with a
/// residual, or treat them as one
/// @throws std::invalid_argument if a number or a resulting impulse is not finite, or a diagonal
/// entry is negative
template <Scalar S>
std::optional<TwoContactImpulses<S>> solve_two_contacts(const TwoContactMatrix<S>& matrix,
                                                        const S& velocity_first,
                                                        const S& velocity_second) {
  const S& a = matrix.first;
  const S& b = matrix.coupling;
  const S& c = matrix.second;
  const S& v = velocity_first;
  const S& w = velocity_second;
  for (const S& x : {a, b, c, v, w}) require_finite("contacts", x);
  if (a < S(0) || c < S(0))
    throw_invalid_argument("matrix", number_text(a < c ? a : c), "must not be negative");
  const auto checked = [](const TwoContactImpulses<S>& x) {
    if (!is_finite(x.first) || !is_finite(x.second))
      throw_invalid_argument("matrix", "?", "is so small that impulses overflow");
    return x;
  };
  using Case = TwoContactCase;
  if (!(v < S(0)) && !(w < S(0))) return TwoContactImpulses<S>{};
  // w − b v / a and v − b w / c, times a and c.
  const S other_of_first = detail::sum_of_two_products<S>(w, a, S(-v), b);
  const S other_of_second = detail::sum_of_two_products<S>(v, c, S(-w), b);
  if (v < S(0) && S(0) < a && !(other_of_first < S(0)))
    return checked({Case::first, S(-v) / a, S(0)});
  if (w < S(0) && S(0) < c && !(other_of_second < S(0)))
    return checked({Case::second, S(0), S(-w) / c});
  const S determinant = detail::sum_of_two_products<S>(a, c, S(-b), b);
  if (!(S(0) < determinant)) return std::nullopt;
  return checked({Case::both, S(-other_of_second) / determinant, S(-other_of_first) / determinant});
}
// [/four-cases]

}  // namespace contact
