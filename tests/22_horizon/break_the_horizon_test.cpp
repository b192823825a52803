// Both points are followed in pairs of doubles, from the start as it is stored. Their roundings, of
// about 1e-31, grow like the distance of the two points: by 1e9 until this is a millimetre, so the
// distances are right in more than ten digits, also after a graze.
#include "break_the_horizon.hpp"
#include "hits_until_apart.hpp"

#include <22_horizon/double_double.hpp>
#include <22_horizon/twins.hpp>
#include <support/break_it.hpp>

namespace {

using namespace contact::testing;
using exercise::Start;
using Hits = std::vector<twins::Hit>;

constexpr double millimetre = 1e-3;
const int expected = given::hits_until_apart(twins::radius);  // 15

Hits followed(const Start& s) {
  return twins::follow<twins::DoubleDouble>(s.position.x(), s.position.y(), s.direction.x(),
                                            s.direction.y(), expected, millimetre);
}

bool apart(const Hits& hits) { return !hits.empty() && hits.back().apart > millimetre; }

double longest_flight(const Hits& hits) {
  double longest = 0;
  for (const twins::Hit& hit : hits) longest = std::max(longest, hit.flight);
  return longest;
}

/// Of the hits that spread the paths: all but the last.
double least_cosine(const Hits& hits) {
  double least = 1;
  for (std::size_t i = 0; i + 1 < hits.size(); ++i) least = std::min(least, hits[i].cosine);
  return least;
}

std::string told(double number) { return contact::text_of(number, {.digits = 3}); }

/// @param by the latest hit that counts
auto judge(int by) {
  return [by](const Start& start) {
    const Hits hits = followed(start);
    const bool early = apart(hits) && static_cast<int>(hits.size()) <= by;
    const std::size_t at = std::min(hits.size(), static_cast<std::size_t>(by));
    return Judged{early, std::to_string(given::hits_until_apart(twins::radius)) + " hits",
                  apart(hits) ? "apart at hit " + std::to_string(hits.size())
                              : "not apart at hit " + std::to_string(expected),
                  "At the time of hit " + std::to_string(at) + " the two are " +
                      told(hits[at - 1].apart) + " m apart. Up to hit " +
                      std::to_string(hits.size()) + " the longest flight is " +
                      told(longest_flight(hits)) + " m, and the least cosine " +
                      told(least_cosine(hits)) + "."};
  };
}

bool is_allowed(const Start& s) {
  const auto in_cell = [](double x) { return x >= 0 && x <= 1; };
  const double length = s.direction.norm();
  return in_cell(s.position.x()) && in_cell(s.position.y()) && length >= 0.1 && length <= 10;
}

bool is_followed(const Start& s) {
  const Hits hits = followed(s);
  return (apart(hits) || static_cast<int>(hits.size()) == expected) &&
         longest_flight(hits) <= twins::max_flight;
}

bool is_outside(const Start& s) {
  return twins::is_outside<twins::DoubleDouble>({s.position.x(), s.position.y()});
}

BreakIt<Start> question(std::string_view text) {
  return break_it<Start>(text)
      .rule("both coordinates are from 0 to 1, and the length of the direction from 0.1 to 10",
            is_allowed)
      .rule("the start is at least 1e-6 m away from every post", is_outside)
      .rule("the point hits posts until the two are apart, and flies at most 10 m to each",
            is_followed);
}

bool is_head_on(const Start& s) { return least_cosine(followed(s)) >= 0.9; }

}  // namespace

TEST_CASE("by hit 7") {
  question("From which start are the two a millimetre apart by hit 7?")
      .suspect_if("break-graze-is-not-close",
                  [](const Start& s) { return least_cosine(followed(s)) > 1e-4; })
      .input("start", [] { return exercise::apart_by_hit_7(); })
      .judge(judge(7));
}

TEST_CASE("without oblique hits") {
  question("From which start are the two a millimetre apart by hit 12, without oblique hits?")
      .rule("the cosine of each hit is at least 0.9", is_head_on)
      .suspect_if("break-gap-is-no-longer-than-the-mean",
                  [](const Start& s) {
                    return longest_flight(followed(s)) <= given::mean_flight(twins::radius);
                  })
      .input("start", [] { return exercise::without_oblique_hits(); })
      .judge(judge(12));
}

TEST_CASE("without long flights") {
  question("From which start are the two a millimetre apart by hit 15, without long flights?")
      .rule("the cosine of each hit is at least 0.9", is_head_on)
      .rule("no flight is longer than the mean, 0.62168 m",
            [](const Start& s) {
              return longest_flight(followed(s)) <= given::mean_flight(twins::radius);
            })
      .suspect_if("break-gap-is-far-below-the-mean",
                  [](const Start& s) { return longest_flight(followed(s)) < 0.4; })
      .input("start", [] { return exercise::without_long_flights(); })
      .judge(judge(expected));
}
