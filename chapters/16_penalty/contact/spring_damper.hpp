/// @file
/// A compliant (soft) contact: a spring and a damper between two surfaces, its force and its
/// energy.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/momentum.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A spring and a damper in parallel (Kelvin–Voigt), which push two surfaces apart while they
/// overlap. Make it with spring_damper(), which checks its arguments.
template <Ring S>
struct SpringDamper {
  S stiffness = S(1);  ///< force per penetration, N/m, greater than 0
  S damping = S(0);    ///< force per speed of approach, N·s/m, not negative
};

/// A spring and a damper.
/// @param stiffness N/m, greater than 0
/// @param damping N·s/m, 0 or more
/// @throws std::invalid_argument if a number is out of its range or not finite
template <Ring S>
SpringDamper<S> spring_damper(const S& stiffness, const S& damping) {
  require_finite("stiffness", stiffness);
  require_finite("damping", damping);
  if (!(stiffness > S(0))) {
    throw_invalid_argument("stiffness", number_text(stiffness), "must be greater than 0");
  }
  if (damping < S(0)) {
    throw_invalid_argument("damping", number_text(damping), "must not be negative");
  }
  return {stiffness, damping};
}

// [let-go]
/// When a contact ends. The damper resists separation as well as approach, so near the end the sum
/// of spring and damping force would be a pull.
enum class ContactRelease {
  /// When the force would become a pull. The remaining overlap opens without a force.
  at_zero_force,
  /// When the surfaces no longer overlap. Until then the contact may pull, like glue.
  at_zero_penetration
};
// [/let-go]

// [contact-push]
/// The force of a contact along its normal, k d + c ḋ while the surfaces overlap, else 0.
///
/// Touching counts as contact: at penetration 0 the damper alone pushes, c ḋ. So with damping the
/// force jumps at the first touch.
/// @param penetration d, m; negative: a gap
/// @param approach ḋ, rate of change of the penetration, m/s; negative: the surfaces separate
/// @param rule with ContactRelease::at_zero_force the result is never negative
/// @return N, positive if it pushes the surfaces apart; error at most 3 u (k |d| + c |ḋ|), plus
/// η for products that underflow; 0 for a penetration that is not a number; NaN only if the
/// approach is not a number, one product is ∞ and the other −∞, or one is 0 times ∞ (no damper and
/// an infinite approach)
/// @see *Interaction and Normals*, slide "Collision response – penalty method"
template <Ring S>
S contact_force(const SpringDamper<S>& spring, const S& penetration, const S& approach,
                ContactRelease rule = ContactRelease::at_zero_force) {
  if (!(penetration >= S(0))) return S(0);
  const S force = spring.stiffness * penetration + spring.damping * approach;
  return force < S(0) && rule == ContactRelease::at_zero_force ? S(0) : force;
}
// [/contact-push]

// [spring-energy]
/// The potential energy of the spring: k d² / 2 while the surfaces overlap, else 0. Without damping
/// its sum with the kinetic energy is conserved; a damper dissipates the power c ḋ².
/// @param penetration m; negative: a gap
/// @return J; relative error at most 3 u, without overflow and underflow; 0 for a penetration that
/// is not a number
template <Scalar S>
S contact_spring_energy(const SpringDamper<S>& spring, const S& penetration) {
  if (!(penetration >= S(0))) return S(0);
  return spring.stiffness * penetration * penetration / S(2);
}
// [/spring-energy]

/// The damping regime of a spring, a damper and a mass.
enum class DampingRegime {
  underdamped,  ///< c² < 4 k m: it oscillates about 0
  critical,     ///< c² = 4 k m: it does not oscillate, and from almost every start it returns to 0
                ///< in the end faster than with any other damper
  overdamped    ///< c² > 4 k m: it does not oscillate, and from almost every start it returns more
                ///< slowly
};

namespace detail {

/// Converts a float or double to Exact, whose sums and products do not round; other types are
/// returned unchanged.
template <Ring S>
auto unrounded(const S& x) {
  if constexpr (std::floating_point<S>) {
    return Exact(static_cast<double>(x));
  } else {
    return x;
  }
}

/// c² − 4 k m without rounding.
template <Ring S>
auto damping_discriminant(const SpringDamper<S>& spring, const S& mass) {
  using T = decltype(unrounded(mass));
  const T c = unrounded(spring.damping);
  return T(c * c - T(4) * unrounded(spring.stiffness) * unrounded(mass));
}

}  // namespace detail

// [damping-regime]
/// The damping regime of a contact, by the sign of c² − 4 k m. Exact for the stored numbers.
/// @param mass m of the body on a fixed surface, or reduced_mass() of two bodies, kg, greater than
/// 0
template <Ring S>
DampingRegime damping_regime(const SpringDamper<S>& spring, const S& mass) {
  const auto discriminant = detail::damping_discriminant(spring, mass);
  const auto zero = decltype(discriminant)(0);
  if (discriminant < zero) return DampingRegime::underdamped;
  return discriminant == zero ? DampingRegime::critical : DampingRegime::overdamped;
}

/// The damping ratio ζ = c / (2 √k √m): 0 without damper, 1 at DampingRegime::critical.
/// @param mass kg, greater than 0
/// @return dimensionless; relative error at most 5 u, if damping and ratio are normal numbers or 0;
/// the largest finite number in place of ∞
template <std::floating_point S>
S damping_ratio(const SpringDamper<S>& spring, const S& mass) {
  const S stiff = std::sqrt(spring.stiffness);
  const S heavy = std::sqrt(mass);
  const S halves = spring.damping / S(2) / stiff;
  // One order of the divisions may underflow or overflow where the other does not.
  const S ratio =
      std::isnormal(halves) ? S(halves / heavy) : S(spring.damping / S(2) / heavy / stiff);
  return std::isfinite(ratio) ? ratio : std::numeric_limits<S>::max();
}

/// The natural angular frequency ω₀ = √(k / m) of mass and spring without damper.
/// @param mass kg, greater than 0
/// @return rad/s; relative error at most 3 u
template <std::floating_point S>
S natural_frequency(const SpringDamper<S>& spring, const S& mass) {
  return std::sqrt(spring.stiffness) / std::sqrt(mass);
}
// [/damping-regime]

}  // namespace contact
