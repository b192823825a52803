/// @file
/// A floating-point filter: a determinant in double with a bound on its error, so that most signs
/// are certain without exact arithmetic.
#pragma once

#include <cmath>
#include <contact/vector.hpp>
#include <limits>

namespace contact {

// [filter]
/// A determinant in double, and a bound on its error.
struct Bounded {
  /// The determinant as computed.
  double value;
  /// The exact determinant differs from it by at most this.
  double bound;

  /// The sign of the exact value if it is certain, else 0. Written so that NaN is not certain.
  int certain_sign() const { return value > bound ? 1 : (value < -bound ? -1 : 0); }
};

/// p·(q × r) with its error bound, for entries that are differences of two doubles, each rounded
/// once (or not at all).
///
/// The bound. Let u = 2^-53 and η = 2^-1074. Without underflow each rounded result is the exact one
/// times 1 + δ, |δ| ≤ u (a difference of doubles cannot underflow with an error). Follow one of the
/// six terms p_i q_j r_k to the result: three roundings in its entries, one in q_j r_k, one in the
/// difference of two such products, one in the product with p_i, at most two in the sum of three:
/// eight. So |value − exact| ≤ γ Σ|terms| with γ = 8u/(1 − 8u). The sum of absolute terms is itself
/// computed with at most eight roundings a term, so Σ|terms| ≤ magnitude/(1 − γ). Together with the
/// rounding of the product 9u·magnitude, 8u/(1 − 8u)/(1 − γ)·(1 + u) < 9u leaves room. Underflow
/// adds at most η/2 to each of nine products, of which six are then multiplied by an entry of p:
/// less than 4η (1 + |p_x| + |p_y| + |p_z|) in value and as much in magnitude. 2^-1000 instead of η
/// is far more than needed, and keeps the bound itself out of the slow subnormal range. Overflow:
/// every intermediate of value is at most the same intermediate of magnitude (rounding is
/// monotonic), so if anything overflows, the bound is infinite or NaN, and no sign is certain.
inline Bounded bounded_volume(const Vector3<double>& p, const Vector3<double>& q,
                              const Vector3<double>& r) {
  constexpr double nine_u = 4.5 * std::numeric_limits<double>::epsilon();
  constexpr double floor = 0x1p-1000;
  double value = 0, magnitude = 0, size_of_p = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double left = q[j] * r[k];
    const double right = q[k] * r[j];
    value += p[i] * (left - right);
    magnitude += std::abs(p[i]) * (std::abs(left) + std::abs(right));
    size_of_p += std::abs(p[i]);
  }
  return {value, nine_u * magnitude + floor * (1 + size_of_p)};
}
// [/filter]

}  // namespace contact
