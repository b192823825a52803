/// @file
/// A step with every impact in it: advance to the first one, reflect, and use up the rest of the
/// step in the same way.
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

/// How impacts are treated, and when to give up. Make it with impact_rules(), which checks what it
/// is given.
template <Scalar S>
struct ImpactRules {
  S restitution = S(1);   ///< of ball and walls, 0 to 1
  S rest_speed = S(0);    ///< who leaves a wall this fast or slower, and is pulled back, rests, m/s
  int most_impacts = 64;  ///< in one step
};

/// Rules for the impacts of a step.
/// @param restitution 0 to 1
/// @param rest_speed m/s, 0 or more
/// @param most_impacts in one step, 0 or more; with 0 an advance stops at the first wall
/// @throws std::invalid_argument if a number is out of its range or not finite
template <Scalar S>
ImpactRules<S> impact_rules(const S& restitution, const S& rest_speed, int most_impacts) {
  require_restitution("restitution", restitution);
  require_finite("rest_speed", rest_speed);
  if (rest_speed < S(0)) {
    throw_invalid_argument("rest_speed", number_text(rest_speed), "must not be negative");
  }
  if (most_impacts < 0) {
    throw_invalid_argument("most_impacts", std::to_string(most_impacts), "must not be negative");
  }
  return {restitution, rest_speed, most_impacts};
}

/// Why an advance ended.
enum class AdvanceEnd {
  used_up,        ///< the step is over
  rests,          ///< on a wall that it is pulled against
  out_of_impacts  ///< more of them than the rules allow
};

/// What a step came to.
template <Scalar S>
struct Advance {
  MotionState<Vector3<S>> state;         ///< of the centre, at the end or where it stopped
  int impacts = 0;                       ///< in this step
  int wall = -1;                         ///< the last one that was met; −1 for none
  S time_left = S(0);                    ///< of the step, s; 0 if it is used up
  AdvanceEnd end = AdvanceEnd::used_up;  ///< why it ended
};

namespace detail {

/// The wall that is met first, and when. Of walls met at one time, the first of the list.
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

// [advance-loop]
/// The loop of both advances. `closing` says when a wall is met from a state, and `moved` where the
/// ball is a time later.
template <Scalar S, class Closing, class Moved>
Advance<S> advance_by(const MotionState<Vector3<S>>& start, const Vector3<S>& acceleration,
                      const S& step, const std::vector<Plane<S>>& walls,
                      const ImpactRules<S>& rules, const Closing& closing, const Moved& moved) {
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
    // To the wall, with the velocity that the ball has there.
    now.state = moved(now.state, next.time);
    now.time_left = now.time_left - next.time;
    now.wall = next.wall;
    if (approaches(now.state.velocity, normal)) {
      if (now.impacts == rules.most_impacts) {
        now.end = AdvanceEnd::out_of_impacts;
        return now;
      }
      ++now.impacts;
      now.state.velocity = after_bounce(now.state.velocity, normal, rules.restitution);
    }
    const S leaving = now.state.velocity.dot(normal);
    if (!(leaving > rules.rest_speed) && acceleration.dot(normal) < S(0)) {
      now.state.velocity = now.state.velocity - normal * leaving;
      now.end = AdvanceEnd::rests;
      return now;
    }
  }
}
// [/advance-loop]

}  // namespace detail

// [advance-straight]
/// A ball without forces, one step later, with every impact in it: exact if S is.
///
/// With the velocity that velocity_first_step() has just made, this is the lecture's loop.
/// @param start centre and velocity
/// @param radius m, 0 or more
/// @param step s, 0 or more
/// @param walls planes whose fronts the ball moves in; it does not start behind one
/// @param rules rest_speed does not matter here: nothing pulls
/// @note Between two walls at an angle θ a ball that loses nothing has at most ⌈π/θ⌉ impacts; with
/// losses there are more, and at a small angle no end; parallel walls give as many as fit into the
/// step. What is left when the rules' number is spent is `time_left`; the ball
/// then touches a wall that it still approaches
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
/// A ball under a constant acceleration, one step later, with every impact in it.
///
/// Its flights are true parabolas, and what is reflected is the velocity at the impact. It stops,
/// with the rest of the step in `time_left`, once it leaves a wall with the rest speed or less and
/// is pulled back: it touches that wall then and has no velocity along its normal. What it does
/// from there on, lie, slide or roll, is a matter of contact and not of impacts.
/// @param start centre and velocity
/// @param acceleration m/s²
/// @param radius m, 0 or more
/// @param step s, 0 or more
/// @param walls planes whose fronts the ball moves in; it does not start behind one
/// @note With a rest speed w and a pull g against the wall, the flights that are left out end
/// within 2 w / (g (1 − k)) and stay below w²/(2 g). With the rest speed 0 and 0 < k < 1 impacts
/// are endless, and only the rules' number ends them
/// @note Each impact rounds, so a ball touches its wall but for some u of what it was computed from
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
