/// @file
/// Bodies that gain or lose matter: rain into a wagon, sand out of it, a rocket.
#pragma once

#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>

#include <contact/exact.hpp>
#include <contact/vector.hpp>

namespace contact {

// [acceleration]
/// The acceleration of a body that matter joins or leaves: m dv/dt = F + u dm/dt.
///
/// u is the velocity of the matter *relative to the body*, just before it joins or just after it
/// has left. F = dp/dt with p the momentum of the body alone has −v instead of u, which is right
/// only for matter at rest over the ground.
/// @param mass now, kg, greater than 0
/// @param force from outside, N
/// @param relative velocity u of the matter relative to the body, m/s
/// @param mass_rate dm/dt, kg/s: positive for what joins, negative for what leaves
/// @return m/s²
template <Scalar S>
Vector3<S> acceleration_with_exchange(const S& mass, const Vector3<S>& force,
                                      const Vector3<S>& relative, const S& mass_rate) {
  return (force + relative * mass_rate) / mass;
}
// [/acceleration]

// [exchange]
/// The velocity of a body after matter has joined it or left it at one instant.
///
/// The total momentum of both is conserved: (m + Δm) v' = m v + Δm w, so v' = v + (w − v) Δm /
/// (m + Δm). No external force acts.
/// @param mass before, kg, greater than 0
/// @param velocity before, m/s
/// @param mass_change Δm, kg: positive for what joins, negative for what leaves
/// @param matter_velocity w over the ground, m/s: before it joins, or after it has left
/// @return m/s, or nothing if no mass would be left. In a floating-point type the error is at most
/// 4 u of |v| + |w − v| |Δm| / (m + Δm); never NaN
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
/// The speed that a rocket gains by ejecting mass backwards in a steady stream, u ln(m₀ / m₁)
/// (Tsiolkovsky's rocket equation). No external force acts.
/// @param exhaust_speed u of the ejected matter relative to the rocket, m/s
/// @param mass_before m₀, kg, greater than 0
/// @param mass_after m₁, kg, greater than 0 and not above m₀
/// @return m/s. Near m₁ = m₀ the difference is taken first, so that nothing cancels
template <std::floating_point S>
S rocket_speed_gain(const S& exhaust_speed, const S& mass_before, const S& mass_after) {
  return exhaust_speed * std::log1p((mass_before - mass_after) / mass_after);
}
// [/rocket]

namespace detail {

/// artanh(z) / z by its series 1 + z²/3 + z⁴/5 + …, for |z| of at most 1/5, with the same bits on
/// every machine.
template <std::floating_point S>
S artanh_over(const S& z) {
  const S square = z * z;
  S sum(0);
  for (int term = 25; term >= 1; term -= 2) sum = sum * square + S(1) / S(term);
  return sum;
}

/// ln(1 + x) / x, which is 1 at 0.
/// @param x finite, above −1
/// @return with an error of at most 8 u of itself
template <std::floating_point S>
S logarithm_over(const S& x) {
  if (std::abs(x) <= S(1) / S(3)) {  // ln(1 + x) = 2 artanh(x / (2 + x))
    return S(2) / (S(2) + x) * artanh_over(S(x / (S(2) + x)));
  }
  int power = 0;
  S share = std::frexp(S(1) + x, &power);  // in [1/2, 1); then in [1/√2, √2)
  if (share < std::numbers::sqrt2_v<S> / S(2)) {
    share *= S(2);
    --power;
  }
  const S z = (share - S(1)) / (share + S(1));
  return (S(power) * std::numbers::ln2_v<S> + S(2) * z * artanh_over(z)) / x;
}

/// (x − ln(1 + x)) / x², which is 1/2 at 0: ∫₀¹ s / (1 + s x) ds.
/// @param x finite, above −1
/// @return with an error of at most 40 u of itself
template <std::floating_point S>
S logarithm_rest_over(const S& x) {
  if (std::abs(x) > S(1) / S(3)) return (S(1) - logarithm_over(x)) / x;
  // The difference would cancel. With z = x / (2 + x) it is z² (2 + x) − 2 z³ (1/3 + z²/5 + …).
  const S z = x / (S(2) + x);
  S sum(0);
  for (int term = 27; term >= 3; term -= 2) sum = sum * (z * z) + S(1) / S(term);
  return (S(1) - S(2) * z / (S(2) + x) * sum) / (S(2) + x);
}

}  // namespace detail

// [steady]
/// A body after a steady stream of matter has joined it, or left it, for a while.
template <std::floating_point S>
struct AfterStream {
  S mass = S(0);                                 ///< kg
  Vector3<S> velocity = Vector3<S>::Zero();      ///< m/s
  Vector3<S> displacement = Vector3<S>::Zero();  ///< displacement, m
  Vector3<S> carried_off = Vector3<S>::Zero();   ///< momentum of the matter that has left, minus
                                                 ///< that of the matter that has joined, kg·m/s
};

/// The motion while matter leaves or joins at a steady rate and with a steady velocity *relative to
/// the body*: a rocket (Tsiolkovsky) on which a force may act as well.
///
/// m dv/dt = F + u dm/dt gives v = v₀ + (F + u ṁ) ln(m₀ / m) / (−ṁ), and a second integration gives
/// the displacement. Both are written so that nothing cancels for a small ṁ; ṁ = 0 is a constant
/// force.
/// @param mass at first, m₀, kg, greater than 0
/// @param velocity at first, v₀, m/s
/// @param force external, constant, N
/// @param relative velocity u of the matter relative to the body, m/s
/// @param mass_rate ṁ, kg/s: positive for what joins, negative for what leaves
/// @param time t, s, 0 or more
/// @return nothing if no mass would be left. If ṁ t and m₀ + ṁ t are exact and nothing overflows,
/// the error of the velocity is at most 16 u of |v₀| + (|F| + |u ṁ|) ln(m₀ / m) / |ṁ|, and that of
/// the displacement at most 64 u of the integral of that
template <std::floating_point S>
std::optional<AfterStream<S>> after_stream_from_body(const S& mass, const Vector3<S>& velocity,
                                                     const Vector3<S>& force,
                                                     const Vector3<S>& relative, const S& mass_rate,
                                                     const S& time) {
  const S change = mass_rate * time;
  const S left = mass + change;
  if (!(left > S(0))) return std::nullopt;
  const S x = -change / left;  // m₀ / m = 1 + x
  const Vector3<S> net_force = force + relative * mass_rate;
  AfterStream<S> after;
  after.mass = left;
  after.velocity = velocity + net_force * (time / left * detail::logarithm_over(x));
  after.displacement =
      velocity * time + net_force * (time / left * time * detail::logarithm_rest_over(x));
  after.carried_off = (after.displacement + relative * time) * -mass_rate;
  return after;
}

/// The motion while matter joins or leaves at a steady rate and with a steady velocity *over the
/// ground*: rain.
///
/// The total momentum changes by F t: m v = m₀ v₀ + (F + w ṁ) t.
/// @param mass at first, m₀, kg, greater than 0
/// @param velocity at first, v₀, m/s
/// @param force external, constant, N
/// @param matter_velocity w over the ground, m/s: before it joins, or after it has left
/// @param mass_rate ṁ, kg/s: positive for what joins, negative for what leaves
/// @param time t, s, 0 or more
/// @return nothing if no mass would be left. If ṁ t and m₀ + ṁ t are exact and nothing overflows,
/// the error of the velocity is at most 8 u of |v₀| + (|F| + (|v₀| + |w|) |ṁ|) t / m, and that of
/// the displacement at most 64 u of the integral of that
template <std::floating_point S>
std::optional<AfterStream<S>> after_stream_over_ground(const S& mass, const Vector3<S>& velocity,
                                                       const Vector3<S>& force,
                                                       const Vector3<S>& matter_velocity,
                                                       const S& mass_rate, const S& time) {
  const S change = mass_rate * time;
  const S left = mass + change;
  if (!(left > S(0))) return std::nullopt;
  const Vector3<S> net_force = force + (matter_velocity - velocity) * mass_rate;
  AfterStream<S> after;
  after.mass = left;
  after.velocity = velocity + net_force * (time / left);
  after.displacement =
      velocity * time +
      net_force * (time / mass * time * detail::logarithm_rest_over(S(change / mass)));
  after.carried_off = matter_velocity * -change;
  return after;
}
// [/steady]

}  // namespace contact
