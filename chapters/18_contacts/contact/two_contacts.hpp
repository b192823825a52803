/// @file
/// Two contacts at once: complementarity by its four cases.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
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
  TwoContactCase pushes = TwoContactCase::none;  ///< which of them are above 0 before rounding
  S first = S(0);                                ///< N·s, not negative
  S second = S(0);                               ///< N·s, not negative
};
// [/two-contacts]

namespace detail {

/// A number times a power of two, so that it is not limited to the range of S.
template <Ring S>
struct WideNumber {
  S value;        ///< has the sign of the number
  int power = 0;  ///< 0 for exact numbers
};

/// a b + c d, exact; for floating-point numbers with a relative error of at most 2 u and the exact
/// sign, also where a product over- or underflows.
template <Ring S>
WideNumber<S> sum_of_two_products(const S& a, const S& b, const S& c, const S& d) {
  if constexpr (std::floating_point<S>) {
    if (!product_keeps_its_digits<S>(a, b) || !product_keeps_its_digits<S>(c, d)) {
      int of_a = 0, of_b = 0, of_c = 0, of_d = 0;
      const S p = std::frexp(a, &of_a), q = std::frexp(b, &of_b);
      const S r = std::frexp(c, &of_c), s = std::frexp(d, &of_d);
      constexpr int none = std::numeric_limits<int>::min() / 2;
      const int one = p == S(0) || q == S(0) ? none : of_a + of_b;
      const int two = r == S(0) || s == S(0) ? none : of_c + of_d;
      const int power = std::max(one, two);
      // A product as small as this beside the other only has to keep its sign.
      constexpr int least = -2 * std::numeric_limits<S>::digits;
      return {difference_of_products<S>(std::ldexp(p, std::max(one - power, least)), q,
                                        std::ldexp(-r, std::max(two - power, least)), s),
              power};
    }
    return {difference_of_products<S>(a, b, S(-c), d)};
  } else {
    return {a * b + c * d};
  }
}

/// x / y, for y > 0. For floating-point numbers rounded once, and ±∞ if it is too large.
template <Ring S>
S quotient(const WideNumber<S>& x, const WideNumber<S>& y) {
  if constexpr (std::floating_point<S>) {
    if (x.power != 0 || y.power != 0) {
      int of_x = 0, of_y = 0;
      const S ratio = std::frexp(x.value, &of_x) / std::frexp(y.value, &of_y);
      return std::ldexp(ratio, of_x - of_y + x.power - y.power);
    }
  }
  return x.value / y.value;
}

/// @throws std::invalid_argument if a number is not finite, or a diagonal entry is negative
template <Scalar S>
void require_two_contacts(const TwoContactMatrix<S>& matrix, const S& v, const S& w) {
  const S &a = matrix.first, &c = matrix.second;
  for (const S& x : {a, matrix.coupling, c, v, w}) require_finite("contacts", x);
  if (a < S(0) || c < S(0))
    throw_invalid_argument("matrix", number_text(a < c ? a : c), "must not be negative");
}

/// @throws std::invalid_argument if an impulse is not finite
template <Scalar S>
TwoContactImpulses<S> finite_impulses(const TwoContactImpulses<S>& x) {
  if (!is_finite(x.first) || !is_finite(x.second))
    throw_invalid_argument("matrix", "?", "is so small that impulses overflow");
  return x;
}

}  // namespace detail

// [four-cases]
/// The impulses x ≥ 0 with velocities A x + b ≥ 0 of which at each contact one is 0: the linear
/// complementarity problem of two contacts, by its four cases.
///
/// None pushes: both velocities b are at least 0. One pushes: its impulse makes its velocity 0, and
/// that of the other must not be negative then. Both push: Cramer's rule. In doubles every decision
/// is exact for the numbers as stored, because the sign of a sum of two products is; and each
/// impulse has a relative error of at most 8 u, whatever cancels, over- or underflows on the way.
/// (An impulse below the normal numbers is off by at most the smallest number, and may be 0.)
///
/// For a positive definite A exactly one case holds, or several that give the same velocities and
/// impulses. If A is singular, the two contacts do the same or the opposite. If they do the same,
/// one of them suffices, and the first is taken that does. If they do the opposite, like the jaws
/// of a vice, and both close, there is no solution. A determinant below 0, which only rounding
/// makes, counts as 0. One above 0 that is only rounding does not: the jaws then get impulses of
/// 10¹⁶ times the velocities. A caller with a rounded A must ask itself whether it is singular, as
/// block_iteration() does.
/// @param velocity_first, velocity_second b: normal velocities minus the least ones, m/s
/// @return nothing if there is no solution: then iterate over the two contacts, which ends with a
/// residual, or treat them as one
/// @throws std::invalid_argument if a number or a resulting impulse is not finite, or a diagonal
/// entry is negative
template <Scalar S>
std::optional<TwoContactImpulses<S>> solve_two_contacts(const TwoContactMatrix<S>& matrix,
                                                        const S& velocity_first,
                                                        const S& velocity_second) {
  const S &a = matrix.first, &b = matrix.coupling, &c = matrix.second;
  const S &v = velocity_first, &w = velocity_second;
  detail::require_two_contacts(matrix, v, w);
  using Case = TwoContactCase;
  if (!(v < S(0)) && !(w < S(0))) return TwoContactImpulses<S>{};
  // w − b v / a and v − b w / c, times a and c.
  const auto other_of_first = detail::sum_of_two_products<S>(w, a, S(-v), b);
  const auto other_of_second = detail::sum_of_two_products<S>(v, c, S(-w), b);
  if (v < S(0) && S(0) < a && !(other_of_first.value < S(0)))
    return detail::finite_impulses<S>({Case::first, S(-v) / a, S(0)});
  if (w < S(0) && S(0) < c && !(other_of_second.value < S(0)))
    return detail::finite_impulses<S>({Case::second, S(0), S(-w) / c});
  const auto determinant = detail::sum_of_two_products<S>(a, c, S(-b), b);
  if (!(S(0) < determinant.value)) return std::nullopt;
  return detail::finite_impulses<S>({Case::both, -detail::quotient<S>(other_of_second, determinant),
                                     -detail::quotient<S>(other_of_first, determinant)});
}
// [/four-cases]

}  // namespace contact
