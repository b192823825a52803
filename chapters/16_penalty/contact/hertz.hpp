/// @file
/// Hertz's contact of elastic balls, F = κ δ^(3/2): its stiffness, and its impact in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/invalid_argument.hpp>
#include <contact/penalty_step.hpp>
#include <contact/soft_to_rigid.hpp>

namespace contact {

namespace detail {

/// The n-th root by Newton's method, with + − × ÷ only; relative error at most 3 u.
///
/// With x = y 2^(n q) and y from 1/2 to 2^(n − 1), 1 + (y − 1) / n is at least the root
/// (Bernoulli's inequality); sⁿ − y is convex, so the iterates fall to the root.
/// @param x greater than 0, finite
/// @param n 3 or 5
inline double root_of(double x, int n) {
  int power = 0;
  double y = std::frexp(x, &power);
  const int q = (power >= 0 ? power : power - n + 1) / n;
  y = std::ldexp(y, power - n * q);
  double s = 1 + (y - 1) / n;
  for (;;) {
    double last = s;
    for (int i = 2; i < n; ++i) last *= s;
    const double next = s - (s - y / last) / n;
    if (!(next < s)) return std::ldexp(next, q);
    s = next;
  }
}

/// A positive number of any magnitude: value 2^exponent.
struct Scaled {
  double value;
  int exponent;

  /// Rounded to a double; ∞ or 0 where it overflows or underflows.
  double number() const { return std::ldexp(value, exponent); }
};

/// x with a value from 1/2 to 1; 0 stays 0.
inline Scaled scaled(double x) {
  Scaled result{0, 0};
  result.value = std::frexp(x, &result.exponent);
  return result;
}
inline Scaled operator*(const Scaled& x, const Scaled& y) {
  return {x.value * y.value, x.exponent + y.exponent};
}
inline Scaled operator/(const Scaled& x, const Scaled& y) {
  return {x.value / y.value, x.exponent - y.exponent};
}

/// (factor m v w / k)^(2/5), for any magnitudes; relative error at most 10 u.
/// @param factor from 1/8 to 8
/// @param m, v, w, k greater than 0, finite
inline Scaled depth_by_energy(double factor, double m, double v, double w, double k) {
  const Scaled x = scaled(m) * scaled(v) * scaled(w) / scaled(k);
  const int q = (x.exponent >= 0 ? x.exponent : x.exponent - 4) / 5;
  const double root = root_of(std::ldexp(factor * x.value, x.exponent - 5 * q), 5);
  return {root * root, 2 * q};
}

/// Σ (1/2)ₙ / n! yⁿ / (1 + 5 n / 2), for y up to 1/2. All terms are positive and each is at most
/// half of the one before it, so the omitted ones together are below u / 8.
constexpr double hertz_rise_sum(double y) {
  double sum = 0;
  for (int n = 52; n >= 1; --n) sum = (n - 0.5) / n * y * (1 / (1 + 2.5 * n) + sum);
  return 1 + sum;
}

/// Σ (3/5)ₙ / n! xⁿ / (2 n + 1), for x up to 1/2, like the sum above.
constexpr double hertz_slowing_sum(double x) {
  double sum = 0;
  for (int n = 52; n >= 1; --n) sum = (n - 0.4) / n * x * (1 / (2.0 * n + 1) + sum);
  return 1 + sum;
}

inline constexpr double root_of_half = 0.7071067811865476;
/// (1/2)^(2/5): the depth at which half of the energy is in the contact.
inline constexpr double hertz_half_depth = 0.757858283255199;

/// The time to the depth x, ∫ ds / √(1 − s^(5/2)) from 0 to x, with y = x^(5/2) up to 1/2.
inline double hertz_rise(double x) { return x * hertz_rise_sum(x * x * std::sqrt(x)); }

/// The time from the speed w (in units of the first) to the greatest depth, with w² up to 1/2. By
/// energy w² = 1 − y.
inline double hertz_slowing(double w) { return 0.8 * w * hertz_slowing_sum(w * w); }

}  // namespace detail

/// A contact with the force κ δ^(3/2). Make it with hertz_contact(), which checks its argument.
template <std::floating_point S>
struct HertzContact {
  S stiffness = S(1);  ///< κ, N/m^(3/2), greater than 0
};

/// A contact with the force κ δ^(3/2).
/// @param stiffness κ, N/m^(3/2), greater than 0
/// @throws std::invalid_argument if it is not greater than 0 or not finite
template <std::floating_point S>
HertzContact<S> hertz_contact(const S& stiffness) {
  require_finite("stiffness", stiffness);
  if (!(stiffness > S(0))) {
    throw_invalid_argument("stiffness", number_text(stiffness), "must be greater than 0");
  }
  return {stiffness};
}

/// What a body is made of. Make it with elastic_solid(), which checks its arguments.
template <std::floating_point S>
struct ElasticSolid {
  S modulus = S(1);  ///< Young's modulus E, Pa, greater than 0
  S poisson = S(0);  ///< Poisson's ratio ν, greater than −1, at most 1/2
};

/// A material.
/// @param modulus Young's modulus, Pa, greater than 0
/// @param poisson Poisson's ratio, greater than −1, at most 1/2
/// @throws std::invalid_argument if a number is out of its range or not finite
template <std::floating_point S>
ElasticSolid<S> elastic_solid(const S& modulus, const S& poisson) {
  require_finite("modulus", modulus);
  require_finite("poisson", poisson);
  if (!(modulus > S(0))) {
    throw_invalid_argument("modulus", number_text(modulus), "must be greater than 0");
  }
  if (!(poisson > S(-1)) || poisson > S(0.5)) {
    throw_invalid_argument("poisson", number_text(poisson), "must be above -1 and at most 0.5");
  }
  return {modulus, poisson};
}

// [hertz-stiffness]
/// Hertz's contact of a ball on a half-space: κ = 4/3 E* √R, where 1 / E* is the sum of
/// (1 − ν²) / E over both.
///
/// Hypotheses: elastic, frictionless, a contact area that is small against R, and an impact that is
/// slow against the speed of sound.
/// @param radius R, m, greater than 0
/// @throws std::invalid_argument if the radius is out of range, or the stiffness overflows or
/// underflows to 0
/// @see Johnson, *Contact Mechanics*, section 4.2; Hertz, *Über die Berührung fester elastischer
/// Körper*, Journal für die reine und angewandte Mathematik 92 (1882)
template <std::floating_point S>
HertzContact<S> hertz_contact(const S& radius, const ElasticSolid<S>& ball,
                              const ElasticSolid<S>& ground) {
  require_finite("radius", radius);
  if (!(radius > S(0))) {
    throw_invalid_argument("radius", number_text(radius), "must be greater than 0");
  }
  const auto compliance = [](const ElasticSolid<S>& solid) {
    return S((S(1) - solid.poisson) * (S(1) + solid.poisson) / solid.modulus);
  };
  const S modulus = S(1) / (compliance(ball) + compliance(ground));
  return hertz_contact(S(S(4) / S(3) * modulus * std::sqrt(radius)));
}

/// Hertz's contact of two balls: that of a ball with the radius 1 / (1 / r₁ + 1 / r₂) on a
/// half-space. The same for the balls in the other order.
/// @param first_radius, second_radius m, greater than 0
/// @throws std::invalid_argument as above
template <std::floating_point S>
HertzContact<S> hertz_contact(const S& first_radius, const ElasticSolid<S>& first,
                              const S& second_radius, const ElasticSolid<S>& second) {
  require_finite("first_radius", first_radius);
  require_finite("second_radius", second_radius);
  if (!(first_radius > S(0))) {
    throw_invalid_argument("first_radius", number_text(first_radius), "must be greater than 0");
  }
  if (!(second_radius > S(0))) {
    throw_invalid_argument("second_radius", number_text(second_radius), "must be greater than 0");
  }
  const auto [small, large] = std::minmax(first_radius, second_radius);
  return hertz_contact(S(small / (S(1) + small / large)), first, second);
}
// [/hertz-stiffness]

// [hertz-force]
/// The force of a contact, κ δ^(3/2) while the surfaces overlap, else 0. It begins with slope 0: a
/// light touch is soft, and the contact becomes stiffer with its depth.
/// @param penetration δ, m; negative: a gap
/// @return N; relative error at most 3 u, without overflow and underflow
template <std::floating_point S>
S hertz_force(const HertzContact<S>& contact, const S& penetration) {
  if (!(penetration > S(0))) return S(0);
  return contact.stiffness * std::sqrt(penetration) * penetration;
}

/// The elastic energy of a contact, 2/5 κ δ^(5/2), the integral of the force.
/// @return J; relative error at most 6 u, without overflow and underflow
template <std::floating_point S>
S hertz_energy(const HertzContact<S>& contact, const S& penetration) {
  if (!(penetration > S(0))) return S(0);
  return S(0.4) * (hertz_force(contact, penetration) * penetration);
}

/// The penetration at which the contact carries a force, (F / κ)^(2/3).
/// @param force F, N, 0 or more
/// @return m; relative error at most 9 u, without overflow and underflow of F / κ
template <std::floating_point S>
S hertz_depth_under(const HertzContact<S>& contact, const S& force) {
  const double ratio = static_cast<double>(force) / static_cast<double>(contact.stiffness);
  if (!(ratio > 0)) return S(0);
  const double root = detail::root_of(ratio, 3);
  return S(root * root);
}
// [/hertz-force]

// [hertz-duration]
/// The duration of Hertz's impact, in units of its depth over its speed: 4/5 B(2/5, 1/2), with
/// Euler's beta function, 2.943….
///
/// By energy the time is 2 ∫ dx / √(1 − x^(5/2)) from 0 to 1. It is the sum of two series of
/// positive terms: up to the depth at which half of the energy is in the contact, and from there.
/// @return relative error at most 20 u of double
constexpr double hertz_duration_factor() {
  constexpr double rise = detail::hertz_half_depth * detail::hertz_rise_sum(0.5);
  constexpr double slowing = 0.8 * detail::root_of_half * detail::hertz_slowing_sum(0.5);
  return 2 * (rise + slowing);
}
// [/hertz-duration]

/// The results of Hertz's impact, which returns all energy.
template <std::floating_point S>
struct HertzImpact {
  S max_depth = S(0);  ///< greatest penetration, m
  S duration = S(0);   ///< from the first touch to the last, s; ∞ for speed 0
  S max_force = S(0);  ///< N
};

// [hertz-impact]
/// An impact on Hertz's contact: by energy the depth is d = (5/4 m v² / κ)^(2/5), and the greatest
/// force 5/4 m v² / d; the duration is 2.943… d / v. So the depth grows as v^(4/5), and the
/// duration falls as v^(−1/5): a faster impact is shorter, while that of a linear spring always
/// takes π / ω₀.
/// @param mass m of the body on a fixed surface, or reduced_mass() of two bodies, kg, greater than
/// 0
/// @param speed v, speed of approach, m/s, 0 or more, finite
/// @return each with a relative error of at most 40 u of double plus the rounding to S; ∞ or 0
/// where the result overflows or underflows
template <std::floating_point S>
HertzImpact<S> hertz_impact(const HertzContact<S>& contact, const S& mass, const S& speed) {
  const auto m = static_cast<double>(mass);
  const auto v = static_cast<double>(speed);
  if (!(v > 0)) return {S(0), std::numeric_limits<S>::infinity(), S(0)};
  const detail::Scaled depth =
      detail::depth_by_energy(1.25, m, v, v, static_cast<double>(contact.stiffness));
  const detail::Scaled rate = detail::scaled(v) / depth;
  const detail::Scaled factor = detail::scaled(hertz_duration_factor());
  const detail::Scaled momentum = detail::scaled(1.25) * detail::scaled(m) * detail::scaled(v);
  return {S(depth.number()), S((factor / rate).number()), S((momentum * rate).number())};
}
// [/hertz-impact]

namespace detail {

/// Depth and speed of Hertz's impact, in units of the greatest and of the first.
struct HertzMoment {
  double depth;
  double speed;
};

/// The moment at a time from the first touch, in units of depth over speed, up to the middle.
///
/// Newton's method for hertz_rise() or hertz_slowing(). Both are convex and at least their first
/// term, so the first term's root is above theirs and the iterates fall to it; that start is off by
/// at most an eighth, and five steps square this below u.
inline HertzMoment hertz_moment(double time) {
  constexpr double half = hertz_half_depth;
  if (time <= hertz_rise(half)) {
    double x = std::min(time, half);
    for (int i = 0; i < 6; ++i) {
      x -= (hertz_rise(x) - time) * std::sqrt(1 - x * x * std::sqrt(x));
    }
    return {x, std::sqrt(1 - x * x * std::sqrt(x))};
  }
  const double left = std::max(0.0, hertz_duration_factor() / 2 - time);
  double w = std::min(1.25 * left, root_of_half);
  for (int i = 0; i < 6; ++i) {
    const double root = root_of(1 - w * w, 5);
    w -= (hertz_slowing(w) - left) / 0.8 * (root * root * root);
  }
  const double root = root_of(1 - w * w, 5);
  return {root * root, w};
}

}  // namespace detail

// [hertz-at]
/// Hertz's impact at a time t ≥ 0. Its first touch is at time 0; no other force acts. The second
/// half is the first in reverse.
/// @param mass kg, greater than 0
/// @param speed m/s, 0 or more
/// @param t s
/// @return penetration and approach with errors of at most 60 u of double of the greatest depth and
/// of the speed, plus the rounding to S, if κ, m and v are from 1e-150 to 1e150 (in double); after
/// the contact those of a free body
template <std::floating_point S>
ImpactMoment<S> hertz_at(const HertzContact<S>& contact, const S& mass, const S& speed,
                         const S& t) {
  const HertzImpact<double> impact =
      hertz_impact(HertzContact<double>{static_cast<double>(contact.stiffness)},
                   static_cast<double>(mass), static_cast<double>(speed));
  const auto v = static_cast<double>(speed);
  const auto time = static_cast<double>(t);
  if (!(v > 0)) return {{S(0), S(0)}, S(0), true};
  if (time > impact.duration) return {{S(-v * (time - impact.duration)), -speed}, S(0), false};
  const double whole = hertz_duration_factor();
  const double elapsed = time * (v / impact.max_depth);
  const bool later = elapsed > whole / 2;
  const auto moment = detail::hertz_moment(later ? std::max(0.0, whole - elapsed) : elapsed);
  const S depth = S(impact.max_depth * moment.depth);
  return {
      {depth, S(later ? -v * moment.speed : v * moment.speed)}, hertz_force(contact, depth), true};
}
// [/hertz-at]

}  // namespace contact
