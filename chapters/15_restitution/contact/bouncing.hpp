/// @file
/// A ball that bounces on a level floor: the times of its impacts, its height and when it comes to
/// rest, by formula and flight by flight.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/restitution.hpp>
#include <contact/tolerance.hpp>

namespace contact {

/// A ball above a level floor at time 0. Make it with bouncing_ball(), which checks its arguments.
template <Ring S>
struct BouncingBall {
  S height = S(0);       ///< of its lowest point over the floor, m, not negative
  S velocity = S(0);     ///< upwards, m/s
  S gravity = S(0);      ///< m/s², greater than 0, downwards
  S restitution = S(0);  ///< of ball and floor, 0 to 1
};

/// A ball that is dropped or thrown.
/// @param height of its lowest point over the floor, m, 0 or more
/// @param velocity upwards, m/s
/// @param gravity m/s², greater than 0, downwards
/// @param restitution of ball and floor, 0 to 1
/// @throws std::invalid_argument if a number is out of its range or not finite
template <Ring S>
BouncingBall<S> bouncing_ball(const S& height, const S& velocity, const S& gravity,
                              const S& restitution) {
  require_finite("height", height);
  require_finite("velocity", velocity);
  require_finite("gravity", gravity);
  if (height < S(0)) throw_invalid_argument("height", number_text(height), "must not be negative");
  if (!(gravity > S(0))) {
    throw_invalid_argument("gravity", number_text(gravity), "must be greater than 0");
  }
  require_restitution("restitution", restitution);
  return {height, velocity, gravity, restitution};
}

/// A bouncing ball at some time.
template <std::floating_point S>
struct BounceState {
  S height = S(0);       ///< m
  S velocity = S(0);     ///< upwards, m/s; just after the impact if it is one
  S bounces = S(0);      ///< impacts up to this time, this one included; may be infinite
  bool resting = false;  ///< on the floor from now on
};

// [first-impact]
/// The speed at the first impact, √(v² + 2 g h), from the energy.
/// @return m/s; off by at most 4 u of itself, also where the squares would overflow or underflow
template <std::floating_point S>
S impact_speed(const BouncingBall<S>& ball) {
  const S square = ball.velocity * ball.velocity + S(2) * ball.gravity * ball.height;
  const S safe = std::sqrt(std::numeric_limits<S>::min());
  if (square > safe && std::isfinite(square)) return std::sqrt(square);
  if (ball.height == S(0)) return std::abs(ball.velocity);
  // The same scaled by powers of two, which adds no rounding: v = a 2^i and 2 g h = b 2^j, and the
  // larger of v² and 2 g h becomes about 1.
  int i = 0;
  int of_gravity = 0;
  int of_height = 0;
  const S a = std::frexp(ball.velocity, &i);
  const S b = std::frexp(ball.gravity, &of_gravity) * std::frexp(ball.height, &of_height);
  const int j = of_gravity + of_height + 1;
  const int power = a == S(0) ? j / 2 : std::max(i, j / 2);
  return std::ldexp(std::sqrt(std::ldexp(a * a, 2 * (i - power)) + std::ldexp(b, j - 2 * power)),
                    power);
}

/// The time of the first impact: the root of h + v t − g t²/2 that is not negative.
///
/// (v + w) / g with the impact speed w cancels if the ball moves down fast; then the same root is
/// 2 h / (w − v).
/// @return s; off by at most 8 u of itself; 0 for a ball on the floor that does not move up
template <std::floating_point S>
S first_impact_time(const BouncingBall<S>& ball) {
  const S w = impact_speed(ball);
  if (ball.velocity > S(0)) return (ball.velocity + w) / ball.gravity;
  if (ball.height == S(0)) return S(0);
  return ball.height / ((w - ball.velocity) / S(2));
}
// [/first-impact]

namespace detail {

/// 1 + k + k² + … with m terms, and k to the power m.
template <class S>
struct Geometric {
  S sum;
  S power;
};

/// The two series one after the other; all terms are positive, so nothing cancels.
template <class S>
Geometric<S> joined(const Geometric<S>& first, const Geometric<S>& second) {
  return {first.sum + first.power * second.sum, first.power * second.power};
}

/// The sum with m terms, by doubling.
template <class S>
Geometric<S> geometric(const S& k, long long m) {
  Geometric<S> result{S(0.0), S(1.0)};
  Geometric<S> block{S(1.0), k};
  for (; m > 0; m /= 2) {
    if (m % 2 != 0) result = joined(result, block);
    if (m > 1) block = joined(block, block);
  }
  return result;
}

}  // namespace detail

// [impact-time]
/// The time of the n-th impact, T₁ + F (k + k² + … + k^(n − 1)), where F = 2 w / g is the
/// time of flight after a first impact without loss.
/// @param n 1 or more
/// @return s; off by at most (16 + 2 log₂ n + 2 min(n, 1/(1 − k))) u of itself, if nothing
/// underflows
template <std::floating_point S>
S impact_time(const BouncingBall<S>& ball, long long n) {
  const S first = first_impact_time(ball);
  if (n <= 1 || ball.restitution == S(0)) return first;
  const S flight = S(2) * impact_speed(ball) / ball.gravity;
  return first + flight * (ball.restitution * detail::geometric(ball.restitution, n - 1).sum);
}

/// When the ball comes to rest: the limit of the times of infinitely many impacts,
/// T₁ + F k / (1 − k).
/// @return s; infinite if k = 1 and the ball moves; off by at most 16 u of itself; 0 for a ball at
/// rest on the floor
template <std::floating_point S>
S rest_time(const BouncingBall<S>& ball) {
  const S first = first_impact_time(ball);
  const S speed = impact_speed(ball);
  if (speed == S(0) || ball.restitution == S(0)) return first;
  if (ball.restitution == S(1)) return std::numeric_limits<S>::infinity();
  const S flight = S(2) * speed / ball.gravity;
  return first + flight * (ball.restitution / (S(1) - ball.restitution));
}
// [/impact-time]

/// The speed at which the ball leaves the floor after its n-th impact, w kⁿ.
/// @param n 1 or more
/// @return m/s; off by at most (n + 6) u of itself, if nothing underflows
template <std::floating_point S>
S leaving_speed(const BouncingBall<S>& ball, long long n) {
  return impact_speed(ball) * detail::geometric(ball.restitution, n).power;
}

/// The peak between the n-th impact and the next, w² k²ⁿ / (2 g).
/// @param n 1 or more
/// @return m; off by at most (2 n + 15) u of itself, if nothing underflows
template <std::floating_point S>
S peak_height(const BouncingBall<S>& ball, long long n) {
  const S leaving = leaving_speed(ball, n);
  return leaving * (leaving / (S(2) * ball.gravity));
}

namespace detail {

/// g t − v and v² + 2 g h without rounding. With A and D for them, and Sₙ for
/// 1 + 2 (k + … + k^(n − 1)), the n-th impact is at or before t if and only if A ≥ √D Sₙ. Both
/// sides are squared, so every decision is the sign of a polynomial.
struct ExactTime {
  Exact a, d, k;

  template <std::floating_point S>
  ExactTime(const BouncingBall<S>& ball, S t)
      : a(Exact(double(ball.gravity)) * Exact(double(t)) - Exact(double(ball.velocity))),
        d(Exact(double(ball.velocity)) * Exact(double(ball.velocity)) +
          Exact(2.0) * Exact(double(ball.gravity)) * Exact(double(ball.height))),
        k(double(ball.restitution)) {}

  bool impact_by(long long n) const {
    if (a.sign() < 0) return false;
    const Exact s = Exact(1.0) + Exact(2.0) * k * geometric(k, n - 1).sum;
    return !(a * a < d * s * s);
  }
  /// A (1 − k) ≥ √D (1 + k).
  bool at_rest() const {
    if (a.sign() < 0) return false;
    const Exact left = a * (Exact(1.0) - k);
    const Exact right = Exact(1.0) + k;
    return !(left * left < d * right * right);
  }
};

/// Up to this many impacts the count is decided exactly; beyond, the numbers would have more than
/// 50,000 digits.
inline constexpr long long exact_impacts = 1024;

/// The number of impacts by the time t if the ball is not at rest then, in rounded arithmetic.
/// @param rest (t − T₁) / F, not negative
template <std::floating_point S>
long long impacts_rounded(const S& k, const S& rest) {
  // The largest m with k (1 + … + k^(m − 1)) ≤ rest; then there are m + 1 impacts.
  std::array<Geometric<S>, 53> blocks;
  std::size_t count = 0;
  for (Geometric<S> block{S(1), k}; count < blocks.size(); block = joined(block, block)) {
    blocks[count++] = block;
    if (k * block.sum > rest || !(block.power > S(0))) break;
  }
  Geometric<S> sum{S(0), S(1)};
  long long m = 0;
  while (count-- > 0) {
    const Geometric<S> next = joined(sum, blocks[count]);
    if (k * next.sum <= rest && next.power > S(0)) {
      sum = next;
      m += 1LL << count;
    }
  }
  return m + 1;
}

/// The largest n for which `by(n)` holds, searched from a first guess; by(1) holds.
template <class By>
long long corrected(long long guess, const By& by) {
  long long low = 1;
  long long high = exact_impacts + 1;
  for (long long step = 1, n = guess; n >= 1 && n <= exact_impacts; step *= 2) {
    if (by(n)) {
      low = n;
      if (high != exact_impacts + 1) break;
      n += step;
    } else {
      high = n;
      if (low != 1) break;
      n -= step;
    }
  }
  while (high - low > 1) {
    const long long middle = low + (high - low) / 2;
    (by(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace detail

// [bounces-by]
/// The number of impacts up to a time t ≥ 0, an impact at t included.
///
/// The answer is exact for the stored numbers up to 1024 impacts: a count whose times are too close
/// to t for rounded arithmetic is decided by polynomials, without rounding. Whether the ball is at
/// rest is always exact.
/// @return a whole number; infinite once the ball rests after infinitely many impacts (0 < k < 1);
/// 1 once it rests after its only impact (k = 0, or a ball at rest on the floor)
template <std::floating_point S>
S bounces_by(const BouncingBall<S>& ball, const S& t) {
  const S u = tolerance::unit_roundoff<S>;
  const S k = ball.restitution;
  const S first = first_impact_time(ball);
  const S speed = impact_speed(ball);
  if (speed == S(0)) return S(1);
  const S flight = S(2) * speed / ball.gravity;
  const S end = rest_time(ball);
  const auto exact = [&ball, &t] { return detail::ExactTime(ball, t); };
  const auto near = [&](const S& time, const S& room) {
    return !(std::abs(t - time) > room * u * time);
  };
  if (k < S(1) && (near(end, S(32)) ? exact().at_rest() : t > end)) {
    return k == S(0) ? S(1) : std::numeric_limits<S>::infinity();
  }
  if (near(first, S(16)) ? !exact().impact_by(1) : t < first) return S(0);
  const long long guess = detail::impacts_rounded(k, std::max(S(0), S((t - first) / flight)));
  const S memory = std::min(S(guess), S(1) / (S(1) - k));
  const S room =
      S(32) + S(2) * S(std::bit_width(static_cast<unsigned long long>(guess))) + S(2) * memory;
  const bool sure = t < impact_time(ball, guess + 1) && !(t < impact_time(ball, guess)) &&
                    !near(impact_time(ball, guess), room) &&
                    !near(impact_time(ball, guess + 1), room);
  if (sure) return S(guess);
  // Near the end the remainder of the series rounds to 0, and the guess is arbitrary.
  const auto decided = exact();
  if (guess > detail::exact_impacts && decided.impact_by(detail::exact_impacts)) return S(guess);
  return S(detail::corrected(std::min(guess, detail::exact_impacts),
                             [&decided](long long n) { return decided.impact_by(n); }));
}
// [/bounces-by]

// [bounce-at]
/// The state of the ball at a time t ≥ 0, by formula, at the same cost for any number of bounces.
/// @return the height is off by at most c u (h + |v| t + g t²/2) before the first impact, and by
/// c u w t after it, with w the speed after the last impact and c the factor of impact_time(); it
/// is never negative
template <std::floating_point S>
BounceState<S> bounce_at(const BouncingBall<S>& ball, const S& t) {
  const S bounces = bounces_by(ball, t);
  const S g = ball.gravity;
  if (bounces == S(0)) {
    return {std::max(S(0), S(ball.height + (ball.velocity - g * t / S(2)) * t)),
            ball.velocity - g * t, S(0), false};
  }
  if (std::isinf(bounces) || ball.restitution == S(0) || impact_speed(ball) == S(0)) {
    return {S(0), S(0), bounces, true};
  }
  const auto n = static_cast<long long>(bounces);
  const S leaving = leaving_speed(ball, n);
  // Rounding may put the time slightly outside the flight.
  const S since = std::clamp(S(t - impact_time(ball, n)), S(0), S(S(2) * leaving / g));
  return {std::max(S(0), S(since * (leaving - g * since / S(2)))), leaving - g * since, bounces,
          false};
}
// [/bounce-at]

// [rest-speed]
/// The rest speed √(2 g ε): bounces that leave the floor more slowly may be left out if heights
/// need be right only to ε. They never get higher than ε. With v for the rest speed, they are over
/// within 2 v / (g (1 − k)) and have an energy of at most m v² / 2.
/// @param height ε, m, 0 or more
/// @param gravity m/s², greater than 0
/// @return m/s
template <std::floating_point S>
S rest_speed(const S& height, const S& gravity) {
  return std::sqrt(S(2) * gravity * height);
}
// [/rest-speed]

/// When a ball with a rest speed comes to rest.
template <std::floating_point S>
struct EarlyRest {
  S impacts = S(0);  ///< a whole number, the one at which it rests included; or infinite
  S time = S(0);     ///< from which it rests, s; or infinite
};

/// The first impact after which the ball would leave the floor at rest_speed or less: there it
/// rests.
/// @param rest_speed m/s, 0 or more; 0 leaves nothing out
/// @return infinitely many impacts until rest_time() if nothing is left out, and for k = 1 if the
/// ball never becomes so slow. A leaving speed within (n + 6) u of the rest speed may be decided
/// either way
template <std::floating_point S>
EarlyRest<S> early_rest(const BouncingBall<S>& ball, const S& rest_speed) {
  const auto rests = [&](long long n) { return !(leaving_speed(ball, n) > rest_speed); };
  if (rests(1)) return {S(1), first_impact_time(ball)};
  constexpr S infinite = std::numeric_limits<S>::infinity();
  if (rest_speed == S(0) || ball.restitution == S(1)) return {infinite, rest_time(ball)};
  constexpr long long most = 1LL << 60;
  long long low = 1;
  long long high = 2;
  while (!rests(high)) {
    if (high >= most) return {infinite, infinite};
    low = high;
    high *= 2;
  }
  while (high - low > 1) {
    const long long middle = low + (high - low) / 2;
    (rests(middle) ? high : low) = middle;
  }
  return {S(high), impact_time(ball, high)};
}

// [follow-bounces]
/// The state of the ball at a time t ≥ 0, flight by flight, as an event-driven simulation does it:
/// from impact to impact by formula, and at rest once it would leave the floor at rest_speed or
/// less.
///
/// The work is proportional to the number of bounces. Without a rest speed (0) that would be
/// infinite for 0 < k < 1; the loop ends when the time no longer grows: after some 53 / log₂(1/k)
/// bounces a flight is shorter than half an ulp of the time.
/// @param rest_speed m/s, 0 or more
/// @return while it bounces, each time is off by at most 3 n u of itself after n bounces; once it
/// rests early, the height is off by at most rest_speed² / (2 g)
/// @see *Fundamentals of Computer Animation: Collision Detection and Response*, the loop of a time
/// step
template <std::floating_point S>
BounceState<S> follow_bounces(const BouncingBall<S>& ball, const S& t, const S& rest_speed) {
  const S g = ball.gravity;
  S impact = first_impact_time(ball);
  if (t < impact) {
    return {std::max(S(0), S(ball.height + (ball.velocity - g * t / S(2)) * t)),
            ball.velocity - g * t, S(0), false};
  }
  S speed = impact_speed(ball) * ball.restitution;
  S bounces(1);
  while (speed > rest_speed) {
    const S next = impact + S(2) * speed / g;
    if (!(next > impact)) break;  // the time no longer grows
    if (t < next) {
      const S since = t - impact;
      return {std::max(S(0), S(since * (speed - g * since / S(2)))), speed - g * since, bounces,
              false};
    }
    impact = next;
    speed *= ball.restitution;
    bounces += S(1);
  }
  return {S(0), S(0), bounces, true};
}
// [/follow-bounces]

}  // namespace contact
