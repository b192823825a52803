// What bisection finds follows from the overlaps alone, without rounding: all times are whole
// multiples of 2⁻⁵⁰. The first questions of a test each bring one mistake to light that no question
// before did.
#include "bisect_back.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <11_time_of_impact/bisect_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using bisect_with_mistakes::Overlaps;
using bisect_with_mistakes::Ways;
using exercise::Bracket;
using exercise::Overlap;

void check_overlap(const Overlaps& overlaps, double t) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return bisect_with_mistakes::overlap_at(overlaps, t, ways); };
  };
  ask("Do the bodies touch or overlap at t?")
      .given("overlaps", overlaps)
      .given("t", t)
      .suspect("touching-is-free", with({.ends_free = true}))
      .suspect("first-overlap-alone", with({.first_alone = true}))
      .answer([&] { return exercise::overlap_at(overlaps, t); })
      .equals(with({})());
}

void check(const Overlaps& overlaps, int halvings) {
  const auto with = [&](const Ways& ways) {
    return [&, ways] { return bisect_with_mistakes::bisect_back(overlaps, halvings, ways); };
  };
  const bool at_start = bisect_with_mistakes::overlap_at(overlaps, 0, {});
  const Bracket right = with({})();
  // A hint must be true of the answer in hand: of two times, of halvings that were made.
  const bool both = right.free && right.overlapping;
  ask("Which times does bisection find free and overlapping?")
      .given("overlaps", overlaps)
      .given("halvings", halvings)
      .suspect("touching-is-free", with({.ends_free = true}))
      .suspect("first-overlap-alone", with({.first_alone = true}))
      .suspect("start-assumed-free", with({.start_free = true}))
      .suspect("overlap-at-start-halved", with({.start_goes_on = at_start}))
      .suspect("end-assumed-to-overlap", with({.end_overlaps = true}))
      .suspect("free-end-halved", with({.end_goes_on = halvings > 0}))
      .suspect("end-asked-first", with({.end_first = true}))
      .suspect("keeps-the-wrong-half", with({.wrong_half = true}))
      .suspect("ends-at-the-first-free-time", with({.back_alone = true}))
      .suspect("one-halving-more", with({.more = 1}))
      .suspect("one-halving-less", with({.more = -1}))
      .suspect("last-middle-for-the-free-time", with({.last_middle = true}))
      .suspect("bracket-exchanged", with({.exchanged = both}))
      .suspect("start-and-end-not-listed", with({.middles_alone = true}))
      .suspect_if("time-that-was-not-asked",
                  [](const Bracket& got) {
                    const auto unasked = [&](const std::optional<double>& t) {
                      return t && *t != 0 && *t != 1 &&
                             std::find(got.asked.begin(), got.asked.end(), *t) == got.asked.end();
                    };
                    return unasked(got.free) || unasked(got.overlapping);
                  })
      .answer([&] { return exercise::bisect_back(overlaps, halvings); })
      .equals(right);
}

bool is_judged(const Overlaps& overlaps, int halvings) {
  return halvings >= 0 && halvings <= 50 &&
         std::all_of(overlaps.begin(), overlaps.end(), [](const Overlap& one) {
           return std::isfinite(one.begin) && std::isfinite(one.end) && one.begin <= one.end;
         });
}

}  // namespace

TEST_CASE("an overlap includes its ends") {
  check_overlap({{0.25, 0.5}}, 0.375);
  check_overlap({{0.25, 0.5}}, 0.75);
  check_overlap({{0.25, 0.5}}, 0.25);
  check_overlap({{0.25, 0.5}}, 0.5);
  check_overlap({{0.75, 0.875}, {0.25, 0.5}}, 0.375);
  check_overlap({{0.25, 0.5}, {0.625, 0.625}, {0.75, 0.875}}, 0.625);
  check_overlap({{0.25, 0.5}, {0.75, 0.875}}, 0.625);
  check_overlap({}, 0.5);
}

TEST_CASE("halvings close in on an impact") {
  check({{0.3, 1}}, 4);
  check({{0.7, 1.5}}, 4);
  check({{0.125, 1}}, 3);
  check({{0.9, 1}}, 6);
  check({{0.01, 2}}, 5);
}

TEST_CASE("bodies that overlap at the start have no free time") {
  check({{0, 0.2}}, 3);
  check({{-1, 2}}, 3);
  check({{-1, 0}}, 3);
  check({{0.6, 1}, {0, 0.1}}, 3);
  check({{0.3, 1}}, 3);
}

TEST_CASE("a step with free ends counts as free") {
  check({{0.4, 0.6}}, 3);
  check({}, 5);
  check({{-2, -1}, {1.5, 2}}, 5);
  check({{0.3, 1}}, 3);
}

TEST_CASE("no halving leaves the step, and fifty leave little") {
  check({{0.3, 1}}, 0);
  check({{0.3, 1}}, 1);
  check({{0.1, 1}}, 50);
  check({{0x1p-60, 1}}, 50);
  check({{0.9375, 1}}, 50);
}

TEST_CASE("one of several impacts is found") {
  check({{0.7, 1}, {0.2, 0.3}}, 4);
  check({{0.2, 0.3}, {0.7, 1}}, 6);
  check({{0.1, 0.6}, {0.9, 1}}, 4);
  check({{0.4, 0.45}, {0.55, 0.6}, {1, 1}}, 5);
}

TEST_CASE("random overlaps agree") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    Overlaps overlaps;
    for (int n = random.integer(0, 3); n > 0; --n) {
      const double begin = random.integer(-4, 36) / 32.0;
      overlaps.push_back({begin, begin + random.integer(0, 12) / 32.0});
    }
    if (random.chance(0.7)) overlaps.push_back({random.uniform(0.01, 1), 1});
    const int halvings = random.integer(0, 12);
    shrinkable(check, is_judged, overlaps, halvings);
    const double t = random.integer(0, 32) / 32.0;
    check_overlap(overlaps, t);
  }
}
