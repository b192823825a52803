/// @file
/// Momentum: of one body, of many, of their centre of mass, and of two bodies that push off each
/// other.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A body of which only the mass and the motion count: a point, or the centre of mass of a larger
/// body. Make it with point_mass(), which checks its arguments.
template <Ring S>
struct PointMass {
  S mass = S(1);                             ///< kg, greater than 0
  Vector3<S> position = Vector3<S>::Zero();  ///< m
  Vector3<S> velocity = Vector3<S>::Zero();  ///< m/s
};

/// Throws std::invalid_argument unless a mass is finite and greater than 0.
template <Ring S>
void require_mass(const char* argument, const S& mass) {
  require_finite(argument, mass);
  if (!(mass > S(0))) {
    throw_invalid_argument(argument, number_text(mass), "a mass must be greater than 0");
  }
}

/// A body with a mass, a position and a velocity.
/// @param mass kg, greater than 0
/// @param position m
/// @param velocity m/s
/// @throws std::invalid_argument if the mass is not greater than 0, or a number is not finite
template <Ring S>
PointMass<S> point_mass(const S& mass, const Vector3<S>& position, const Vector3<S>& velocity) {
  require_mass("mass", mass);
  require_finite("position", position);
  require_finite("velocity", velocity);
  return {mass, position, velocity};
}

// [momentum]
/// The linear momentum of a body, p = m v.
/// @return kg·m/s, which is the same as N·s; each entry rounded once
/// @see *Interaction and Normals*, slide "Linear momentum"
template <Ring S>
Vector3<S> momentum(const PointMass<S>& body) {
  return body.velocity * body.mass;
}
// [/momentum]

namespace detail {

/// One coordinate of Σ mᵢ qᵢ, and the sum of the absolute values of its terms.
template <Ring S>
struct Weighted {
  S sum = S(0);
  S size = S(0);      // Σ mᵢ |qᵢ|
  bool sound = true;  // neither overflowed nor so small that products lost digits
};

// [weighted-sum]
/// Σ mᵢ qᵢ in a floating-point type, with the rounding errors of all products and sums added at the
/// end (Ogita, Rump and Oishi, algorithm Dot2).
template <std::floating_point S, class Of>
Weighted<S> weighted_sum(const std::vector<PointMass<S>>& bodies, const Of& of) {
  S sum(0);
  S lost(0);
  Weighted<S> result;
  bool all_zero = true;
  for (const PointMass<S>& body : bodies) {
    const S q = of(body);
    const S product = body.mass * q;
    const S next = sum + product;
    const S cut =
        std::abs(sum) >= std::abs(product) ? (sum - next) + product : (product - next) + sum;
    lost += cut + std::fma(body.mass, q, -product);
    sum = next;
    result.size += std::abs(product);
    all_zero = all_zero && q == S(0);
  }
  result.sum = sum + lost;
  // Above this size a product that underflows is far below u² of the sum.
  const S small =
      std::ldexp(S(1), std::numeric_limits<S>::min_exponent + 3 * std::numeric_limits<S>::digits);
  result.sound =
      all_zero || (std::isfinite(result.sum) && std::isfinite(result.size) && result.size >= small);
  return result;
}
// [/weighted-sum]

template <Ring S, class Of>
Exact exact_weighted_sum(const std::vector<PointMass<S>>& bodies, const Of& of) {
  Exact sum;
  for (const PointMass<S>& body : bodies) sum += Exact(double(body.mass)) * Exact(double(of(body)));
  return sum;
}

template <Ring S>
Exact exact_mass(const std::vector<PointMass<S>>& bodies) {
  Exact sum;
  for (const PointMass<S>& body : bodies) sum += Exact(double(body.mass));
  return sum;
}

/// One coordinate of Σ mᵢ qᵢ; in a floating-point type, in exact arithmetic if the fast sum is not
/// sound.
template <Ring S, class Of>
S weighted_total(const std::vector<PointMass<S>>& bodies, const Of& of) {
  if constexpr (std::floating_point<S>) {
    const Weighted<S> fast = weighted_sum(bodies, of);
    if (fast.sound) return fast.sum;
    return rounded<S>(exact_weighted_sum(bodies, of));
  } else {
    S sum(0);
    for (const PointMass<S>& body : bodies) sum = sum + body.mass * of(body);
    return sum;
  }
}

/// One coordinate of Σ mᵢ qᵢ / Σ mᵢ, for at least one body.
template <Scalar S, class Of>
S weighted_mean(const std::vector<PointMass<S>>& bodies, const Of& of) {
  S mass(0);
  for (const PointMass<S>& body : bodies) mass = mass + body.mass;
  if constexpr (std::floating_point<S>) {
    const Weighted<S> fast = weighted_sum(bodies, of);
    const S mean = fast.sum / mass;
    if (fast.sound && std::isfinite(mass) && std::isfinite(mean)) return mean;
    return quotient<S>(exact_weighted_sum(bodies, of), exact_mass(bodies));
  } else {
    return weighted_total(bodies, of) / mass;
  }
}

/// f(k) for the three coordinates k, as a vector.
template <Ring S, class Function>
Vector3<S> each_coordinate(const Function& f) {
  return {f(0), f(1), f(2)};
}

}  // namespace detail

/// The total mass, kg; 0 for no bodies. Its error is at most γ(n − 1) of itself.
template <Ring S>
S total_mass(const std::vector<PointMass<S>>& bodies) {
  S sum(0);
  for (const PointMass<S>& body : bodies) sum = sum + body.mass;
  return sum;
}

// [total-momentum]
/// The total momentum, Σ mᵢ vᵢ.
///
/// Internal forces do not change it, since they come in opposite pairs; only external forces do. So
/// it is an invariant by which a simulation can be checked.
/// @return kg·m/s. In a floating-point type the error of each entry is at most u of itself plus
/// 3 n² u² of Σ mᵢ|vᵢ| for n bodies, n u < 1/10; ±∞ only if the true sum is beyond the largest
/// number; 0 for no bodies
/// @see *Interaction and Normals*, slide "Conservation of Momentum and Newton's Third Law"
template <Ring S>
Vector3<S> total_momentum(const std::vector<PointMass<S>>& bodies) {
  return detail::each_coordinate<S>([&bodies](int k) {
    return detail::weighted_total(bodies,
                                  [k](const PointMass<S>& body) { return body.velocity(k); });
  });
}
// [/total-momentum]

/// Σ mᵢ |vᵢ| for each coordinate: the scale with which to compare an error of the total momentum.
/// The total itself may be 0.
/// @return kg·m/s, with an error of at most γ(n) of itself; ∞ if it overflows
template <Ring S>
Vector3<S> momentum_scale(const std::vector<PointMass<S>>& bodies) {
  Vector3<S> sum = Vector3<S>::Zero();
  for (const PointMass<S>& body : bodies) {
    for (int k = 0; k < 3; ++k) {
      const S p = body.mass * body.velocity(k);
      sum(k) = sum(k) + (p < S(0) ? S(-p) : p);
    }
  }
  return sum;
}

// [centre-of-mass]
/// The centre of mass of all bodies, Σ mᵢ xᵢ / Σ mᵢ.
/// @return m, or nothing if there are no bodies. In a floating-point type it is finite, and its
/// error is at most (n + 2) u of itself plus 3 n² u² of Σ mᵢ|xᵢ| / Σ mᵢ for n bodies, n u < 1/10,
/// plus the smallest positive number if the division by the mass underflows
template <Scalar S>
std::optional<Vector3<S>> centre_of_mass(const std::vector<PointMass<S>>& bodies) {
  if (bodies.empty()) return std::nullopt;
  return detail::each_coordinate<S>([&bodies](int k) {
    return detail::weighted_mean(bodies,
                                 [k](const PointMass<S>& body) { return body.position(k); });
  });
}

/// The velocity of the centre of mass, Σ mᵢ vᵢ / Σ mᵢ: also the velocity of all bodies once they
/// have stuck together.
///
/// Internal forces do not change it. So the centre of mass of a composite body moves like a point
/// with the total mass, on which the external forces act.
/// @return m/s, or nothing if there are no bodies; errors as in centre_of_mass()
/// @see *Interaction and Normals*, the hockey players, and "Composite objects can be treated like
/// point particles"
template <Scalar S>
std::optional<Vector3<S>> centre_velocity(const std::vector<PointMass<S>>& bodies) {
  if (bodies.empty()) return std::nullopt;
  return detail::each_coordinate<S>([&bodies](int k) {
    return detail::weighted_mean(bodies,
                                 [k](const PointMass<S>& body) { return body.velocity(k); });
  });
}
// [/centre-of-mass]

/// Two bodies after they have pushed off each other.
template <Ring S>
struct PushOff {
  Vector3<S> first = Vector3<S>::Zero();    ///< velocity of the first, m/s
  Vector3<S> second = Vector3<S>::Zero();   ///< velocity of the second, m/s
  Vector3<S> impulse = Vector3<S>::Zero();  ///< on the second; on the first it is the opposite, N·s
};

// [push-off]
/// Recoil: two bodies that moved together separate, with a given velocity of the second relative to
/// the first.
///
/// No external force acts, so the centre of mass keeps its velocity v. With u the relative
/// velocity, the first body gets v − u m₂ / (m₁ + m₂) and the second v + u m₁ / (m₁ + m₂).
/// @param first_mass, second_mass kg, finite and greater than 0
/// @param together velocity of both before, m/s
/// @param relative velocity of the second relative to the first afterwards, m/s
/// @return in a floating-point type with an error of a few u of |v| + |u|
/// @note Three velocities are easily confused: relative to the ground, to the first body, and to
/// the centre of mass. If the second's velocity w over the ground is known instead, the first gets
/// v − (w − v) m₂ / m₁.
/// @see *Interaction and Normals*, slides "Recoil" and "Archer Example"
template <Scalar S>
PushOff<S> push_off(const S& first_mass, const S& second_mass, const Vector3<S>& together,
                    const Vector3<S>& relative) {
  S first_share = first_mass / (first_mass + second_mass);
  S second_share = second_mass / (first_mass + second_mass);
  if constexpr (std::floating_point<S>) {
    if (!std::isfinite(first_mass + second_mass)) {
      const S half_sum = first_mass / S(2) + second_mass / S(2);
      first_share = first_mass / S(2) / half_sum;
      second_share = second_mass / S(2) / half_sum;
    }
  }
  // The reduced mass m₁ m₂ / (m₁ + m₂), without a product that could overflow.
  const S reduced =
      first_mass < second_mass ? S(first_mass * second_share) : S(second_mass * first_share);
  return {together - relative * second_share, together + relative * first_share,
          relative * reduced};
}
// [/push-off]

}  // namespace contact
