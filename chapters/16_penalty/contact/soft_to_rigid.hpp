/// @file
/// From soft to rigid: the motion and the force of an impact over time, its impulse, which is the
/// same for every stiffness, and how far a stiff contact is from the jump of a rigid one.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/penalty_step.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/spring_damper.hpp>
#include <contact/spring_impact.hpp>

namespace contact {

namespace detail {

/// e^(−γ t) cos(ω_d t) and e^(−γ t) sin(ω_d t) / ω_d, for a damped and for an overdamped spring
/// alike.
struct DampedWave {
  double cosine;  ///< dimensionless
  double sine;    ///< s
};

/// With w = (ω₀² − γ²) t²: below 1 by the power series of cos √w and sin √w / √w, which do not need
/// its sign; else by sines, or by two exponentials, of which the slower has the rate
/// ω₀² / (γ + √(γ² − ω₀²)), so nothing cancels.
/// @param gamma γ = c / (2 m), 1/s
/// @param square ω₀², 1/s²
/// @param rate √|ω₀² − γ²|, 1/s; its square may overflow
/// @param underdamped whether ω₀ > γ
/// @param t s, 0 or more
inline DampedWave damped_wave(double gamma, double square, double rate, bool underdamped,
                              double t) {
  const double turned = rate * t;
  const double w = underdamped ? turned * turned : -turned * turned;
  if (std::abs(w) <= 1) {
    double c = 0;
    double s = 0;
    for (int k = 9; k >= 1; --k) {
      c = -w * (1 + c) / (2 * k * (2 * k - 1));
      s = -w * (1 + s) / (2 * k * (2 * k + 1));
    }
    const double left = decay(gamma * t);
    return {left * (1 + c), left * t * (1 + s)};
  }
  if (underdamped) {
    const SineCosine<double> turn = sine_cosine(turned);
    const double left = decay(gamma * t);
    return {left * turn.cosine, left * turn.sine / rate};
  }
  const double slow = decay(square / (gamma + rate) * t);
  const double fast = decay((gamma + rate) * t);
  return {(slow + fast) / 2, (slow - fast) / 2 / rate};
}

}  // namespace detail

// [damped-motion]
/// The exact motion of a mass that stays attached to a spring and a damper, after a time t ≥ 0, in
/// closed form for every damping ratio:
/// x = x₀ (C + γ S) + v₀ S and v = v₀ (C − γ S) − ω₀² x₀ S, with C = e^(−γ t) cos ω_d t and
/// S = e^(−γ t) sin ω_d t / ω_d, measured from the equilibrium.
/// @param start at time 0
/// @param mass kg, greater than 0
/// @param load acceleration towards the surface by other forces, such as gravity, m/s²
/// @param t s
/// @return the penetration with an error of at most (60 + 8 (ω₀ + γ) t) u of double times
/// (1 + ζ) (|x₀| + |v₀| / ω₀ + |load| / ω₀²), plus the rounding to S, and the velocity with ω₀
/// times that, if k, m and c² are from 1e-120 to 1e120 (in double) or c is 0; without load the
/// state at t = 0 is the start
template <std::floating_point S>
PenaltyState<S> damped_motion(const PenaltyState<S>& start, const SpringDamper<S>& spring,
                              const S& mass, const S& load, const S& t) {
  const auto m = static_cast<double>(mass);
  const double gamma = static_cast<double>(spring.damping) / 2 / m;
  const double square = static_cast<double>(spring.stiffness) / m;
  const double difference = rounded<double>(-detail::damping_discriminant(spring, mass));
  const double rate = std::sqrt(std::abs(difference)) / 2 / m;
  const auto wave =
      detail::damped_wave(gamma, square, rate, difference > 0, static_cast<double>(t));
  const double sag = static_cast<double>(load) / square;
  const double x = static_cast<double>(start.penetration) - sag;
  const auto v = static_cast<double>(start.approach);
  return {S(sag + (x * (wave.cosine + gamma * wave.sine) + v * wave.sine)),
          S(v * (wave.cosine - gamma * wave.sine) - square * x * wave.sine)};
}
// [/damped-motion]

// [impact-at]
/// Penetration, approach and force at a time of an impact on a spring and a damper. Its first touch
/// is at time 0; no other force acts.
template <std::floating_point S>
struct ImpactMoment {
  PenaltyState<S> state;  ///< without contact: of a free body that starts where the contact ended
  S force = S(0);         ///< N, positive if it pushes; 0 without contact
  bool touching = false;  ///< whether the contact lasts at that time
};

/// The impact of spring_impact() at a time t ≥ 0.
///
/// With at_zero_force the force is never negative: the state at the end of the contact is that of
/// SpringImpact, and then the body flies. With at_zero_penetration the last part of the force is a
/// pull.
/// @param mass kg, greater than 0
/// @param speed speed of approach at the first touch, m/s, 0 or more
/// @param t s
/// @return the state with the error of damped_motion(), the force with k and c times that
template <std::floating_point S>
ImpactMoment<S> impact_at(const SpringDamper<S>& spring, const S& mass, const S& speed, const S& t,
                          ContactRelease rule = ContactRelease::at_zero_force) {
  const SpringImpact<S> impact = spring_impact(spring, mass, speed, rule);
  if (t <= impact.duration) {
    const auto state = damped_motion(PenaltyState<S>{S(0), speed}, spring, mass, S(0), t);
    const S force = spring.stiffness * state.penetration + spring.damping * state.approach;
    const bool none = rule == ContactRelease::at_zero_force && force < S(0);
    return {state, none ? S(0) : force, true};
  }
  const S leaving = impact.restitution * speed;
  return {{impact.left_overlap - leaving * (t - impact.duration), -leaving}, S(0), false};
}
// [/impact-at]

// [contact-impulse]
/// The impulse of an impact, the area under its force over time: m (1 + e) v, with the restitution
/// e of spring_impact().
///
/// The stiffness does not occur: the force is m times the change of velocity per time, so its
/// integral is m times the whole change, from v to −e v. e depends on the damping ratio only. It is
/// the impulse that a rigid impact with the same restitution applies at once.
/// @param mass kg, greater than 0
/// @param speed v, m/s, 0 or more
/// @return N·s; relative error at most (110 + 100 y) u, with y the exponent of e
template <std::floating_point S>
S contact_impulse(const SpringDamper<S>& spring, const S& mass, const S& speed,
                  ContactRelease rule = ContactRelease::at_zero_force) {
  return mass * ((S(1) + spring_impact(spring, mass, speed, rule).restitution) * speed);
}
// [/contact-impulse]

// [stiffened]
/// The same contact, harder: the stiffness times f², the damping times f. The damping ratio, and so
/// restitution and impulse, stay; duration and depth are divided by f, and the greatest force is
/// multiplied by f. For f without limit the velocity becomes the jump of a rigid impact.
/// @param factor f, greater than 0
/// @throws std::invalid_argument if factor is not greater than 0, or a product overflows or, of
/// numbers greater than 0, underflows to 0
template <Ring S>
SpringDamper<S> stiffened(const SpringDamper<S>& spring, const S& factor) {
  require_finite("factor", factor);
  if (!(factor > S(0))) throw_invalid_argument("factor", number_text(factor), "must be above 0");
  const S damping = spring.damping * factor;
  if (spring.damping > S(0) && !(damping > S(0))) {
    throw_invalid_argument("factor", number_text(factor), "the damping underflows");
  }
  return spring_damper<S>(spring.stiffness * factor * factor, damping);
}
// [/stiffened]

/// How far a soft bounce under gravity is from the rigid jump at the first touch.
template <std::floating_point S>
struct JumpDifference {
  S delay = S(0);     ///< duration of the contact, s: the soft flight is the rigid one, later by it
  S velocity = S(0);  ///< difference of the velocities while both fly, m/s
  S position = S(0);  ///< bound on the difference of the heights while both fly, m
};

// [jump-difference]
/// An undamped contact under gravity against the jump from v to −v of a rigid one.
///
/// The contact lasts T = 2 (π − β) / ω₀ with tan β = ω₀ v / g, and by energy the body leaves with
/// the speed v exactly. So it flies as the rigid one does, later by T: the velocities differ by
/// g T, and the heights by at most v T, since no flight is faster than v. T is at most 2 π / ω₀:
/// all three shrink as 1 / √k.
/// @param stiffness k, N/m, greater than 0
/// @param mass kg, greater than 0
/// @param speed v at the first touch, m/s, greater than 0
/// @param gravity g towards the surface, m/s², 0 or more
/// @return each with a relative error of at most 60 u, without overflow and underflow
template <std::floating_point S>
JumpDifference<S> jump_difference(const S& stiffness, const S& mass, const S& speed,
                                  const S& gravity) {
  const double rate = natural_frequency(SpringDamper<double>{static_cast<double>(stiffness), 0},
                                        static_cast<double>(mass));
  const double turned = rate * static_cast<double>(speed);
  const auto g = static_cast<double>(gravity);
  const double large = std::fmax(turned, g);
  const double opposite = turned / large;
  const double adjacent = g / large;
  const double length = std::sqrt(opposite * opposite + adjacent * adjacent);
  const double beta = opposite / length * arc_over_sine(adjacent / length);
  const double delay = 2 * (detail::pi - beta) / rate;
  return {S(delay), S(g * delay), S(static_cast<double>(speed) * delay)};
}
// [/jump-difference]

// [gravity-bound]
/// A bound on what gravity changes in the velocity at equal times, as long as the damped contact
/// lasts both with gravity and without: g √e / ω₀, with e the restitution at zero force. Gravity
/// can make the contact longer, or keep the body from leaving at all; the bound says nothing of
/// that.
///
/// While the body is attached, the motion with gravity is that without, x(t), plus g / v times the
/// integral of x: this solves the equation of motion, which is linear, from the same start. So the
/// velocities at equal times differ by g x(t) / v exactly, and x is at most v √e / ω₀. Where the
/// impact without gravity ends at zero penetration, they are equal.
/// @param mass kg, greater than 0
/// @param gravity g, m/s², 0 or more
/// @return m/s, shrinks as 1 / √k; relative error at most (100 + 100 y) u, with y the exponent of e
template <std::floating_point S>
S gravity_velocity_bound(const SpringDamper<S>& spring, const S& mass, const S& gravity) {
  return gravity * spring_impact(spring, mass, S(1)).max_depth;
}
// [/gravity-bound]

}  // namespace contact
