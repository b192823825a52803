/// @file
/// Bisection of a step with one mistake that people make: what the test of the exercise recognises.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bisect_back.hpp"

namespace bisect_with_mistakes {

using exercise::Bracket;
using exercise::Overlap;
using Overlaps = std::vector<Overlap>;

/// What is done wrong.
struct Ways {
  bool ends_free = false;      ///< bodies that just touch are free
  bool first_alone = false;    ///< only the first overlap of the list counts
  bool start_free = false;     ///< the start is taken to be free
  bool start_goes_on = false;  ///< an overlap at the start does not end the search
  bool end_overlaps = false;   ///< the end is taken to overlap
  bool end_goes_on = false;    ///< a free end does not end the search
  bool end_first = false;      ///< the end is asked before the start
  bool wrong_half = false;     ///< the other half is kept
  bool back_alone = false;     ///< the search ends at the first free time
  int more = 0;                ///< halvings than asked for
  bool last_middle = false;    ///< the last middle is the free time, whatever was found
  bool exchanged = false;      ///< the free time is called overlapping
  bool middles_alone = false;  ///< start and end are not listed
};

inline bool overlap_at(const Overlaps& overlaps, double t, const Ways& ways) {
  for (const Overlap& one : overlaps) {
    const bool open = ways.ends_free;
    if (open ? one.begin < t && t < one.end : one.begin <= t && t <= one.end) return true;
    if (ways.first_alone) break;
  }
  return false;
}

inline Bracket bisect_back(const Overlaps& overlaps, int halvings, const Ways& ways) {
  std::vector<double> asked;
  const auto overlap = [&](double t) {
    asked.push_back(t);
    return overlap_at(overlaps, t, ways);
  };
  const auto found = [&](std::optional<double> free, std::optional<double> overlapping) {
    if (ways.exchanged) std::swap(free, overlapping);
    if (ways.middles_alone) std::erase_if(asked, [](double t) { return t == 0 || t == 1; });
    return Bracket{free, overlapping, asked};
  };
  bool at_start = false, at_end = true;
  if (ways.end_first) at_end = overlap(1);
  if (!ways.start_free) at_start = overlap(0);
  if (at_start && !ways.start_goes_on) return found(std::nullopt, 0);
  if (!ways.end_first && !ways.end_overlaps) at_end = overlap(1);
  if (!at_end && !ways.end_goes_on) return found(1, std::nullopt);
  double free = 0, overlapping = 1;
  for (int k = 0; k < halvings + ways.more; ++k) {
    const double middle = (free + overlapping) / 2;
    const bool hit = overlap(middle);
    (hit != ways.wrong_half ? overlapping : free) = middle;
    if (ways.back_alone && !hit) break;
  }
  if (ways.last_middle && halvings > 0) free = asked.back();
  return found(free, overlapping);
}

}  // namespace bisect_with_mistakes
