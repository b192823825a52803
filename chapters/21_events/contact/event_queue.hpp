/// @file
/// A priority queue of future events, some of which become stale before they happen.
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

/// A collision of two bodies, or of a body with something static.
template <std::totally_ordered Time>
struct QueuedEvent {
  Time time{};      ///< s, on one clock for all bodies
  int first = 0;    ///< index of a body
  int second = -1;  ///< index of another body, larger than first; or a negative number for a wall

  /// Whether event a comes before event b: the earlier time, then the smaller first body, then the
  /// smaller second (walls before bodies).
  // [comes-before]
  friend bool comes_before(const QueuedEvent& a, const QueuedEvent& b) {
    if (a.time < b.time || b.time < a.time) return a.time < b.time;
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  }
  // [/comes-before]
};

/// A priority queue of events, with a rule for ties that does not depend on the order in which the
/// events were added.
///
/// An event becomes stale when the motion of one of its bodies changes before it happens. Deletion
/// is lazy: the stamp of the body is raised, and an event with an older stamp is skipped when it
/// reaches the top. (Two events that are equal in all three numbers are the same event, so their
/// order does not matter.)
///
/// Cost: push and pop take O(log n) comparisons. Stale events are removed when they may be more
/// than half, so the size stays within twice the number of valid events, plus two for each body.
template <std::totally_ordered Time>
class EventQueue {
 public:
  /// A queue for bodies with the indices 0 to bodies − 1.
  explicit EventQueue(std::size_t bodies) : stamps_(bodies, 0) {}

  /// Adds an event.
  /// @param time s; not NaN, which is not ordered
  /// @param first index of a body
  /// @param second index of another body, or a negative number; the bodies may be in any order
  // [event-queue]
  void push(const Time& time, int first, int second = -1) {
    assert(time == time);
    if (second >= 0 && second < first) std::swap(first, second);
    heap_.push_back({{time, first, second}, stamp(first), second >= 0 ? stamp(second) : 0});
    std::push_heap(heap_.begin(), heap_.end(), later);
  }

  /// Makes all queued events of a body stale: call it when the body's motion changes.
  void invalidate(int body) {
    ++stamps_[static_cast<std::size_t>(body)];
    if (++changes_ > heap_.size() / 2 + stamps_.size()) remove_stale();
  }

  /// Removes and returns the next valid event; nothing if there is none.
  std::optional<QueuedEvent<Time>> pop() {
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), later);
      const Entry entry = heap_.back();
      heap_.pop_back();
      if (counts(entry)) return entry.event;
    }
    return std::nullopt;
  }
  // [/event-queue]

  /// The time of the next valid event, without removing it; nothing if there is none.
  std::optional<Time> next_time() {
    while (!heap_.empty() && !counts(heap_.front())) {
      std::pop_heap(heap_.begin(), heap_.end(), later);
      heap_.pop_back();
    }
    return heap_.empty() ? std::optional<Time>() : std::optional<Time>(heap_.front().event.time);
  }

  /// The number of entries, stale ones included.
  std::size_t size() const { return heap_.size(); }

 private:
  struct Entry {
    QueuedEvent<Time> event;
    std::uint64_t first_stamp = 0;
    std::uint64_t second_stamp = 0;
  };

  /// The standard library's heap has its largest element on top.
  static bool later(const Entry& a, const Entry& b) { return comes_before(b.event, a.event); }

  std::uint64_t stamp(int body) const { return stamps_[static_cast<std::size_t>(body)]; }

  bool counts(const Entry& entry) const {
    const QueuedEvent<Time>& event = entry.event;
    return entry.first_stamp == stamp(event.first) &&
           (event.second < 0 || entry.second_stamp == stamp(event.second));
  }

  void remove_stale() {
    std::erase_if(heap_, [this](const Entry& entry) { return !counts(entry); });
    std::make_heap(heap_.begin(), heap_.end(), later);
    changes_ = 0;
  }

  std::vector<Entry> heap_;
  std::vector<std::uint64_t> stamps_;
  std::size_t changes_ = 0;  ///< since stale entries were last removed
};

}  // namespace contact
