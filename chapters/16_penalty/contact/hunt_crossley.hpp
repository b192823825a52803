/// @file
/// Hunt and Crossley's contact, F = κ δⁿ (1 + λ δ̇): a damper that acts in proportion to the spring
/// force. The force begins and ends at 0, and the restitution depends on the speed.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/collision_1d.hpp>
#include <contact/exact.hpp>
#include <contact/hertz.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/spring_damper.hpp>
#include <contact/spring_impact.hpp>

namespace contact {

/// The power of the penetration in the force.
enum class ContactExponent {
  linear,  ///< n = 1, a linear spring
  hertz    ///< n = 3/2, elastic balls
};

/// A contact with the force κ δⁿ (1 + λ δ̇). Make it with hunt_crossley(), which checks its
/// arguments.
template <std::floating_point S>
struct HuntCrossley {
  S stiffness = S(1);                                 ///< κ, N/m or N/m^(3/2), greater than 0
  S dissipation = S(0);                               ///< λ, s/m, not negative
  ContactExponent exponent = ContactExponent::hertz;  ///< n
};

/// A contact with the force κ δⁿ (1 + λ δ̇).
/// @param stiffness κ, N/m or N/m^(3/2), greater than 0
/// @param dissipation λ, s/m, 0 or more
/// @throws std::invalid_argument if a number is out of its range or not finite
template <std::floating_point S>
HuntCrossley<S> hunt_crossley(const S& stiffness, const S& dissipation,
                              ContactExponent exponent = ContactExponent::hertz) {
  require_finite("stiffness", stiffness);
  require_finite("dissipation", dissipation);
  if (!(stiffness > S(0))) {
    throw_invalid_argument("stiffness", number_text(stiffness), "must be greater than 0");
  }
  if (dissipation < S(0)) {
    throw_invalid_argument("dissipation", number_text(dissipation), "must not be negative");
  }
  return {stiffness, dissipation, exponent};
}

// [hunt-crossley-force]
/// Whether the force would be a pull at an overlap: 1 + λ δ̇ < 0. Exact for the stored numbers.
///
/// In an impact without other forces it never is. At δ̇ = −1 / λ the force is 0, so a body that
/// separates with exactly this speed keeps it; no other motion can reach that speed, because
/// solutions of the equation of motion do not meet. It takes another force, which pulls the body
/// off faster.
/// @param approach δ̇, m/s; negative: the surfaces separate
/// @return false for a number that is not finite
template <std::floating_point S>
bool would_pull(const HuntCrossley<S>& contact, const S& approach) {
  if (!std::isfinite(approach)) return false;
  const Exact product = detail::unrounded(contact.dissipation) * detail::unrounded(approach);
  return product < Exact(-1.0);
}

/// The force of a contact, κ δⁿ (1 + λ δ̇) while the surfaces overlap, else 0; 0 where it would be a
/// pull.
/// @param penetration δ, m; negative: a gap
/// @param approach δ̇, m/s; negative: the surfaces separate
/// @return N, 0 or more; error at most 7 u κ δⁿ (1 + λ |δ̇|), without overflow and underflow
template <std::floating_point S>
S hunt_crossley_force(const HuntCrossley<S>& contact, const S& penetration, const S& approach) {
  if (!(penetration > S(0))) return S(0);
  const S spring = contact.exponent == ContactExponent::linear
                       ? S(contact.stiffness * penetration)
                       : hertz_force(HertzContact<S>{contact.stiffness}, penetration);
  return spring * std::max(S(0), S(S(1) + contact.dissipation * approach));
}
// [/hunt-crossley-force]

namespace detail {

/// Σ z²ᵏ / (2 k + 3) from k = 0, the remainder of artanh z after z: (artanh z − z) / z³, for z² up
/// to 1/9. Positive terms; the omitted ones are below u / 8.
inline double artanh_remainder(double z) {
  double sum = 0;
  for (int k = 17; k >= 0; --k) sum = sum * (z * z) + 1.0 / (2 * k + 3);
  return sum;
}

/// (p − ln(1 + p)) / p², from 1/2 at p = 0 down to 0; for p ≥ 0. With z = p / (2 + p),
/// ln(1 + p) = 2 artanh z and p − 2 z = p z, so nothing cancels. Relative error at most 12 u.
inline double compression_share(double p) {
  if (p > 1) return (1 - log_of_inverse(1 / (1 + p)) / p) / p;
  const double z = p / (2 + p);
  return (1 - 2 * z / (2 + p) * artanh_remainder(z)) / (2 + p);
}

/// (p − ln(1 + p)) / (λ² v) with p = λ v: v / 2 without dissipation, at most 1 / λ. Relative error
/// at most 16 u, also where λ v overflows.
inline double stopping_speed(double dissipation, double v) {
  const double p = dissipation * v;
  if (!(p > 1)) return v * compression_share(p);
  if (std::isinf(p)) return 1 / dissipation;
  return (1 - log_of_inverse(1 / (1 + p)) / p) / dissipation;
}

/// (−q − ln(1 − q)) / q², from 1/2 at q = 0; for q from 0 to 1/2. Relative error at most 8 u.
inline double expansion_share(double q) {
  const double z = q / (2 - q);
  return (1 + 2 * z / (2 - q) * artanh_remainder(z)) / (2 - q);
}

/// The root q from 0 to 1 of −q − ln(1 − q) = target, for targets that are normal numbers. The left
/// side is convex and at least q² / 2, so Newton's method falls to a root q up to 1/2 from
/// √(2 target); beyond it rises in 1 − q from exp(−1 − target).
inline double expansion_root(double target) {
  if (target <= 0.19) {  // below ln 2 − 1/2: q is below 1/2
    double q = std::min(std::sqrt(2 * target), 0.5);
    for (int i = 0; i < 7; ++i) q -= (q * q * expansion_share(q) - target) * (1 - q) / q;
    return q;
  }
  double r = decay(1 + target);
  if (!(r > 0)) return 1;
  for (int i = 0; i < 8; ++i) r += r * (r - 1 + log_of_inverse(r) - target) / (1 - r);
  return 1 - r;
}

}  // namespace detail

// [hunt-crossley-restitution]
/// The coefficient of restitution of an impact without other forces. It depends on the speed v, and
/// not on mass, stiffness and exponent.
///
/// m u du / (1 + λ u) = −κ δⁿ dδ, and both ends of the impact have δ = 0. So with p = λ v and
/// q = λ e v: p − ln(1 + p) = −q − ln(1 − q), which has one root q from 0 to 1, as the right side
/// increases from 0 without bound. Newton's method on a convex side brackets it: for q ≤ 1/2 in e,
/// from above; beyond in 1 − q, from below. e = 1 − 2/3 p + … for slow impacts; for fast ones the
/// body leaves with nearly 1 / λ.
/// @param speed v, speed of approach, m/s, 0 or more
/// @return 0 to 1; relative error at most 40 u of double, plus the rounding to S
/// @see Hunt and Crossley, *Coefficient of restitution interpreted as damping in vibroimpact*,
/// Journal of Applied Mechanics 42 (1975)
template <std::floating_point S>
S hunt_crossley_restitution(const HuntCrossley<S>& contact, const S& speed) {
  const double p = static_cast<double>(contact.dissipation) * static_cast<double>(speed);
  if (!(p > 0)) return S(1);
  if (std::isinf(p)) return S(1 / static_cast<double>(contact.dissipation) / double(speed));
  const double share = detail::compression_share(p);
  if (p <= 1 && p * p * share <= 0.19) {  // below ln 2 − 1/2: q is below 1/2
    double e = std::min(1.0, 0.5 / p);
    for (int i = 0; i < 7; ++i) {
      e -= (e * e * detail::expansion_share(p * e) - share) * (1 - p * e) / e;
    }
    return S(e);
  }
  return S(detail::expansion_root(p * (p * share)) / p);
}
// [/hunt-crossley-restitution]

// [hunt-crossley-depth]
/// The greatest penetration of an impact without other forces: κ dⁿ⁺¹ / (n + 1) =
/// m (p − ln(1 + p)) / λ², with p = λ v.
/// @param mass kg, greater than 0
/// @param speed v, m/s, 0 or more, finite
/// @return m; relative error at most 40 u of double plus the rounding to S, if v is at least 1e-300
/// and λ at most 1e300 (in double), without overflow and underflow
template <std::floating_point S>
S hunt_crossley_depth(const HuntCrossley<S>& contact, const S& mass, const S& speed) {
  const auto m = static_cast<double>(mass);
  const auto v = static_cast<double>(speed);
  const auto k = static_cast<double>(contact.stiffness);
  if (!(v > 0)) return S(0);
  const double w = detail::stopping_speed(static_cast<double>(contact.dissipation), v);
  if (contact.exponent == ContactExponent::linear) {
    return S(std::sqrt(2.0) * std::sqrt(v) * std::sqrt(w) * (std::sqrt(m) / std::sqrt(k)));
  }
  return S(detail::depth_by_energy(2.5, m, v, w, k).number());
}
// [/hunt-crossley-depth]

// [dissipation-for]
/// The dissipation λ for a coefficient of restitution at one speed: the inverse of
/// hunt_crossley_restitution(), by bisection until no number lies between. At lower speeds the
/// contact returns more, at higher ones less.
///
/// If e < 1/1000 it is 1 / (e v) up to rounding: with p and q as there, 1 − q is below
/// (1 + p) e^(−p).
/// @param restitution e, greater than 0, at most 1
/// @param speed v, m/s, greater than 0
/// @return s/m; the restitution for it differs from e by at most 100 u of double, plus the rounding
/// to S
/// @throws std::invalid_argument if a number is out of its range or not finite, or λ overflows
template <std::floating_point S>
S dissipation_for(const S& restitution, const S& speed) {
  require_restitution("restitution", restitution);
  require_finite("speed", speed);
  if (!(restitution > S(0))) {
    throw_invalid_argument("restitution", number_text(restitution), "must be greater than 0");
  }
  if (!(speed > S(0))) {
    throw_invalid_argument("speed", number_text(speed), "must be greater than 0");
  }
  if (restitution == S(1)) return S(0);
  const auto e = static_cast<double>(restitution);
  const detail::Scaled v = detail::scaled(static_cast<double>(speed));
  const auto per_speed = [&](const detail::Scaled& p) {
    const S dissipation = S((p / v).number());
    if (std::isfinite(dissipation)) return dissipation;
    throw_invalid_argument("restitution", number_text(restitution), "the dissipation overflows");
  };
  if (e < 0.001) return per_speed(detail::scaled(1) / detail::scaled(e));
  double low = 0;
  double high = 1 / e;  // e is below 1 / p
  for (;;) {
    const double p = low + (high - low) / 2;
    if (!(p > low && p < high)) break;
    const HuntCrossley<double> unit{1, p, ContactExponent::linear};
    (hunt_crossley_restitution(unit, 1.0) > e ? low : high) = p;
  }
  return per_speed(detail::scaled(high));
}
// [/dissipation-for]

}  // namespace contact
