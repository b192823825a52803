// 2,000 translating box pairs of each kind: the book's sweep, rounded and exact, beside Bullet's
// convex casts. What is right is decided by fractions.
// usage: box_pairs_peers [pairs] [runs]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <contact/box_sweep.hpp>

#include "11_time_of_impact/boxes.hpp"
#include "peers.hpp"

namespace {

using Times = std::vector<std::optional<double>>;
using Pairs = std::vector<std::array<boxes::Box, 2>>;

Times by_book(const Pairs& pairs) {
  Times times;
  times.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    const auto touch = contact::box_sweep(a, b);
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
std::vector<peers::MovingBox> plain(const Pairs& pairs) {
  std::vector<peers::MovingBox> all;
  for (const auto& pair : pairs) {
    for (const boxes::Box& box : pair) {
      peers::MovingBox plain{};
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

void compare(const char* kind_name, boxes::Kind kind, int count, int runs) {
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
  const peers::Bullet bullet(plain(pairs));
  methods.emplace_back("Bullet, continuous cast",
                       [&] { return bullet.times(peers::Cast::continuous); });
  methods.emplace_back("Bullet, GJK cast", [&] { return bullet.times(peers::Cast::gjk); });
  methods.emplace_back("Bullet, subsimplex cast",
                       [&] { return bullet.times(peers::Cast::subsimplex); });
#endif
  std::vector<std::vector<double>> elapsed(methods.size());
  std::vector<Times> found(methods.size());
  // In turns, so that a slow moment of the machine does not fall on one method only.
  for (int run = 0; run <= runs; ++run) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto start = std::chrono::steady_clock::now();
      found[m] = methods[m].second();
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      if (run > 0) elapsed[m].push_back(took.count());  // the first one warms up
    }
  }
  std::printf("%s: %d pairs, %d touch on their way, %d at the start\n", kind_name, count, hits,
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
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 2000;
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  compare("turned boxes anywhere", boxes::Kind::plain, count, runs);
  compare("bullets and a wall of 1 cm", boxes::Kind::thin_and_fast, count, runs);
  compare("touching as the step ends", boxes::Kind::last_moment, count, runs);
  compare("edges crosswise, to rounding", boxes::Kind::edges, count, runs);
  compare("10,000 km from the origin", boxes::Kind::far, count, runs);
  compare("whole numbers, along the axes", boxes::Kind::grid, count, runs);
}
