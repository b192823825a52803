/// @file
/// One impact on a spring and a damper in closed form: restitution, duration, greatest penetration;
/// and the damper for a given restitution.
///
/// No other force acts during the impact. With the damping ratio ζ = cos θ all formulas use the one
/// function θ / sin θ. It continues analytically beyond ζ = 1, where θ is imaginary and the
/// quotient is real.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/collision_1d.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/spring_damper.hpp>

namespace contact {

// [arc-over-sine]
/// θ / sin θ for ζ = cos θ: arccos ζ / √(1 − ζ²) for ζ < 1, arcosh ζ / √(ζ² − 1) for ζ > 1, 1 for
/// ζ = 1.
///
/// With w = 2 / (1 + ζ), which is 1 + tan²(θ/2), it is w times the series of atan(t)/t at
/// t² = w − 1. Halving the angle, w → 2 √w / (1 + √w), brings w near 1 first (Borchardt's mean).
/// Only + − × ÷ √ are used, so the result has the same bits on every machine; nothing cancels at
/// ζ = 1.
/// @param ratio ζ, 0 or more
/// @return relative error at most 80 u of double, plus the rounding to S
template <std::floating_point S>
S arc_over_sine(const S& ratio) {
  double w = 2 / (1 + std::min(static_cast<double>(ratio), std::numeric_limits<double>::max()));
  double factor = w;
  while (std::abs(1 - w) > 0.0625) {
    const double root = std::sqrt(w);
    factor *= 2 / (1 + root);
    w = 2 * root / (1 + root);
  }
  const double y = 1 - w;
  double sum = 0;
  for (int k = 14; k >= 0; --k) sum = sum * y + 1.0 / (2 * k + 1);
  return S(factor * sum);
}
// [/arc-over-sine]

namespace detail {

inline constexpr double log_two_high = 6.93147180369123816490e-01;  // 33 bits
inline constexpr double log_two_low = 1.90821492927058770002e-10;   // the rest
inline constexpr double pi = 3.141592653589793;

/// exp(−y) for y ≥ 0, by + − × ÷ only; relative error at most 4 u while it is a normal number.
inline double decay(double y) {
  if (!(y < 800)) return 0;
  const double n = std::nearbyint(y / log_two_high);
  const double r = (y - n * log_two_high) - n * log_two_low;
  double sum = 1;
  for (int k = 17; k >= 1; --k) sum = 1 - r * sum / k;
  return std::ldexp(sum, -static_cast<int>(n));
}

/// −ln x for 0 < x ≤ 1, by + − × ÷ only; relative error at most 10 u.
inline double log_of_inverse(double x) {
  int power = 0;
  double m = std::frexp(x, &power);
  if (m < 0.7071067811865476) {
    m *= 2;
    --power;
  }
  const double z = (m - 1) / (m + 1);
  double sum = 0;
  for (int k = 13; k >= 0; --k) sum = sum * (z * z) + 1.0 / (2 * k + 1);
  return -(power * log_two_high + (power * log_two_low + 2 * z * sum));
}

/// √(1 − ζ²), for ζ < 1.
inline double sine_of_cosine(double ratio) { return std::sqrt((1 - ratio) * (1 + ratio)); }

}  // namespace detail

// [restitution-of-damping]
/// The coefficient of restitution for a damping ratio; it does not depend on the speed.
///
/// At zero penetration: exp(−π ζ / √(1 − ζ²)); for ζ ≥ 1 the surfaces never separate, and it is 0.
/// At zero force: exp(−2 ζ θ / sin θ), which is larger if ζ > 0, and greater than 0 for every
/// ζ: near 1 / (4 ζ²) for large ζ, so in double it underflows above ζ = 3e153.
/// @param ratio ζ, 0 or more
/// @return 0 to 1; with y the exponent, the relative error is at most (8 + 90 y) u of double while
/// it is a normal number, plus the rounding to S; at zero penetration the factor 90 grows to 6 / (1
/// − ζ) near ζ = 1
template <std::floating_point S>
S restitution_of_damping(const S& ratio, ContactRelease rule) {
  const auto z = static_cast<double>(ratio);
  if (rule == ContactRelease::at_zero_force) return S(detail::decay(2 * z * arc_over_sine(z)));
  if (!(z < 1)) return S(0);
  return S(detail::decay(detail::pi * z / detail::sine_of_cosine(z)));
}
// [/restitution-of-damping]

/// The results of an impact on a spring and a damper.
template <std::floating_point S>
struct SpringImpact {
  S restitution = S(0);    ///< speed of separation over speed of approach, 0 to 1
  S duration = S(0);       ///< from the first touch to the end of the contact, s; ∞ if none
  S max_depth = S(0);      ///< greatest penetration, m
  S time_of_depth = S(0);  ///< time of the greatest penetration, s after the first touch
  S max_force = S(0);      ///< N
  S left_overlap = S(0);   ///< penetration at the end of the contact, m; 0 at zero penetration
};

// [spring-impact]
/// An impact on a spring and a damper, in closed form. With θ as above and ω₀ = √(k / m):
///
/// - The greatest penetration is d = (v / ω₀) √e at the time θ / (ω₀ sin θ), where e is the
///   restitution for the rule at_zero_force. So k d² / (m v²) = e: the spring holds the
///   fraction e of the kinetic energy before the impact, and e² of it returns.
/// - The force is 0 at twice that time. At zero penetration the contact ends at
///   π / ω_d = π / (ω₀ sin θ), or never if ζ ≥ 1.
/// - The force is greatest at the first touch, c v, if ζ ≥ 1/2; else at (3 θ − π) / (ω₀ sin θ).
/// - The overlap left at zero force is 2 ζ e v / ω₀, where spring and damper forces cancel.
/// @param mass of the body on a fixed surface, or reduced_mass() of two bodies, kg, greater than 0
/// @param speed speed of approach, m/s, 0 or more
/// @return each with a relative error of at most (100 + 100 y) u of double, where y is the exponent
/// of e, plus the rounding to S, if k, m and c² are from 1e-120 to 1e120 (in double) or c is 0, and
/// the result does not underflow
template <std::floating_point S>
SpringImpact<S> spring_impact(const SpringDamper<S>& spring, const S& mass, const S& speed,
                              ContactRelease rule = ContactRelease::at_zero_force) {
  const SpringDamper<double> wide{static_cast<double>(spring.stiffness),
                                  static_cast<double>(spring.damping)};
  const double z = damping_ratio(wide, static_cast<double>(mass));
  const double rate = natural_frequency(wide, static_cast<double>(mass));
  const auto v = static_cast<double>(speed);
  const double q = arc_over_sine(z);
  SpringImpact<S> impact;
  impact.restitution = S(restitution_of_damping(z, rule));
  impact.time_of_depth = S(q / rate);
  const double left = detail::decay(z * q);  // its square may underflow
  impact.max_depth = S(v / rate * left);
  if (rule == ContactRelease::at_zero_force) {
    impact.duration = S(2 * q / rate);
    impact.left_overlap = S(v / rate * (2 * (z * left)) * left);
  } else if (damping_regime(spring, mass) != DampingRegime::underdamped) {
    impact.duration = std::numeric_limits<S>::infinity();
    impact.restitution = S(0);
  } else if (spring.damping > S(0)) {
    // 4 k m − c² is exact before the root: computed from the rounded ζ, 1 − ζ would have no digits.
    const double root = std::sqrt(rounded<double>(-detail::damping_discriminant(spring, mass)));
    impact.duration = S(2 * detail::pi * static_cast<double>(mass) / root);
    impact.restitution = S(detail::decay(detail::pi * wide.damping / root));
  } else {
    impact.duration = S(detail::pi / rate);
  }
  const double momentum = static_cast<double>(mass) * v;
  if (z < 0.5) {
    const double later = std::max(0.0, 3 * q - detail::pi / detail::sine_of_cosine(z));
    impact.max_force = S(momentum * rate * detail::decay(z * later));
  } else {
    impact.max_force = S(wide.damping * v);
  }
  return impact;
}
// [/spring-impact]

// [damping-for-restitution]
/// The damping ratio for a coefficient of restitution: the inverse of restitution_of_damping().
///
/// At zero penetration ζ = L / √(π² + L²) with L = −ln e, and 1 for e = 0. At zero force there is
/// no closed form: 2 ζ θ / sin θ increases with ζ, and bisection runs until no number lies between.
/// @param restitution e, 0 to 1; at zero force greater than 0, since no damper gives 0 there
/// @return dimensionless; relative error at most 200 (1 + L) u of double, plus the rounding to S
/// @throws std::invalid_argument if there is no such damping ratio
template <std::floating_point S>
S damping_ratio_for(const S& restitution, ContactRelease rule) {
  require_restitution("restitution", restitution);
  const auto e = static_cast<double>(restitution);
  if (rule == ContactRelease::at_zero_penetration) {
    if (e == 0) return S(1);
    const double l = detail::log_of_inverse(e);
    return S(l / std::sqrt(detail::pi * detail::pi + l * l));
  }
  if (e == 0) {
    throw_invalid_argument("restitution", number_text(restitution),
                           "must be greater than 0 if the contact lets go at zero force");
  }
  const double l = detail::log_of_inverse(e);
  if (l == 0) return S(0);
  double low = 0;
  double high =
      l;  // below ζ = 4, θ / sin θ is more than 1/2; above, high doubles until it is enough
  while (2 * high * arc_over_sine(high) < l) {
    low = high;
    high *= 2;
  }
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return S(high);
    (2 * middle * arc_over_sine(middle) < l ? low : high) = middle;
  }
}

/// A spring with the damper for a given coefficient of restitution, c = 2 ζ √k √m.
/// @param stiffness N/m, greater than 0
/// @param mass kg, greater than 0
/// @param restitution as for damping_ratio_for()
/// @throws std::invalid_argument if a number is out of its range or not finite
template <std::floating_point S>
SpringDamper<S> spring_for_restitution(const S& stiffness, const S& mass, const S& restitution,
                                       ContactRelease rule = ContactRelease::at_zero_force) {
  require_mass("mass", mass);
  const SpringDamper<S> undamped = spring_damper(stiffness, S(0));
  const S ratio = damping_ratio_for(restitution, rule);
  return spring_damper(stiffness, S(2) * ratio * std::sqrt(undamped.stiffness) * std::sqrt(mass));
}
// [/damping-for-restitution]

// [stiffness-for-depth]
/// The stiffness for which an impact does not penetrate more than d: m (v² + 2 g d) / d², by
/// energy; without damping the penetration is d.
///
/// The contact lasts about π d / v. So a time step has to be short enough to move the body by only
/// a fraction of d: a stiff contact is expensive. An impulse needs no such step.
/// @param mass kg, greater than 0
/// @param speed v at the first touch, m/s, 0 or more
/// @param gravity g towards the surface, m/s², 0 or more
/// @param depth d, m, greater than 0
/// @return N/m; relative error at most 5 u, without overflow and underflow, so the penetration is
/// at most d (1 + 3 u)
template <Scalar S>
S stiffness_for_depth(const S& mass, const S& speed, const S& gravity, const S& depth) {
  return mass * (speed * speed / depth + S(2) * gravity) / depth;
}
// [/stiffness-for-depth]

}  // namespace contact
