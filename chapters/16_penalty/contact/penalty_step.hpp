/// @file
/// A contact spring in time steps: seven integration schemes, the steps for which each is stable,
/// and the step for a required accuracy.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>

#include <contact/spring_damper.hpp>

namespace contact {

/// How a step computes the next penetration and velocity.
enum class PenaltyScheme {
  explicit_euler,       ///< position with the old velocity, velocity with the old force
  semi_implicit_euler,  ///< symplectic Euler: velocity with the old force, position with the new
                        ///< velocity
  implicit_damper,      ///< the same, but with the damping force of the new velocity
  implicit_euler,       ///< spring and damping force of the new penetration and velocity
  velocity_verlet,      ///< half a velocity update, a whole position update, half a velocity update
                        ///< with the force of the new position and the velocity of the middle
  position_verlet,      ///< half a position update, a whole velocity update, half a position update
  runge_kutta_4         ///< the classical Runge–Kutta step: four force evaluations
};

/// Penetration and velocity of a body along the normal of a contact.
template <Ring S>
struct PenaltyState {
  S penetration = S(0);  ///< m; negative: a gap
  S approach = S(0);     ///< m/s; negative: it separates
};

namespace detail {

template <Scalar S>
PenaltyState<S> free_step(PenaltyScheme scheme, const PenaltyState<S>& now, const S& h,
                          const S& load) {
  const S speed = now.approach + h * load;
  const S moved = h * (scheme == PenaltyScheme::explicit_euler ? now.approach : speed);
  return {now.penetration + moved, speed};
}

/// Whether a scheme of `PenaltyScheme` evaluates the force elsewhere than at the start and the end
/// of a step.
constexpr bool is_staged(PenaltyScheme scheme) {
  return scheme == PenaltyScheme::velocity_verlet || scheme == PenaltyScheme::position_verlet ||
         scheme == PenaltyScheme::runge_kutta_4;
}

}  // namespace detail

// [staged-step]
/// One step of a scheme that evaluates the force within the step: velocity Verlet, position Verlet
/// or the classical Runge–Kutta step. The position of an evaluation is that of the scheme; the
/// velocity is the latest that the scheme has.
/// @param scheme one of the three
/// @param h length of the step, s
/// @param law the acceleration towards the surface at a penetration and an approach, m/s²
template <Scalar S, class Law>
PenaltyState<S> staged_step(PenaltyScheme scheme, const PenaltyState<S>& now, const S& h,
                            const Law& law) {
  const S half = h / S(2);
  const S x = now.penetration;
  const S v = now.approach;
  if (scheme == PenaltyScheme::velocity_verlet) {
    const S middle = v + law(x, v) * half;
    const S moved = x + middle * h;
    return {moved, middle + law(moved, middle) * half};
  }
  if (scheme == PenaltyScheme::position_verlet) {
    const S middle = x + v * half;
    const S speed = v + law(middle, v) * h;
    return {middle + speed * half, speed};
  }
  const S a1 = law(x, v);
  const S v2 = v + a1 * half;
  const S a2 = law(S(x + v * half), v2);
  const S v3 = v + a2 * half;
  const S a3 = law(S(x + v2 * half), v3);
  const S v4 = v + a3 * h;
  const S a4 = law(S(x + v3 * h), v4);
  return {x + (v + (v2 + v3) * S(2) + v4) * (h / S(6)),
          v + (a1 + (a2 + a3) * S(2) + a4) * (h / S(6))};
}
// [/staged-step]

// [spring-step]
/// One step of a mass that stays attached to a spring and a damper, which push and pull: a linear
/// map.
/// @param mass kg, greater than 0
/// @param h length of the step, s, greater than 0
/// @param load acceleration towards the surface by other forces, such as gravity, m/s²
template <Scalar S>
PenaltyState<S> spring_step(PenaltyScheme scheme, const PenaltyState<S>& now,
                            const SpringDamper<S>& spring, const S& mass, const S& h,
                            const S& load) {
  if (detail::is_staged(scheme)) {
    return staged_step(scheme, now, h, [&](const S& x, const S& v) {
      return S(load - (spring.stiffness * x + spring.damping * v) / mass);
    });
  }
  const S pull = load - spring.stiffness * now.penetration / mass;  // without the damper
  const S damper = h * spring.damping / mass;
  const S carried = now.approach + h * pull;
  if (scheme == PenaltyScheme::explicit_euler || scheme == PenaltyScheme::semi_implicit_euler) {
    const S speed = carried - damper * now.approach;
    const bool old = scheme == PenaltyScheme::explicit_euler;
    return {now.penetration + h * (old ? now.approach : speed), speed};
  }
  S divisor = S(1) + damper;
  if (scheme == PenaltyScheme::implicit_euler) divisor = divisor + h * h * spring.stiffness / mass;
  const S speed = carried / divisor;
  return {now.penetration + h * speed, speed};
}
// [/spring-step]

// [penalty-step]
/// One step of a body at a contact: spring and damper act if it touches or overlaps at the start of
/// the step. A scheme with several force evaluations asks contact_force() at each instead.
/// @param rule with ContactRelease::at_zero_force, a step in which the contact would pull in total
/// is taken without the contact; with several evaluations, none of them pulls
/// @param h s, greater than 0; mass and load as for spring_step()
template <Scalar S>
PenaltyState<S> penalty_step(PenaltyScheme scheme, const PenaltyState<S>& now,
                             const SpringDamper<S>& spring, const S& mass, const S& h,
                             const S& load, ContactRelease rule = ContactRelease::at_zero_force) {
  if (detail::is_staged(scheme)) {
    return staged_step(scheme, now, h, [&](const S& x, const S& v) {
      return S(load - contact_force(spring, x, v, rule) / mass);
    });
  }
  const PenaltyState<S> without = detail::free_step(scheme, now, h, load);
  if (now.penetration < S(0)) return without;
  const PenaltyState<S> with = spring_step(scheme, now, spring, mass, h, load);
  if (rule == ContactRelease::at_zero_force && with.approach > without.approach) return without;
  return with;
}
// [/penalty-step]

/// Stability of a step: the behaviour of a body on a spring after many steps.
enum class StepBehaviour {
  decays,   ///< it converges to rest
  bounded,  ///< it neither converges nor diverges
  grows     ///< it diverges: the step is too long
};

namespace detail {

/// What decides the stability of a step's matrix, with trace T and determinant D: each up to a
/// positive factor, without rounding if S does not round.
template <Ring S>
struct StabilityTerms {
  S below_one;        ///< 1 − D
  S above_minus_one;  ///< 1 + T + D
  S one_minus_trace;  ///< 1 − T + D
};

/// The terms of the classical Runge–Kutta step R(z) = 1 + z + z²/2 + z³/6 + z⁴/24 at the two roots
/// of z² + b z + a. T and D are symmetric in the roots, so power sums of the roots give them.
/// @param m mass, kg
/// @param a h² k
/// @param b h c
template <Ring S>
StabilityTerms<S> runge_kutta_terms(const S& m, const S& a, const S& b) {
  constexpr std::array<int, 5> weight{24, 24, 12, 4, 1};
  std::array<S, 9> mass{S(1)};     // powers of m
  std::array<S, 5> product{S(1)};  // of z₁ z₂ m²
  std::array<S, 5> sum{S(2), -b};  // z₁ⁿ + z₂ⁿ, times mⁿ
  for (std::size_t i = 1; i < 9; ++i) mass[i] = mass[i - 1] * m;
  for (std::size_t i = 1; i < 5; ++i) product[i] = product[i - 1] * (a * m);
  for (std::size_t i = 2; i < 5; ++i) sum[i] = -(b * sum[i - 1]) - a * m * sum[i - 2];
  S trace(0);        // 24 T m⁴
  S determinant(0);  // 576 D m⁸
  for (std::size_t i = 0; i < 5; ++i) {
    trace = trace + S(weight[i]) * sum[i] * mass[4 - i];
    determinant = determinant + S(weight[i] * weight[i]) * product[i] * mass[8 - 2 * i];
    for (std::size_t j = i + 1; j < 5; ++j) {
      determinant =
          determinant + S(weight[i] * weight[j]) * product[i] * sum[j - i] * mass[8 - i - j];
    }
  }
  const S one = S(576) * mass[8];
  const S scaled = S(24) * mass[4] * trace;
  return {one - determinant, one + scaled + determinant, one - scaled + determinant};
}

/// The terms of every scheme.
/// @param m mass, kg
/// @param a h² k
/// @param b h c
template <Ring S>
StabilityTerms<S> stability_terms(PenaltyScheme scheme, const S& m, const S& a, const S& b) {
  const S twice = S(2) * b;
  switch (scheme) {
    case PenaltyScheme::explicit_euler:
      return {b - a, S(4) * m + a - twice, a};
    case PenaltyScheme::semi_implicit_euler:
    case PenaltyScheme::position_verlet:
      return {b, S(4) * m - a - twice, a};
    case PenaltyScheme::implicit_damper:
      return {b, S(4) * m + twice - a, a};
    case PenaltyScheme::implicit_euler:
      return {a + b, S(4) * m + twice + a, a};
    case PenaltyScheme::velocity_verlet: {
      const S rest = S(4) * m - b;
      return {b * rest, S(16) * m * m - S(8) * b * m + twice * b - a * rest, a * rest};
    }
    case PenaltyScheme::runge_kutta_4:
      break;
  }
  return runge_kutta_terms(m, a, b);
}

}  // namespace detail

// [step-behaviour]
/// The stability of the steps of spring_step(), for every start. Exact for the stored numbers.
///
/// With a = h² k / m and b = h c / m a step is a matrix with trace T and determinant D. The motion
/// decays if D < 1 and |T| < 1 + D:
///
/// | | decays if |
/// |---|---|
/// | explicit Euler | a < b and 2 b < 4 + a |
/// | semi-implicit Euler, position Verlet | 0 < b and a + 2 b < 4 |
/// | implicit damper | 0 < b and a < 4 + 2 b |
/// | implicit Euler | always |
/// | velocity Verlet | 0 < b < 4 and a (4 − b) < 16 − 8 b + 2 b² |
/// | Runge–Kutta | the polynomial R of the step has \|R(z)\| < 1 at both roots of z² + b z + a |
///
/// If D = 1 or |T| = 1 + D, an eigenvalue is on the unit circle, and the motion stays bounded. If
/// both hold, 1 or −1 is a double eigenvalue of a matrix that is not a multiple of the identity,
/// and the motion grows linearly with the number of steps: explicit Euler with a = b = 4, the
/// schemes with a = 4 and b = 0, velocity Verlet with b = 4. Runge–Kutta never has |T| = 1 + D: no
/// root of R = 1 or R = −1 but 0 is a root of a quadratic with fractions, because
/// z³ + 4 z² + 12 z + 24 and z⁴ + 4 z³ + 12 z² + 24 z + 48 do not factor over the fractions.
/// @param mass kg, greater than 0
/// @param h s, greater than 0
template <Ring S>
StepBehaviour step_behaviour(PenaltyScheme scheme, const SpringDamper<S>& spring, const S& mass,
                             const S& h) {
  using T = decltype(detail::unrounded(mass));
  const T step = detail::unrounded(h);
  const T a = step * step * detail::unrounded(spring.stiffness);  // times m, like b
  const T b = step * detail::unrounded(spring.damping);
  const auto terms = detail::stability_terms<T>(scheme, detail::unrounded(mass), a, b);
  const T zero(0);
  if (terms.below_one < zero || terms.above_minus_one < zero || terms.one_minus_trace < zero) {
    return StepBehaviour::grows;
  }
  const bool on_circle = terms.below_one == zero;
  const bool at_one = terms.above_minus_one == zero || terms.one_minus_trace == zero;
  if (on_circle && at_one) return StepBehaviour::grows;
  return on_circle || at_one ? StepBehaviour::bounded : StepBehaviour::decays;
}
// [/step-behaviour]

namespace detail {

/// The first step that grows, by bisection with step_behaviour() until no number lies between.
/// @param low does not grow
/// @param high grows, and between the two the behaviour changes once
template <std::floating_point S>
S first_growing_step(PenaltyScheme scheme, const SpringDamper<S>& spring, const S& mass, S low,
                     S high) {
  for (;;) {
    const S middle = low + (high - low) / S(2);
    if (!(middle > low && middle < high)) return high;
    const bool grows = step_behaviour(scheme, spring, mass, middle) == StepBehaviour::grows;
    (grows ? high : low) = middle;
  }
}

/// Whether damped velocity Verlet has a range of steps below 4 m / c that grow: whether
/// k m y³ + (2 c² − 4 k m) y² − 8 c² y + 16 c² has two roots y > 0, by its discriminant. Exact.
template <std::floating_point S>
bool verlet_grows_early(const SpringDamper<S>& spring, const S& mass) {
  const Exact a = unrounded(spring.stiffness) * unrounded(mass);
  const Exact square = unrounded(spring.damping) * unrounded(spring.damping);
  const Exact b = Exact(2) * square - Exact(4) * a;
  const Exact c = Exact(-8) * square;
  const Exact d = Exact(16) * square;
  const Exact discriminant = Exact(18) * a * b * c * d - Exact(4) * b * b * b * d + b * b * c * c -
                             Exact(4) * a * c * c * c - Exact(27) * a * a * d * d;
  return discriminant.sign() > 0;
}

/// The limit of damped velocity Verlet. In y = h c / m the step grows where
/// r(y) = (2 y² − 8 y + 16) / (y² (4 − y)) < k m / c², or y > 4. r falls up to the root
/// y = 2.41… of y³ − 8 y² + 40 y − 64 and rises beyond. So up to there the behaviour changes at
/// most once.
/// No step with a < 3.3 and b < 4 grows, and all with a = 9 and b < 2.41… do; half of the upper end
/// has a ≤ 9/4.
template <std::floating_point S>
S verlet_limit(const SpringDamper<S>& spring, const S& mass) {
  if (!verlet_grows_early(spring, mass)) return S(4) * (mass / spring.damping);
  const S lowest = S(2.413566989055631) * (mass / spring.damping);
  const S root = std::sqrt(mass) / std::sqrt(spring.stiffness);
  const S high = std::min(lowest, S(S(3) * root));
  const auto scheme = PenaltyScheme::velocity_verlet;
  if (step_behaviour(scheme, spring, mass, high) != StepBehaviour::grows) return high;
  return first_growing_step(scheme, spring, mass, S(high / S(2)), high);
}

/// The limit of the classical Runge–Kutta step. With λ the larger of the two rates it is between
/// 2.5 / λ and 3.5 / λ. The behaviour changes once there: on real rates R(z) = 1 only at z = 0 and
/// z = −2.785…, and along a ray of complex rates |R|² crosses 1 once (the tests prove it by
/// intervals).
template <std::floating_point S>
S runge_kutta_limit(const SpringDamper<S>& spring, const S& mass) {
  const S discriminant = rounded<S>(damping_discriminant(spring, mass));
  const S rate = discriminant > S(0) ? S((spring.damping + std::sqrt(discriminant)) / S(2) / mass)
                                     : S(std::sqrt(spring.stiffness) / std::sqrt(mass));
  return first_growing_step(PenaltyScheme::runge_kutta_4, spring, mass, S(S(2.5) / rate),
                            S(S(3.5) / rate));
}

}  // namespace detail

// [step-limit]
/// The stability limit: the greatest lower bound of the steps for which step_behaviour() is
/// `grows`. Every shorter step decays, or stays bounded without a damper; the limit itself may grow
/// or stay bounded. 0: with explicit Euler and without a damper every step grows. ∞: no step does.
///
/// Semi-implicit Euler: 4 m / (c + √(c² + 4 k m)), which is 2 √(m / k) without a damper; a damper
/// reduces it. Explicit Euler: c / k while c² ≤ 4 k m, else 4 m / (c + √(c² − 4 k m)).
/// Implicit damper: (c + √(c² + 4 k m)) / k. Position Verlet has the limit of semi-implicit Euler.
/// Velocity Verlet and Runge–Kutta have the root of a polynomial of degree 3 and 7: bisection with
/// the exact decision brackets it between neighbouring numbers of the type. Without a damper it is
/// 2 √(m / k) and 2 √2 √(m / k).
/// @note Velocity Verlet, damped below ζ = 0.52…, has longer steps that do not grow: the limit is
/// where the first range of steps that do begins. Above that ratio it is 4 m / c.
/// @param mass kg, greater than 0
/// @return s; relative error at most 8 u if k, m and c² are from 1e-120 to 1e120 (in double; 1e-15
/// to 1e15 in float)
template <std::floating_point S>
S step_limit(PenaltyScheme scheme, const SpringDamper<S>& spring, const S& mass) {
  const S k = spring.stiffness;
  const S c = spring.damping;
  if (scheme == PenaltyScheme::implicit_euler) return std::numeric_limits<S>::infinity();
  if (scheme == PenaltyScheme::explicit_euler) {
    const S discriminant = rounded<S>(detail::damping_discriminant(spring, mass));
    if (!(discriminant > S(0))) return c / k;
    return S(4) * mass / (c + std::sqrt(discriminant));
  }
  if (scheme == PenaltyScheme::runge_kutta_4) return detail::runge_kutta_limit(spring, mass);
  if (scheme == PenaltyScheme::velocity_verlet && c > S(0)) {
    return detail::verlet_limit(spring, mass);
  }
  const S sum = c + std::sqrt(c * c + S(4) * k * mass);
  return scheme == PenaltyScheme::implicit_damper ? S(sum / k) : S(S(4) * mass / sum);
}
// [/step-limit]

/// Bounds on the change of the kinetic energy by an impact in steps.
template <Scalar S>
struct EnergyFactor {
  S min = S(1);  ///< lower bound of the energy after over the energy before
  S max = S(1);  ///< upper bound
};

// [energy-factor]
/// Bounds on the factor by which one impact on an undamped spring, without load, in steps of
/// semi-implicit Euler changes the kinetic energy: from 1 − a/4 to 1 / (1 − a/4), with
/// a = h² k / m < 4.
///
/// v² + ω₀² d² − h ω₀² d v is an invariant of the steps. At the first step with an overlap, d is
/// between 0 and h v, so the invariant is between (1 − a/4) v² and v². The same holds for the speed
/// after the last step with an overlap. Only an overlap of h v / 2 at the first or at the last step
/// can give the extreme values, and for most a no bounce reaches them: with a = 1 every bounce
/// keeps its energy. The penetration is at most v √(m / k) / √(1 − a/4).
/// @param mass kg, greater than 0
/// @param h s, greater than 0 and below step_limit()
/// @note The bounds do not hold with a damper, which removes energy in addition.
template <Scalar S>
EnergyFactor<S> stepped_energy_factor(const SpringDamper<S>& spring, const S& mass, const S& h) {
  const S least = S(1) - h * h * spring.stiffness / mass / S(4);
  return {least, S(1) / least};
}

/// A step with which every such impact changes the kinetic energy by at most the fraction ε:
/// √(4 ε m / ((1 + ε) k)), the longest for which the bounds say so. With shorter steps it does not
/// change more, nor with some longer ones. An impact takes about π / √a steps, so for half the ε it
/// needs √2 times as many.
/// @param mass kg, greater than 0
/// @param share ε, greater than 0
/// @return s; relative error at most 6 u
template <std::floating_point S>
S step_for_energy(const SpringDamper<S>& spring, const S& mass, const S& share) {
  return S(2) * std::sqrt(share / (S(1) + share)) * (std::sqrt(mass) / std::sqrt(spring.stiffness));
}
// [/energy-factor]

}  // namespace contact
