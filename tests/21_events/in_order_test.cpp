// Identical beads that exchange their velocities move as if they passed through each other. So
// every meeting is a crossing of two straight lines, and its index is the number of lines to the
// left of it. Named tests use exact times; where several lines cross at one point, the expected
// order was derived by hand from the contract. Every test asks for at least two different answers,
// so that no constant passes.
#include "in_order.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <algorithm>

namespace {

using namespace contact::testing;
using exercise::Bead;
using exercise::Meeting;
using Meetings = std::vector<Meeting>;
using Wire = std::vector<Bead>;

/// Computed from the velocities at the start alone.
Meetings of_the_start(const Wire& beads, double until) {
  Meetings list;
  for (std::size_t i = 0; i + 1 < beads.size(); ++i) {
    const double closing = beads[i].velocity - beads[i + 1].velocity;
    if (!(closing > 0)) continue;
    const double time = (beads[i + 1].position - beads[i].position) / closing;
    if (time <= until) list.push_back({time, static_cast<int>(i)});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Meeting& a, const Meeting& b) { return a.time < b.time; });
  return list;
}

Meetings before_the_end(Meetings right, double until) {
  std::erase_if(right, [until](const Meeting& m) { return m.time >= until; });
  return right;
}

enum class Mistake { pair_once, larger_index };

/// Lines that are exchanged where beads meet: the position that each bead would have had at time 0.
Meetings followed(Wire lines, double until, Mistake mistake) {
  Meetings list;
  std::vector<bool> met(lines.size(), false);
  double clock = 0;
  while (list.size() < 1000) {
    Meeting next{std::numeric_limits<double>::infinity(), -1};
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      const double closing = lines[i].velocity - lines[i + 1].velocity;
      if ((met[i] && mistake == Mistake::pair_once) || !(closing > 0)) continue;
      const double time = std::max(clock, (lines[i + 1].position - lines[i].position) / closing);
      if (time < next.time || (mistake == Mistake::larger_index && time <= next.time))
        next = {time, static_cast<int>(i)};
    }
    if (next.left < 0 || next.time > until) return list;
    const auto i = static_cast<std::size_t>(next.left);
    clock = next.time;
    met[i] = true;
    std::swap(lines[i], lines[i + 1]);
    list.push_back(next);
  }
  return list;
}

/// A queue from which no time is removed when another meeting changes a velocity.
Meetings with_stale_times(Wire lines, double until) {
  Meetings queue;
  Meetings list;
  double clock = 0;
  const auto predict = [&](int left) {
    const auto i = static_cast<std::size_t>(left);
    if (left < 0 || i + 1 >= lines.size()) return;
    const double closing = lines[i].velocity - lines[i + 1].velocity;
    if (!(closing > 0)) return;
    queue.push_back({std::max(clock, (lines[i + 1].position - lines[i].position) / closing), left});
  };
  for (int i = 0; i + 1 < static_cast<int>(lines.size()); ++i) predict(i);
  while (!queue.empty() && list.size() < 1000) {
    const auto next =
        std::min_element(queue.begin(), queue.end(), [](const Meeting& a, const Meeting& b) {
          return a.time < b.time || (a.time == b.time && a.left < b.left);
        });
    const Meeting meeting = *next;
    queue.erase(next);
    if (meeting.time > until) break;
    clock = meeting.time;
    const auto i = static_cast<std::size_t>(meeting.left);
    std::swap(lines[i], lines[i + 1]);
    list.push_back(meeting);
    predict(meeting.left - 1);
    predict(meeting.left + 1);
  }
  return list;
}

void check(const Wire& beads, double until, const Meetings& right) {
  ask("Which beads meet, and when?")
      .given("beads", beads)
      .given("until", until)
      .suspect("from-the-start-alone", [&] { return of_the_start(beads, until); })
      .suspect("end-left-out", [&] { return before_the_end(right, until); })
      .suspect("ties-by-the-larger-index",
               [&] { return followed(beads, until, Mistake::larger_index); })
      .suspect("pair-meets-once", [&] { return followed(beads, until, Mistake::pair_once); })
      .suspect("stale-meetings-kept", [&] { return with_stale_times(beads, until); })
      .answer([&] { return exercise::meetings(beads, until); })
      // Positions below 100 m, speeds of about 5 m/s, and a few roundings a meeting.
      .close_to(right, within(1e-9));
}

}  // namespace

TEST_CASE("two beads meet once or never") {
  check({{0, 1}, {2, -1}}, 10, {{1, 0}});
  check({{0, 1}, {2, 1}}, 10, {});
  check({{0, -1}, {2, 1}}, 10, {});
  check({{0, 3}, {2, -1}}, 10, {{0.5, 0}});
  check({{1, 2}, {1, 1}}, 10, {{0, 0}});
}

TEST_CASE("a chain of three") {
  // The first hits the second, which hits the third.
  check({{0, 2}, {1, 0}, {3, 0}}, 10, {{0.5, 0}, {1.5, 1}});
  // The third moves towards them, and the first two meet again.
  check({{0, 2}, {1, 0}, {4, -1}}, 10, {{0.5, 0}, {4.0 / 3, 1}, {3, 0}});
  // Without the first, the second would meet the third at 4 s; with it, they meet earlier.
  check({{0, 4}, {2, 1}, {6, 0}}, 10, {{2.0 / 3, 0}, {1.5, 1}, {4, 0}});
}

TEST_CASE("a meeting at the end is included") {
  check({{0, 1}, {2, -1}}, 1, {{1, 0}});
  check({{0, 1}, {2, -1}}, 0.875, {});
  check({{0, 2}, {1, 0}, {3, 0}}, 1.5, {{0.5, 0}, {1.5, 1}});
}

TEST_CASE("three at one position meet three times") {
  check({{-1, 1}, {0, 0}, {1, -1}}, 10, {{1, 0}, {1, 1}, {1, 0}});
  check({{-2, 1}, {0, 0}, {2, -1}, {9, 0}}, 20, {{2, 0}, {2, 1}, {2, 0}, {11, 2}});
}

TEST_CASE("distant pairs that meet at one time are ordered by index") {
  check({{0, 1}, {2, -1}, {100, 1}, {102, -1}}, 5, {{1, 0}, {1, 2}});
  check({{0, 2}, {4, -2}, {50, 4}, {54, 0}, {99, 1}, {101, -1}}, 5, {{1, 0}, {1, 2}, {1, 4}});
}

TEST_CASE("random wires agree with crossing lines") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 150; ++asked) {
    Wire beads;
    double place = 0;
    const int count = random.integer(2, 7);
    for (int i = 0; i < count; ++i) {
      place += random.uniform(0.1, 3);
      beads.push_back({place, random.uniform(-5, 5)});
    }
    const double until = random.uniform(0.5, 6);
    Meetings right;
    bool close = false;
    for (std::size_t i = 0; i < beads.size(); ++i) {
      for (std::size_t j = i + 1; j < beads.size(); ++j) {
        const double closing = beads[i].velocity - beads[j].velocity;
        if (!(closing > 0)) continue;
        const double time = (beads[j].position - beads[i].position) / closing;
        close = close || std::abs(time - until) < 1e-6;
        if (time > until) continue;
        const double there = beads[i].position + beads[i].velocity * time;
        int left = 0;
        for (std::size_t k = 0; k < beads.size(); ++k) {
          if (k == i || k == j) continue;
          const double other = beads[k].position + beads[k].velocity * time;
          close = close || std::abs(other - there) < 1e-6;
          left += other < there;
        }
        right.push_back({time, left});
      }
    }
    std::sort(right.begin(), right.end(),
              [](const Meeting& a, const Meeting& b) { return a.time < b.time; });
    for (std::size_t i = 1; i < right.size(); ++i) {
      close = close || right[i].time - right[i - 1].time < 1e-6;
    }
    if (!close) check(beads, until, right);
  }
}
