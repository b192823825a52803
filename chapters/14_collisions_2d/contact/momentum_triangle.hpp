/// @file
/// Momentum triangles: a momentum as the sum of two with known directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include <contact/disc_collision.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

// [cross]
/// a × b = a_x b_y − a_y b_x with an error of at most 2 u of itself, unless something underflows:
/// the rounding error of a product is computed exactly and added (Kahan; the bound is that of
/// Jeannerod, Louvet and Muller, *Mathematics of Computation* 82 (2013)).
template <Ring S>
S cross_of(const Vector2<S>& a, const Vector2<S>& b) {
  if constexpr (std::floating_point<S>) {
    const S second = a.y() * b.x();
    const S cut = std::fma(-a.y(), b.x(), second);
    return std::fma(a.x(), b.y(), -second) + cut;
  } else {
    return a.x() * b.y() - a.y() * b.x();
  }
}
// [/cross]

}  // namespace detail

/// A momentum as the sum of two.
template <Ring S>
struct MomentumShares {
  Vector2<S> a = Vector2<S>::Zero();  ///< kg·m/s
  Vector2<S> b = Vector2<S>::Zero();  ///< kg·m/s
};

/// The two momenta along known directions whose sum is known: the third vertex of the momentum
/// triangle.
///
/// With the sines of angles written as cross products this is the law of sines:
/// p_A = (p × b)/(a × b) a and p_B = (a × p)/(a × b) b for directions a and b of any length.
/// @param total p, kg·m/s
/// @param direction_a, direction_b of any length but zero
/// @return the shares, each entry off by at most 10 u of itself (if the entries of a vector differ
/// by less than 2^400 in size); negative ones are opposite to their direction; nothing if the
/// directions are parallel
/// @see *Interaction and Normals*, slides "Vector Diagrams" and "Special Condition"
template <Scalar S>
std::optional<MomentumShares<S>> share_momentum(const Vector2<S>& total,
                                                const Vector2<S>& direction_a,
                                                const Vector2<S>& direction_b) {
  if constexpr (std::floating_point<S>) {
    const auto of_size_one = [](const Vector2<S>& v) {
      return v == Vector2<S>::Zero() ? v : detail::times_power<S>(v, -detail::power_of<S>(v));
    };
    if (total == Vector2<S>::Zero()) {
      if (detail::cross_of(of_size_one(direction_a), of_size_one(direction_b)) == S(0)) {
        return std::nullopt;
      }
      return MomentumShares<S>{};
    }
    const Vector2<S> a = of_size_one(direction_a);
    const Vector2<S> b = of_size_one(direction_b);
    const Vector2<S> p = of_size_one(total);
    const S sine = detail::cross_of(a, b);
    if (sine == S(0)) return std::nullopt;
    const int power = detail::power_of<S>(total);
    return MomentumShares<S>{detail::times_power<S>(a * S(detail::cross_of(p, b) / sine), power),
                             detail::times_power<S>(b * S(detail::cross_of(a, p) / sine), power)};
  } else {
    const S sine = detail::cross_of(direction_a, direction_b);
    if (sine == S(0)) return std::nullopt;
    return MomentumShares<S>{direction_a * S(detail::cross_of(total, direction_b) / sine),
                             direction_b * S(detail::cross_of(direction_a, total) / sine)};
  }
}

}  // namespace contact
