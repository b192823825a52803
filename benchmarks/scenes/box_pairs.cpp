// Translating box pairs of each kind: compares the book's sweep, rounded and exact, with Bullet's
// convex casts. Rational arithmetic gives the right answer.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <contact/box_sweep.hpp>

#include "11_time_of_impact/boxes.hpp"
#include "box_pairs.hpp"
#include "summary.hpp"

namespace {

using Times = std::vector<std::optional<double>>;
using Pairs = std::vector<std::array<boxes::Box, 2>>;

Times by_book(const Pairs& pairs) {
  Times times;
  times.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    const auto touch = contact::box_impact(a, b);
    times.push_back(touch ? std::optional<double>(touch->t) : std::nullopt);
  }
  return times;
}

Times exactly(const Pairs& pairs) {
  Times times;
  times.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    const auto touch = contact::detail::exact_sweep(contact::detail::exact_pair(a, b));
    times.push_back(
        touch ? std::optional<double>(quotient<double>(touch->t.numerator, touch->t.denominator))
              : std::nullopt);
  }
  return times;
}

#ifdef CONTACT_HAS_BULLET
std::vector<box_pairs::MovingBox> plain(const Pairs& pairs) {
  std::vector<box_pairs::MovingBox> all;
  for (const auto& pair : pairs) {
    for (const boxes::Box& box : pair) {
      box_pairs::MovingBox plain{};
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) plain.axes[3 * k + i] = box.frame.axes(i, k);
        plain.centre[k] = box.frame.origin(k);
        plain.half_lengths[k] = box.half_lengths(k);
        plain.displacement[k] = box.displacement(k);
      }
      all.push_back(plain);
    }
  }
  return all;
}
#endif

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// What a method made of all kinds together.
struct Total {
  double ms = 0;
  int missed = 0;
  int invented = 0;
};

void compare(const char* kind_name, boxes::Kind kind, int count, int runs,
             std::map<std::string, Total>& totals) {
  generators::Random random(6);
  Pairs pairs;
  for (int i = 0; i < count; ++i) pairs.push_back(boxes::make(random, kind));
  Times right;
  int hits = 0;
  int at_start = 0;
  for (const auto& [a, b] : pairs) {
    const auto touch = boxes::first_touch(a, b);
    right.push_back(touch ? std::optional<double>(oracle::nearest(*touch)) : std::nullopt);
    if (touch) ++(*touch > 0 ? hits : at_start);
  }

  std::vector<std::pair<std::string, std::function<Times()>>> methods{
      {"Contact Hours", [&] { return by_book(pairs); }},
      {"  without its filter", [&] { return exactly(pairs); }}};
#ifdef CONTACT_HAS_BULLET
  const box_pairs::Bullet bullet(plain(pairs));
  methods.emplace_back("Bullet, continuous cast",
                       [&] { return bullet.times(box_pairs::Cast::continuous); });
  methods.emplace_back("Bullet, GJK cast", [&] { return bullet.times(box_pairs::Cast::gjk); });
  methods.emplace_back("Bullet, subsimplex cast",
                       [&] { return bullet.times(box_pairs::Cast::subsimplex); });
#endif
  std::vector<std::vector<double>> elapsed(methods.size());
  std::vector<Times> found(methods.size());
  // In turns, so that a slow moment of the machine does not fall on one method only.
  for (int run = 0; run <= runs; ++run) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double start = processor_ms();
      found[m] = methods[m].second();
      const double took = processor_ms() - start;
      if (run > 0) elapsed[m].push_back(took);  // the first one warms up
    }
  }
  std::printf("%s: %d pairs, %d touch in the step, %d at the start\n", kind_name, count, hits,
              at_start);
  std::printf("  %-24s %10s %19s %7s %9s %9s %12s\n", "", "ms", "least - most", "missed",
              "at start", "invented", "worst |dt|");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::sort(elapsed[m].begin(), elapsed[m].end());
    int missed = 0;
    int missed_at_start = 0;
    int invented = 0;
    double worst = 0;
    for (std::size_t k = 0; k < right.size(); ++k) {
      if (right[k] && !found[m][k]) ++(*right[k] > 0 ? missed : missed_at_start);
      if (!right[k] && found[m][k]) ++invented;
      if (right[k] && found[m][k] && *right[k] > 0)
        worst = std::max(worst, std::abs(*right[k] - *found[m][k]));
    }
    std::printf("  %-24s %10.2f %8.2f - %8.2f %7d %9d %9d %12.2g\n", methods[m].first.c_str(),
                elapsed[m][elapsed[m].size() / 2], elapsed[m].front(), elapsed[m].back(), missed,
                missed_at_start, invented, worst);
    Total& total = totals[methods[m].first];
    total.ms += elapsed[m][elapsed[m].size() / 2];
    total.missed += missed + missed_at_start;
    total.invented += invented;
  }
  std::printf("\n");
}

}  // namespace

void box_pairs::compare_all(int count, int runs, Summary& summary) {
  std::printf("translating box pairs, medians of %d runs, ms of processor for all of a kind\n\n",
              runs);
  std::map<std::string, Total> totals;
  compare("turned boxes anywhere", boxes::Kind::plain, count, runs, totals);
  const std::map<std::string, Total> anywhere = totals;
  compare("bullets and a wall of 1 cm", boxes::Kind::thin_and_fast, count, runs, totals);
  compare("touching as the step ends", boxes::Kind::last_moment, count, runs, totals);
  compare("edges crosswise, to rounding", boxes::Kind::edges, count, runs, totals);
  compare("10,000 km from the origin", boxes::Kind::far, count, runs, totals);
  compare("whole numbers, along the axes", boxes::Kind::grid, count, runs, totals);
  for (const auto& [method, program] : {std::pair{"Contact Hours", "Contact Hours"},
                                        std::pair{"Bullet, continuous cast", "Bullet"}}) {
    if (!totals.contains(method)) continue;
    const Total& all = totals[method];
    summary.add(std::to_string(count) + " box pairs anywhere, ms", program, "%.2f",
                anywhere.at(method).ms);
    summary.add("  with five harder kinds, ms", program, "%.1f", all.ms);
    summary.add("  impacts missed in all", program, "%.0f", all.missed);
    summary.add("  impacts invented in all", program, "%.0f", all.invented);
  }
}
