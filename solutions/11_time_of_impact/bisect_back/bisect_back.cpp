#include "bisect_back.hpp"

namespace exercise {

bool overlap_at(const std::vector<Overlap>& overlaps, double t) {
  return std::any_of(overlaps.begin(), overlaps.end(),
                     [&](const Overlap& one) { return one.begin <= t && t <= one.end; });
}

Bracket bisect_back(const std::vector<Overlap>& overlaps, int halvings) {
  Bracket bracket;
  const auto overlap = [&](double t) {
    bracket.asked.push_back(t);
    const bool overlapping = overlap_at(overlaps, t);
    auto& end = overlapping ? bracket.overlapping : bracket.free;
    end = t;
    return overlapping;
  };
  if (overlap(0) || !overlap(1)) return bracket;
  for (int k = 0; k < halvings; ++k) overlap((*bracket.free + *bracket.overlapping) / 2);
  return bracket;
}

}  // namespace exercise
