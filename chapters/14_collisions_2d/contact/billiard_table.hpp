/// @file
/// Discs on a table with four cushions: event-driven, and in fixed time steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <vector>

#include <contact/disc_collision.hpp>
#include <contact/disc_events.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A table: its field from (0, 0) to (width, height), and its coefficients of restitution. There is
/// no friction.
template <std::floating_point S>
struct Table {
  S width = S(0);           ///< m
  S height = S(0);          ///< m
  S disc_bounce = S(1);     ///< e between two discs, 0 to 1
  S cushion_bounce = S(1);  ///< e between a disc and a cushion, 0 to 1
};

/// The four cushions, as the second body of an event.
enum class Cushion { left = -1, right = -2, bottom = -3, top = -4 };

/// An event on a table: two discs touch, or a disc and a cushion.
template <std::floating_point S>
struct TableEvent {
  S time = S(0);   ///< s, from now
  int first = 0;   ///< index of a disc
  int second = 0;  ///< index of another, larger than first, or a Cushion
};

namespace detail {

/// The normal away from the cushion, into the field.
template <std::floating_point S>
Vector2<S> normal_of(int cushion) {
  switch (static_cast<Cushion>(cushion)) {
    case Cushion::left:
      return {S(1), S(0)};
    case Cushion::right:
      return {S(-1), S(0)};
    case Cushion::bottom:
      return {S(0), S(1)};
    case Cushion::top:
      return {S(0), S(-1)};
  }
  return {S(0), S(0)};
}

/// The signed distance of a disc's rim from a cushion, m; negative beyond it.
template <std::floating_point S>
S clearance(const Table<S>& table, const Disc<S>& d, int cushion) {
  switch (static_cast<Cushion>(cushion)) {
    case Cushion::left:
      return d.centre.x() - d.radius;
    case Cushion::right:
      return table.width - d.centre.x() - d.radius;
    case Cushion::bottom:
      return d.centre.y() - d.radius;
    case Cushion::top:
      return table.height - d.centre.y() - d.radius;
  }
  return S(0);
}

}  // namespace detail

// [next-event]
/// The next event on a table: the earliest touch of any pair of discs, or of any disc and cushion.
/// Of several at the same time it is the first in the order of indices, with the cushions last.
/// @return nothing if there is no further event
template <std::floating_point S>
std::optional<TableEvent<S>> next_event(const Table<S>& table, const std::vector<Disc<S>>& discs) {
  std::optional<TableEvent<S>> next;
  const auto offer = [&next](const S& time, std::size_t first, int second) {
    if (!next || time < next->time) next = {time, static_cast<int>(first), second};
  };
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      if (const auto time = time_to_touch(discs[i], discs[j])) offer(*time, i, static_cast<int>(j));
    }
  }
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (int cushion = -1; cushion >= -4; --cushion) {
      const S speed = -detail::normal_of<S>(cushion).dot(discs[i].velocity);
      if (!(speed > S(0))) continue;
      offer(std::max(S(0), detail::clearance(table, discs[i], cushion)) / speed, i, cushion);
    }
  }
  return next;
}
// [/next-event]

/// Moves all discs on by a time.
template <std::floating_point S>
void move_on(std::vector<Disc<S>>& discs, const S& time) {
  for (Disc<S>& d : discs) d.centre += d.velocity * time;
}

/// Applies the impulse of an event, which changes velocities only.
template <std::floating_point S>
void happen(const Table<S>& table, std::vector<Disc<S>>& discs, const TableEvent<S>& event) {
  Disc<S>& first = discs[static_cast<std::size_t>(event.first)];
  if (event.second < 0) {
    first.velocity =
        off_cushion(first.velocity, detail::normal_of<S>(event.second), table.cushion_bounce);
    return;
  }
  Disc<S>& second = discs[static_cast<std::size_t>(event.second)];
  const auto after = collide_discs(first, second, table.disc_bounce);
  first.velocity = after.velocity_a;
  second.velocity = after.velocity_b;
}

/// An event-driven simulation: find the next event, move on to its time, apply its impulse, repeat.
/// @param discs initial state; final state when it returns
/// @param duration s
/// @param max_events maximum number of events
/// @param seen called as seen(event, discs) after each event, with its time from the start
/// @return the time simulated: less than duration only after `max_events` events
// [play]
template <std::floating_point S, class Seen>
S play(const Table<S>& table, std::vector<Disc<S>>& discs, const S& duration, int max_events,
       const Seen& seen) {
  S now(0);
  for (int happened = 0; happened < max_events; ++happened) {
    const auto next = next_event(table, discs);
    if (!next || now + next->time > duration) {
      move_on(discs, S(duration - now));
      return duration;
    }
    move_on(discs, next->time);
    now += next->time;
    happen(table, discs, *next);
    seen(TableEvent<S>{now, next->first, next->second}, discs);
  }
  return now;
}
// [/play]

// [in-steps]
/// The same in fixed time steps: move everything, then test which discs overlap. It finds each
/// collision late, with discs that already overlap, so that the line of their centres is not the
/// line of impact; and it misses collisions that begin and end within a step. For comparison only.
/// @param step s, greater than 0
/// @param seen called as seen(time, discs) after each step
template <std::floating_point S, class Seen>
void play_in_steps(const Table<S>& table, std::vector<Disc<S>>& discs, const S& duration,
                   const S& step, const Seen& seen) {
  const int steps = static_cast<int>(duration / step);
  for (int k = 1; k <= steps; ++k) {
    move_on(discs, step);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      for (std::size_t j = i + 1; j < discs.size(); ++j) {
        const Vector2<S> d = discs[i].centre - discs[j].centre;
        const S radius_sum = discs[i].radius + discs[j].radius;
        if (d.dot(d) <= radius_sum * radius_sum) {
          happen(table, discs, {S(0), static_cast<int>(i), static_cast<int>(j)});
        }
      }
      for (int cushion = -1; cushion >= -4; --cushion) {
        if (detail::clearance(table, discs[i], cushion) <= S(0)) {
          happen(table, discs, {S(0), static_cast<int>(i), cushion});
        }
      }
    }
    seen(S(k) * step, discs);
  }
}
// [/in-steps]

}  // namespace contact
