// The figure of the queue: what it shows of an event follows from what it shows before and after.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/hard_spheres.hpp>
#include <cstddef>
#include <tuple>
#include <vector>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
namespace queue_figure {
#include "figures/queue.cpp"
}

#include "support/generators.hpp"

namespace {

using generators::Random;
using queue_figure::discs;
using queue_figure::Input;
using queue_figure::leaves;
using queue_figure::most;
using queue_figure::Output;
using queue_figure::Vector2;

Input random_input(Random& random) {
  const auto point = [&random] {
    const double x = random.uniform(0.3, 3.7);
    return Vector2(x, random.uniform(0.3, 2.7));
  };
  const auto velocity = [&random] {
    const double x = random.uniform(-1, 1);
    return Vector2(x, random.uniform(-1, 1));
  };
  Input in;
  in.position_a = point();
  in.position_b = point();
  in.position_c = point();
  in.position_d = point();
  in.position_e = point();
  in.position_f = point();
  in.position_g = point();
  in.velocity_a = velocity();
  in.velocity_b = velocity();
  in.velocity_c = velocity();
  in.velocity_d = velocity();
  in.velocity_e = velocity();
  in.velocity_f = velocity();
  in.velocity_g = velocity();
  in.event = 0;
  return in;
}

/// The figure after 0, 1, 2 … events, for several arrangements.
template <class F>
void each_course(std::uint64_t seed, const F& f) {
  Random random(seed);
  for (int n = 0; n < 20; ++n) {
    Input in = random_input(random);
    std::vector<Output> course;
    for (; in.event <= static_cast<double>(most); ++in.event)
      course.push_back(queue_figure::compute(in));
    if (course.front().problem == 0) f(course);
  }
}

std::array<int, 2> cell_of(const Output& out, std::size_t disc) {
  return {static_cast<int>(std::floor(out.now[disc].x() / out.cell)),
          static_cast<int>(std::floor(out.now[disc].y() / out.cell))};
}

double neighbours(const Output& out, std::size_t disc) {
  double count = 0;
  const auto here = cell_of(out, disc);
  for (std::size_t i = 0; i < discs; ++i) {
    const auto there = cell_of(out, i);
    count += i != disc && std::abs(here[0] - there[0]) <= 1 && std::abs(here[1] - there[1]) <= 1;
  }
  return count;
}

}  // namespace

TEST_CASE("queue figure: the root is the event that comes next") {
  each_course(1, [](const std::vector<Output>& course) {
    for (std::size_t n = 0; n + 1 < course.size(); ++n) {
      const double winner = course[n].winner[1];
      const auto first = static_cast<std::size_t>(winner);
      const Output& after = course[n + 1];
      REQUIRE(course[n].next_time[first] == after.time);
      REQUIRE((winner == after.who || winner == after.whom));
    }
  });
}

TEST_CASE("queue figure: what changes in the tournament was played again") {
  double stopped_early = 0;
  each_course(2, [&](const std::vector<Output>& course) {
    for (std::size_t n = 1; n < course.size(); ++n) {
      const Output& before = course[n - 1];
      const Output& after = course[n];
      double matches = 0;
      for (std::size_t node = 1; node < leaves; ++node) {
        const double winner = after.winner[node];
        const auto i = static_cast<std::size_t>(winner);
        const bool changed = winner >= 0 && (winner != before.winner[node] ||
                                             after.next_time[i] != before.next_time[i]);
        if (changed) REQUIRE(after.played[node] > 0);
        // The seventh disc has no opponent in the first round.
        if (after.winner[2 * node + 1] >= 0) matches += after.played[node];
      }
      REQUIRE(matches == after.matches);
      const bool two = after.kind == 1 && after.whom < static_cast<double>(discs);
      REQUIRE(matches <= (two ? 6 : 3));
      stopped_early += matches < (two ? 6 : 3);
    }
  });
  CHECK(stopped_early > 0);
}

TEST_CASE("queue figure: events are hits, crossings or void predictions") {
  double voids = 0;
  each_course(3, [&](const std::vector<Output>& course) {
    for (std::size_t n = 0; n < course.size(); ++n) {
      const Output& out = course[n];
      REQUIRE(out.event == static_cast<double>(n));
      REQUIRE(out.hits + out.crossings + out.voids == out.event);
      const auto shown = out.kinds.begin() + static_cast<std::ptrdiff_t>(n);
      REQUIRE(out.hits == static_cast<double>(std::count(out.kinds.begin(), shown, 1.0)));
      REQUIRE(out.voids == static_cast<double>(std::count(out.kinds.begin(), shown, 3.0)));
      voids += out.voids;
    }
  });
  CHECK(voids > 0);
}

TEST_CASE("queue figure: the tests are those of discs in the cells that are searched") {
  each_course(4, [](const std::vector<Output>& course) {
    double first = 0;
    for (std::size_t i = 0; i < discs; ++i) first += neighbours(course[0], i);
    REQUIRE(course[0].tests == first);
    REQUIRE(course[0].all_tests == static_cast<double>(discs * (discs - 1)));
    for (std::size_t n = 1; n < course.size(); ++n) {
      const Output& out = course[n];
      const double made = out.tests - course[n - 1].tests;
      const auto who = static_cast<std::size_t>(out.who);
      double wanted = 0;
      if (out.kind == 2) {
        // One row or column of the neighbouring cells is new.
        REQUIRE(std::count(out.seen.begin(), out.seen.end(), 2.0) <= 3);
        for (std::size_t i = 0; i < discs; ++i) {
          const auto at = cell_of(out, i);
          const int cell = at[1] * static_cast<int>(out.columns) + at[0];
          wanted += i != who && out.seen[static_cast<std::size_t>(cell)] == 2;
        }
      } else {
        wanted = neighbours(out, who);
        if (out.kind == 1 && out.whom < static_cast<double>(discs))
          wanted += neighbours(out, static_cast<std::size_t>(out.whom));
      }
      REQUIRE(made == wanted);
    }
  });
}

TEST_CASE("queue figure: a predicted hit that is not void touches its partner") {
  each_course(5, [](const std::vector<Output>& course) {
    for (const Output& out : course) {
      for (std::size_t i = 0; i < discs; ++i) {
        if (out.partner[i] < 0 || out.is_void[i] > 0) continue;
        if (out.partner[i] >= static_cast<double>(discs)) {
          const auto wall = static_cast<int>(out.partner[i]) - static_cast<int>(discs);
          const double x = out.meeting[i](wall / 2);
          const double wanted = wall == 0   ? queue_figure::radius
                                : wall == 1 ? queue_figure::width - queue_figure::radius
                                : wall == 2 ? queue_figure::radius
                                            : queue_figure::height - queue_figure::radius;
          REQUIRE(std::abs(x - wanted) < 1e-9);
          continue;
        }
        // Both move in a straight line from their stored positions until then.
        const auto k = static_cast<std::size_t>(out.partner[i]);
        const bool both = out.partner[k] == static_cast<double>(i) && out.is_void[k] == 0;
        if (!both) continue;
        const double distance = (out.meeting[i] - out.meeting[k]).norm();
        REQUIRE(std::abs(distance - 2 * queue_figure::radius) < 1e-9);
      }
    }
  });
}

TEST_CASE("queue figure: discs that overlap are moved apart and into the table") {
  Random random(6);
  Input in = random_input(random);
  in.position_b = in.position_a;
  in.position_c = {9, -9};
  const Output out = queue_figure::compute(in);
  REQUIRE(out.problem == 0);
  for (std::size_t i = 0; i < discs; ++i) {
    CHECK(out.start[i].x() >= queue_figure::radius);
    CHECK(out.start[i].y() >= queue_figure::radius);
    CHECK(out.start[i].x() <= queue_figure::width - queue_figure::radius);
    CHECK(out.start[i].y() <= queue_figure::height - queue_figure::radius);
    for (std::size_t k = 0; k < i; ++k)
      CHECK((out.start[i] - out.start[k]).norm() >= 2 * queue_figure::radius);
  }
}
