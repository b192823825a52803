/// @file
/// Two balls on a line and a wall: from event to event, exact for rationals; in steps; and whether
/// they collide infinitely often.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include <contact/collision_1d.hpp>
#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A wall, an inner ball and an outer ball on one line, without forces; the inner ball is between
/// the wall and the outer ball. Make it with two_balls_and_wall(), which checks its arguments.
template <Scalar S>
struct TwoBallsAndWall {
  LineBody<S> inner;      ///< velocity away from the wall, m/s
  LineBody<S> outer;      ///< velocity away from the wall, m/s
  S wall_gap = S(0);      ///< distance of the wall and the inner ball, m
  S ball_gap = S(0);      ///< distance of the two balls, m
  S restitution = S(1);   ///< of the balls with each other and with the wall, 0 to 1
  std::int64_t hits = 0;  ///< collisions so far, with the wall and with each other
};

/// Two balls and a wall.
/// @param inner, outer of line_body(), with finite masses; velocities are positive away from the
/// wall
/// @param wall_gap, ball_gap m, 0 or more
/// @param restitution 0 to 1
/// @throws std::invalid_argument if a number is out of its range or not finite
template <Scalar S>
TwoBallsAndWall<S> two_balls_and_wall(const LineBody<S>& inner, const LineBody<S>& outer,
                                      const S& wall_gap, const S& ball_gap, const S& restitution) {
  require_finite("inner.mass", inner.mass);
  require_finite("outer.mass", outer.mass);
  require_finite("wall_gap", wall_gap);
  require_finite("ball_gap", ball_gap);
  if (wall_gap < S(0)) {
    throw_invalid_argument("wall_gap", number_text(wall_gap), "must not be negative");
  }
  if (ball_gap < S(0)) {
    throw_invalid_argument("ball_gap", number_text(ball_gap), "must not be negative");
  }
  require_restitution("restitution", restitution);
  return {inner, outer, wall_gap, ball_gap, restitution, 0};
}

namespace detail {

template <Scalar S>
void glide(TwoBallsAndWall<S>& now, const S& t) {
  now.wall_gap = now.wall_gap + now.inner.velocity * t;
  now.ball_gap = now.ball_gap + (now.outer.velocity - now.inner.velocity) * t;
}

template <Scalar S>
void hit_wall(TwoBallsAndWall<S>& now) {
  now.inner.velocity = -(now.restitution * now.inner.velocity);
  ++now.hits;
}

template <Scalar S>
void hit_each_other(TwoBallsAndWall<S>& now) {
  const LineCollision<S> after = collide(now.inner, now.outer, now.restitution);
  now.inner.velocity = after.first;
  now.outer.velocity = after.second;
  ++now.hits;
}

}  // namespace detail

// [next-hit]
/// The next collision of two balls and a wall.
template <Scalar S>
struct BallOrWallHit {
  S time = S(0);      ///< s from now, 0 or more
  bool wall = false;  ///< of the inner ball with the wall; else of the balls with each other
};

/// The next collision; nothing if no gap shrinks. If the inner ball hits the wall and the outer
/// ball at the same time, the wall comes first.
template <Scalar S>
std::optional<BallOrWallHit<S>> next_hit(const TwoBallsAndWall<S>& now) {
  std::optional<BallOrWallHit<S>> next;
  if (approaching(now.inner, now.outer)) {
    next = {S(now.ball_gap / (now.inner.velocity - now.outer.velocity)), false};
  }
  if (now.inner.velocity < S(0)) {
    const S time = now.wall_gap / -now.inner.velocity;
    if (!next || !(next->time < time)) next = {time, true};
  }
  return next;
}
// [/next-hit]

// [two-balls-by-events]
/// The two balls after a time, from collision to collision: event-driven, and exact in fractions.
/// @param t s, 0 or more; on return the unused time, which is 0 unless the limit was reached
/// @param limit stops after this many collisions, if another would follow
template <Scalar S>
TwoBallsAndWall<S> two_balls_by_events(TwoBallsAndWall<S> now, S& t, std::int64_t limit) {
  for (std::int64_t hits = 0;; ++hits) {
    const auto next = next_hit(now);
    if (!next || next->time > t) {
      detail::glide(now, t);
      t = S(0);
      return now;
    }
    if (hits == limit) return now;
    detail::glide(now, next->time);
    t = t - next->time;
    // The gap that has closed is exactly 0, without a rounding residual.
    (next->wall ? now.wall_gap : now.ball_gap) = S(0);
    if (next->wall) {
      detail::hit_wall(now);
    } else {
      detail::hit_each_other(now);
    }
  }
}
// [/two-balls-by-events]

// [two-balls-in-steps]
/// The two balls after a number of steps of dt. Each step moves them at constant velocity, then
/// tests for overlaps that grow, and applies the collision at the overlapping position.
///
/// Overlaps are not corrected; they open by themselves. A ball that passes through the other
/// between two tests is missed.
template <Scalar S>
TwoBallsAndWall<S> two_balls_in_steps(TwoBallsAndWall<S> now, const S& dt, long long steps) {
  for (long long i = 0; i < steps; ++i) {
    detail::glide(now, dt);
    if (!(now.wall_gap > S(0)) && now.inner.velocity < S(0)) detail::hit_wall(now);
    if (!(now.ball_gap > S(0)) && approaching(now.inner, now.outer)) detail::hit_each_other(now);
  }
  return now;
}
// [/two-balls-in-steps]

// [collapses]
/// Inelastic collapse: whether an outer ball that moves towards the wall traps a resting inner one
/// there, with infinitely many collisions in a finite time: (1 − e)² M ≥ 4 e m.
///
/// One round of two collisions, with the wall and then of the balls, maps the two velocities by a
/// matrix with determinant e² and trace 1 − e + (1 + e)(e M − m)/(M + m). If its eigenvalues are
/// complex, the balls separate after finitely many collisions. If they are real, which means that
/// the trace is at least 2 e, they never do.
/// @param inner_mass, outer_mass m and M, kg, greater than 0
/// @param restitution e, of the balls with each other and with the wall, 0 to 1
/// @return decided by the sign of a polynomial of the stored numbers, computed exactly
template <std::floating_point S>
bool collapses(const S& inner_mass, const S& outer_mass, const S& restitution) {
  const Exact e(static_cast<double>(restitution));
  const Exact lost = Exact(1.0) - e;
  return !(lost * lost * Exact(static_cast<double>(outer_mass)) <
           Exact(4.0) * e * Exact(static_cast<double>(inner_mass)));
}
// [/collapses]

}  // namespace contact
