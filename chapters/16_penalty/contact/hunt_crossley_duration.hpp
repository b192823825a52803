/// @file
/// The duration of an impact on Hunt and Crossley's contact, by a quadrature that converges
/// geometrically.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/hertz.hpp>
#include <contact/hunt_crossley.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/sine_cosine.hpp>

namespace contact {

namespace detail {

/// λ δ̇ for the signed root s of the energy to come, s²/2 = x − ln(1 + x), for s > 0: by Newton's
/// method from above, since x − ln(1 + x) is convex and at least x² / (2 (1 + x)).
inline double compression_root(double s) {
  const double square = s * s;
  double x = (square + s * std::sqrt(square + 4)) / 2;
  for (int i = 0; i < 60; ++i) {
    const double next = x - (x * (x * compression_share(x)) - square / 2) * (1 + x) / x;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

/// The nodes after which the error of the quadrature is below u: it falls as ρ^(−n), with ρ the sum
/// of the half axes of the ellipse with foci ±1 through the nearest singularity. Those are at
/// s = √(4 π) e^(±i π / 4), where the logarithm turns once.
inline int quadrature_nodes(double largest) {
  const double z = std::sqrt(2 * pi) / largest;  // real and imaginary part of the singularity
  const double near = std::sqrt((z - 1) * (z - 1) + z * z);
  const double far = std::sqrt((z + 1) * (z + 1) + z * z);
  const double axis = (near + far) / 2;
  const double rho = axis + std::sqrt(std::max(0.0, axis * axis - 1));
  const double nodes = 40 / log_of_inverse(1 / rho);
  return 2 * static_cast<int>(std::min(2048.0, nodes / 2 + 4));
}

/// n times the weight of the node φ: the integral of sin^(μ − 1) φ times 1 + 2 Σ cos 2 k φ cos 2 k
/// φ' over φ', with k below n / 2.
/// @param turn sine and cosine of φ
/// @param first the integral for k = 0
inline double fourier_weight(const SineCosine<double>& turn, int nodes, double mu, double first) {
  const double twice = 2 * (turn.cosine - turn.sine) * (turn.cosine + turn.sine);  // 2 cos 2 φ
  double before = 1;
  double now = twice / 2;
  double moment = first;
  double sum = first;
  for (int k = 1; k < nodes / 2; ++k) {
    moment *= (2 * k - 1 - mu) / (2 * k - 1 + mu);
    sum += 2 * moment * now;
    const double next = twice * now - before;
    before = now;
    now = next;
  }
  return sum;
}

/// v cos φ (1 / |δ̇| at φ + 1 / |δ̇| at π − φ), for cos φ > 0: two speeds at equal depth, on the way
/// in and on the way out. For small s the sum of the two is 2 / s up to s² of itself.
/// @param ratio S / p
inline double pair_of_speeds(double cosine, double ratio, double p) {
  const double s = p * ratio * cosine;
  if (!(s > 1e-8)) return 2 / ratio;
  return cosine * p * (1 / compression_root(s) + 1 / expansion_root(s * s / 2));
}

/// The greatest depth over the speed v, for any magnitudes; relative error at most 40 u.
/// @param share compression_share(λ v)
inline Scaled depth_per_speed(const HuntCrossley<double>& contact, double m, double v,
                              double share) {
  if (contact.exponent == ContactExponent::linear) {
    return scaled(std::sqrt(2 * share)) * scaled(std::sqrt(m)) /
           scaled(std::sqrt(contact.stiffness));
  }
  const double root = root_of(share, 5);
  return depth_by_energy(2.5, m, v, v, contact.stiffness) * scaled(root * root) / scaled(v);
}

}  // namespace detail

// [hunt-crossley-duration]
/// The duration of an impact without other forces.
///
/// With s = ±√(2 (x − ln(1 + x))), x = λ δ̇, the impact runs from s = S to s = −S, and
/// δⁿ⁺¹ = dⁿ⁺¹ (1 − s² / S²). With s = S cos φ and μ = 2 / (n + 1) it lasts
/// μ d ∫ sin^(μ − 1) φ (cos φ / δ̇) dφ from 0 to π. cos φ / δ̇ is an analytic, even function of φ
/// with period 2 π. Its values at n equally spaced φ give its Fourier coefficients, and the
/// integrals of sin^(μ − 1) φ cos 2 k φ are known: each is (2 k + 1 − μ) / (2 k + 1 + μ) times the
/// one before, the first is π or Hertz's B(2/5, 1/2).
/// @param mass kg, greater than 0
/// @param speed v, m/s, 0 or more
/// @return s; relative error at most 1e-13, plus the rounding to S, for numbers of every size; ∞ or
/// 0 where the result overflows or underflows; ∞ for speed 0 and a Hertzian contact
/// @throws std::invalid_argument if λ v is above 1000: then the contact needs too many nodes
template <std::floating_point S>
S hunt_crossley_duration(const HuntCrossley<S>& contact, const S& mass, const S& speed) {
  const HuntCrossley<double> wide{static_cast<double>(contact.stiffness),
                                  static_cast<double>(contact.dissipation), contact.exponent};
  const bool linear = contact.exponent == ContactExponent::linear;
  const auto m = static_cast<double>(mass);
  const auto v = static_cast<double>(speed);
  const double p = wide.dissipation * v;
  if (!(p <= 1000)) throw_invalid_argument("speed", number_text(speed), "λ v must be at most 1000");
  if (!(v > 0)) {
    const double still = detail::pi * (std::sqrt(m) / std::sqrt(wide.stiffness));
    return linear ? S(still) : std::numeric_limits<S>::infinity();
  }
  const double mu = linear ? 1 : 0.8;
  const double first = linear ? detail::pi : 1.25 * hertz_duration_factor();
  const double share = detail::compression_share(p);
  const double ratio = std::sqrt(2 * share);
  const int nodes = detail::quadrature_nodes(std::max(p * ratio, 0.01));
  double sum = 0;
  for (int j = 0; j < nodes / 2; ++j) {
    const SineCosine<double> turn = sine_cosine(detail::pi * (2 * j + 1) / (2 * nodes));
    // φ and π − φ have the same weight: the speed of approach and that of separation.
    const double weight = detail::fourier_weight(turn, nodes, mu, first);
    sum += weight * detail::pair_of_speeds(turn.cosine, ratio, p);
  }
  const detail::Scaled time = detail::depth_per_speed(wide, m, v, share);
  return S((detail::scaled(mu * sum / nodes) * time).number());
}
// [/hunt-crossley-duration]

}  // namespace contact
