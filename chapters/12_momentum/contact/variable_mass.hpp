/// @file
/// Bodies that gain or lose matter: rain into a wagon, sand out of it, a rocket.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include <contact/exact.hpp>
#include <contact/vector.hpp>

namespace contact {

// [acceleration]
/// The acceleration of a body that matter joins or leaves: m dv/dt = F + u dm/dt.
///
/// The matter that comes or goes is part of the system for an instant, and its velocity counts: u
/// is its velocity *as seen from the body* just before it joins, or just after it has left. F =
/// dp/dt with p the momentum of the body alone would put −v in place of u, which is right only for
/// matter that is at rest over the ground.
/// @param mass now, kg, greater than 0
/// @param force from outside, N
/// @param relative velocity u of the matter as seen from the body, m/s
/// @param mass_rate dm/dt, kg/s: positive for what joins, negative for what leaves
/// @return m/s²
template <Scalar S>
Vector3<S> acceleration_with_exchange(const S& mass, const Vector3<S>& force,
                                      const Vector3<S>& relative, const S& mass_rate) {
  return (force + relative * mass_rate) / mass;
}
// [/acceleration]

// [exchange]
/// The velocity of a body after matter has joined it, or left it, at one blow.
///
/// From the momentum of both before and after: (m + Δm) v' = m v + Δm w, so v' = v + (w − v) Δm /
/// (m + Δm). No force acts from outside.
/// @param mass before, kg, greater than 0
/// @param velocity before, m/s
/// @param mass_change Δm, kg: positive for what joins, negative for what leaves
/// @param matter_velocity w over the ground, m/s: before it joins, or after it has left
/// @return m/s, or nothing if no mass would be left. In a floating-point type off by 4 u of |v| +
/// |w − v| |Δm| / (m + Δm); never NaN
template <Scalar S>
std::optional<Vector3<S>> velocity_after_exchange(const S& mass, const Vector3<S>& velocity,
                                                  const S& mass_change,
                                                  const Vector3<S>& matter_velocity) {
  const S left = mass + mass_change;
  if (!(left > S(0))) return std::nullopt;
  const Vector3<S> after = velocity + (matter_velocity - velocity) * (mass_change / left);
  if constexpr (std::floating_point<S>) {
    // The sum of the masses or the difference of the velocities may overflow though v' does not.
    if (!is_finite(left) || !all_finite(after)) {
      const Exact m{double(mass)};
      const Exact change{double(mass_change)};
      const auto coordinate = [&](int k) {
        return quotient<S>(
            m * Exact(double(velocity(k))) + change * Exact(double(matter_velocity(k))),
            m + change);
      };
      return Vector3<S>(coordinate(0), coordinate(1), coordinate(2));
    }
  }
  return after;
}
// [/exchange]

// [rocket]
/// How much faster a rocket gets, u ln(m₀ / m₁), when it throws its mass backwards grain by grain
/// (Tsiolkovsky). No force acts from outside.
/// @param exhaust_speed u of what is thrown, as seen from the rocket, m/s
/// @param mass_before m₀, kg, greater than 0
/// @param mass_after m₁, kg, greater than 0 and not above m₀
/// @return m/s. Near m₁ = m₀ the difference is taken first, so that nothing cancels
template <std::floating_point S>
S rocket_speed_gain(const S& exhaust_speed, const S& mass_before, const S& mass_after) {
  return exhaust_speed * std::log1p((mass_before - mass_after) / mass_after);
}
// [/rocket]

}  // namespace contact
