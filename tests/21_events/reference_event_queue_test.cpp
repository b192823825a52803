// The queue against a list that is searched.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <contact/event_queue.hpp>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::EventQueue;
using contact::QueuedEvent;
using generators::Random;
using oracle::Rational;

namespace {

/// A queue without a heap: a list, searched.
template <class Time>
struct SearchedList {
  std::vector<QueuedEvent<Time>> events;

  void push(const Time& time, int first, int second) {
    if (second >= 0 && second < first) std::swap(first, second);
    events.push_back({time, first, second});
  }
  void invalidate(int body) {
    std::erase_if(events, [body](const auto& e) { return e.first == body || e.second == body; });
  }
  std::optional<QueuedEvent<Time>> pop() {
    if (events.empty()) return std::nullopt;
    const auto next =
        std::min_element(events.begin(), events.end(), [](const auto& a, const auto& b) {
          return std::tuple(a.time, a.first, a.second) < std::tuple(b.time, b.first, b.second);
        });
    const auto event = *next;
    events.erase(next);
    return event;
  }
};

template <class Time>
bool same(const std::optional<QueuedEvent<Time>>& a, const std::optional<QueuedEvent<Time>>& b) {
  if (!a || !b) return !a && !b;
  return a->time == b->time && a->first == b->first && a->second == b->second;
}

}  // namespace

TEST_CASE("the queue gives what a searched list gives, ties and stale events included") {
  Random random(1931);
  int popped = 0;
  for (int run = 0; run < 60; ++run) {
    const int bodies = random.integer(2, 9);
    EventQueue<Rational> queue(static_cast<std::size_t>(bodies));
    SearchedList<Rational> list;
    for (int i = 0; i < 400; ++i) {
      const int what = random.integer(0, 9);
      if (what < 6) {
        const Rational time = Rational(random.integer(0, 12)) / 3;  // many ties
        const int first = random.integer(0, bodies - 1);
        int second = random.integer(-2, bodies - 1);
        if (second == first) second = -1;
        queue.push(time, first, second);
        list.push(time, first, second);
      } else if (what < 7) {
        const int body = random.integer(0, bodies - 1);
        queue.invalidate(body);
        list.invalidate(body);
      } else {
        const auto next = queue.next_time();
        const auto got = queue.pop();
        REQUIRE(next.has_value() == got.has_value());
        if (got) REQUIRE(*next == got->time);
        REQUIRE(same(got, list.pop()));
        popped += got.has_value();
      }
      REQUIRE(queue.size() >= list.events.size());
    }
  }
  CHECK(popped > 3000);
}

TEST_CASE("the order of events does not depend on the order in which they are added") {
  Random random(1932);
  std::vector<QueuedEvent<double>> events;
  for (int i = 0; i < 40; ++i) {
    const double time = random.integer(0, 3);
    const int first = random.integer(0, 5);
    events.push_back({time, first, first + random.integer(1, 4)});
  }
  std::vector<QueuedEvent<double>> before;
  for (int run = 0; run < 50; ++run) {
    for (std::size_t i = events.size() - 1; i > 0; --i) {
      std::swap(events[i],
                events[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    }
    EventQueue<double> queue(10);
    for (const auto& e : events) queue.push(e.time, e.second, e.first);
    std::vector<QueuedEvent<double>> order;
    while (const auto e = queue.pop()) order.push_back(*e);
    REQUIRE(order.size() == events.size());
    if (run > 0) {
      for (std::size_t i = 0; i < order.size(); ++i) {
        REQUIRE(same(std::optional(order[i]), std::optional(before[i])));
      }
    }
    before = order;
  }
}

TEST_CASE("stale events do not accumulate") {
  EventQueue<double> queue(100);
  Random random(1933);
  std::size_t most = 0;
  for (int i = 0; i < 20000; ++i) {
    const int body = random.integer(0, 99);
    queue.invalidate(body);
    queue.push(i + random.uniform(), body);
    most = std::max(most, queue.size());
  }
  // At most a hundred are valid at a time.
  CHECK(most <= 2 * 100 + 2 * 100);
}
