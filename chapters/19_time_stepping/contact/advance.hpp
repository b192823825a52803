/// @file
/// A step with all its impacts: advance to the first impact, reflect the velocity, and use up the
/// rest of the step in the same way.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <contact/ballistic.hpp>
#include <contact/integrators.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/restitution.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// How impacts are treated, and when to stop. Make it with impact_rules(), which checks its
/// arguments.
template <Scalar S>
struct ImpactRules {
  S restitution = S(1);  ///< of ball and walls, 0 to 1
  S rest_speed = S(0);   ///< a ball that leaves a wall no faster and is pulled back rests, m/s
  int max_impacts = 64;  ///< in one step
};

/// Rules for the impacts of a step.
/// @param restitution 0 to 1
/// @param rest_speed m/s, 0 or more
/// @param max_impacts in one step, 0 or more; with 0 an advance stops at the first wall
/// @throws std::invalid_argument if a number is out of its range or not finite
template <Scalar S>
ImpactRules<S> impact_rules(const S& restitution, const S& rest_speed, int max_impacts) {
  require_restitution("restitution", restitution);
  require_finite("rest_speed", rest_speed);
  if (rest_speed < S(0)) {
    throw_invalid_argument("rest_speed", number_text(rest_speed), "must not be negative");
  }
  if (max_impacts < 0) {
    throw_invalid_argument("max_impacts", std::to_string(max_impacts), "must not be negative");
  }
  return {restitution, rest_speed, max_impacts};
}

/// Why an advance ended.
enum class AdvanceEnd {
  used_up,        ///< the end of the step is reached
  rests,          ///< the ball rests on a wall towards which it is pulled
  out_of_impacts  ///< there are more impacts than the rules allow
};

/// The result of a step.
template <Scalar S>
struct Advance {
  MotionState<Vector3<S>> state;         ///< of the centre, at the end or where the ball stopped
  int impacts = 0;                       ///< in this step
  int wall = -1;                         ///< index of the last wall that was hit; −1 for none
  S time_left = S(0);                    ///< unused part of the step, s; 0 if it is used up
  AdvanceEnd end = AdvanceEnd::used_up;  ///< why the advance ended
};

namespace detail {

/// The wall that is hit first, and when. Of walls that are hit at the same time, the first in the
/// list.
template <Scalar S>
struct WallMeeting {
  int wall = -1;
  S time = S(0);
};

template <Scalar S, class Closing>
WallMeeting<S> next_wall(const std::vector<Plane<S>>& walls, const Closing& closing) {
  WallMeeting<S> first;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const std::optional<S> time = closing(walls[i]);
    if (!time || (first.wall >= 0 && !(*time < first.time))) continue;
    first = {static_cast<int>(i), *time};
  }
  return first;
}

/// The loop of both advances. `closing` returns when a wall is hit from a state, and `moved`
/// returns the state after a time of free motion.
template <Scalar S, class Closing, class Moved>
Advance<S> advance_by(const MotionState<Vector3<S>>& start, const Vector3<S>& acceleration,
                      const S& step, const std::vector<Plane<S>>& walls,
                      const ImpactRules<S>& rules, const Closing& closing, const Moved& moved) {
  // [advance-loop]
  Advance<S> now{start, 0, -1, step, AdvanceEnd::used_up};
  for (;;) {
    const WallMeeting<S> next =
        next_wall<S>(walls, [&](const Plane<S>& wall) { return closing(now.state, wall); });
    if (next.wall < 0 || next.time > now.time_left) {
      now.state = moved(now.state, now.time_left);
      now.time_left = S(0);
      return now;
    }
    const Vector3<S>& normal = walls[static_cast<std::size_t>(next.wall)].normal;
    // Move to the wall: what is reflected is the velocity at the impact.
    now.state = moved(now.state, next.time);
    now.time_left = now.time_left - next.time;
    now.wall = next.wall;
    if (approaches(now.state.velocity, normal)) {
      if (now.impacts == rules.max_impacts) {
        now.end = AdvanceEnd::out_of_impacts;
        return now;
      }
      ++now.impacts;
      now.state.velocity = after_bounce(now.state.velocity, normal, rules.restitution);
    }
    // [/advance-loop]
    // [rest-rule]
    const S leaving = now.state.velocity.dot(normal);
    if (!(leaving > rules.rest_speed) && acceleration.dot(normal) < S(0)) {
      now.state.velocity = now.state.velocity - normal * leaving;
      now.end = AdvanceEnd::rests;
      return now;
    }
    // [/rest-rule]
  }
}

}  // namespace detail

// [advance-straight]
/// Moves a ball without forces for one step, with all its impacts; exact if S is exact.
///
/// With the velocity after semi_implicit_euler_step(), this is the lecture's loop.
/// @param start centre and velocity
/// @param radius m, 0 or more
/// @param step s, 0 or more
/// @param walls planes; the ball starts and stays in front of all of them
/// @param rules rest_speed is not used, since no force pulls the ball back
/// @note In a wedge of angle θ a ball with k = 1 has at most ⌈π/θ⌉ impacts. With k < 1 there can be
/// more, and for a small angle and small k infinitely many. Between parallel walls there are as
/// many as fit into the step. When the limit of the rules is reached, `time_left` is the unused
/// part of the step, and the ball touches a wall that it still approaches
/// @see *Fundamentals of Computer Animation*, slide "At the beginning of each time step"
template <Scalar S>
Advance<S> advance_straight(const MotionState<Vector3<S>>& start, const S& radius, const S& step,
                            const std::vector<Plane<S>>& walls, const ImpactRules<S>& rules) {
  const auto closing = [&radius](const MotionState<Vector3<S>>& now, const Plane<S>& wall) {
    return straight_closing_time<S>(wall.normal.dot(now.position) - wall.offset - radius,
                                    wall.normal.dot(now.velocity));
  };
  const auto moved = [](const MotionState<Vector3<S>>& now, const S& t) {
    return MotionState<Vector3<S>>{now.position + now.velocity * t, now.velocity};
  };
  const Vector3<S> none = Vector3<S>::Zero();
  return detail::advance_by<S>(start, none, step, walls, rules, closing, moved);
}
// [/advance-straight]

// [advance-ballistic]
/// Moves a ball under a constant acceleration for one step, with all its impacts.
///
/// Between impacts the ball follows exact parabolas, and what is reflected is the velocity at the
/// impact. If the ball leaves a wall at the rest speed or slower and is pulled back, the advance
/// stops there: the ball touches the wall, has no normal velocity, and `time_left` is the unused
/// part of the step. Whether it then lies, slides or rolls is a question of contact, not of
/// impacts.
/// @param start centre and velocity
/// @param acceleration m/s²
/// @param radius m, 0 or more
/// @param step s, 0 or more
/// @param walls planes; the ball starts and stays in front of all of them
/// @note With rest speed w and acceleration g towards the wall, the flights that are left out last
/// at most 2 w / (g (1 − k)) and stay below w²/(2 g). With rest speed 0 and 0 < k < 1 there are
/// infinitely many impacts in a finite time, and only the limit on their number ends the advance
/// @note Each impact rounds: the ball touches its wall to within a few u of the numbers from which
/// its position was computed
template <std::floating_point S>
Advance<S> advance_ballistic(const MotionState<Vector3<S>>& start, const Vector3<S>& acceleration,
                             const S& radius, const S& step, const std::vector<Plane<S>>& walls,
                             const ImpactRules<S>& rules) {
  const auto closing = [&](const MotionState<Vector3<S>>& now, const Plane<S>& wall) {
    return closing_time<S>(wall.normal.dot(now.position) - wall.offset - radius,
                           wall.normal.dot(now.velocity), wall.normal.dot(acceleration));
  };
  const auto moved = [&acceleration](const MotionState<Vector3<S>>& now, const S& t) {
    return ballistic_motion(now, acceleration, t);
  };
  return detail::advance_by<S>(start, acceleration, step, walls, rules, closing, moved);
}
// [/advance-ballistic]

}  // namespace contact
