/// @file
/// What will happen next: a queue of events that have not happened yet, some of which never will.
#pragma once

#include <algorithm>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace contact {

// [queued-event]
/// Two bodies that will meet, or a body and something that does not move.
template <std::totally_ordered Time>
struct QueuedEvent {
  Time time{};      ///< s, on one clock for all
  int first = 0;    ///< index of a body
  int second = -1;  ///< index of another, larger than first; or a negative number: a wall, an alarm

  /// Whether this one comes before the other. Of events at one time that of the smaller first body
  /// does, then that of the smaller second: walls before bodies.
  friend bool comes_before(const QueuedEvent& a, const QueuedEvent& b) {
    if (a.time < b.time || b.time < a.time) return a.time < b.time;
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  }
};
// [/queued-event]

// [event-queue]
/// Events in the order of their times, with a rule for ties that does not depend on the order in
/// which they were put in.
///
/// An event that was computed for a body becomes stale when something else happens to that body
/// first. It is not searched for: the body's stamp is raised, and an event with an older stamp is
/// passed over when it comes to the top. (Two events that are the same in all three numbers are the
/// same event, whichever comes first.)
///
/// Limits: push and pop take some log₂ n comparisons. Stale events are swept out when they may be
/// more than half, so the memory stays within twice that of the events that count, plus two events
/// for each body.
template <std::totally_ordered Time>
class EventQueue {
 public:
  /// A queue for so many bodies, which have the indices 0 to bodies − 1.
  explicit EventQueue(std::size_t bodies) : stamps_(bodies, 0) {}

  /// Puts an event in.
  /// @param time s; not NaN, which has no place in an order
  /// @param first index of a body
  /// @param second index of another, or a negative number; the two bodies may come in any order
  void push(const Time& time, int first, int second = -1) {
    assert(time == time);
    if (second >= 0 && second < first) std::swap(first, second);
    heap_.push_back({{time, first, second}, stamp(first), second >= 0 ? stamp(second) : 0});
    std::push_heap(heap_.begin(), heap_.end(), later);
  }

  /// Makes stale all events of a body that are in the queue: call it when the body's motion
  /// changes.
  void invalidate(int body) {
    ++stamps_[static_cast<std::size_t>(body)];
    if (++changes_ > heap_.size() / 2 + stamps_.size()) sweep();
  }

  /// Takes out the next event that counts; nothing if there is none.
  std::optional<QueuedEvent<Time>> pop() {
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), later);
      const Entry entry = heap_.back();
      heap_.pop_back();
      if (counts(entry)) return entry.event;
    }
    return std::nullopt;
  }

  /// Its time, without taking it out; nothing if there is none.
  std::optional<Time> next_time() {
    while (!heap_.empty() && !counts(heap_.front())) {
      std::pop_heap(heap_.begin(), heap_.end(), later);
      heap_.pop_back();
    }
    return heap_.empty() ? std::optional<Time>() : std::optional<Time>(heap_.front().event.time);
  }

  /// How many entries it holds, stale ones included.
  std::size_t size() const { return heap_.size(); }

 private:
  struct Entry {
    QueuedEvent<Time> event;
    std::uint64_t first_stamp = 0;
    std::uint64_t second_stamp = 0;
  };

  /// A heap of the library has its largest element on top.
  static bool later(const Entry& a, const Entry& b) { return comes_before(b.event, a.event); }

  std::uint64_t stamp(int body) const { return stamps_[static_cast<std::size_t>(body)]; }

  bool counts(const Entry& entry) const {
    const QueuedEvent<Time>& event = entry.event;
    return entry.first_stamp == stamp(event.first) &&
           (event.second < 0 || entry.second_stamp == stamp(event.second));
  }

  void sweep() {
    std::erase_if(heap_, [this](const Entry& entry) { return !counts(entry); });
    std::make_heap(heap_.begin(), heap_.end(), later);
    changes_ = 0;
  }

  std::vector<Entry> heap_;
  std::vector<std::uint64_t> stamps_;
  std::size_t changes_ = 0;  ///< since the last sweep
};
// [/event-queue]

}  // namespace contact
