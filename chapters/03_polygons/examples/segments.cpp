// Segments of every kind, and a pair that the textbook's formula gets wrong.
#include <cmath>
#include <contact/segments.hpp>
#include <cstdio>
#include <limits>

using contact::Meeting;
using contact::Segment2;
using contact::SegmentCrossing;

const char* text(Meeting meeting) {
  switch (meeting) {
    case Meeting::none:
      return "none";
    case Meeting::crossing:
      return "crossing";
    case Meeting::touching:
      return "touching";
    case Meeting::overlapping:
      break;
  }
  return "overlapping";
}

int main() {
  const Segment2<double> first{{0, 0}, {4, 2}};
  const auto with = [&first](const Segment2<double>& second) {
    const SegmentCrossing<double> found = contact::crossing(first, second);
    std::printf("(%g, %g) to (%g, %g): %-11s", second.a.x(), second.a.y(), second.b.x(),
                second.b.y(), text(found.meeting));
    if (found.meeting == Meeting::overlapping) {
      std::printf(" from (%g, %g) to (%g, %g)", found.overlap.a.x(), found.overlap.a.y(),
                  found.overlap.b.x(), found.overlap.b.y());
    } else if (found.meeting != Meeting::none) {
      std::printf(" at (%g, %g), fractions %g and %g", found.point.x(), found.point.y(),
                  found.along_first, found.along_second);
    }
    std::printf("\n");
  };
  std::printf("(0, 0) to (4, 2), and\n");
  with({{0, 2}, {4, 0}});
  with({{2, 1}, {3, 4}});
  with({{4, 2}, {8, 4}});
  with({{6, 3}, {2, 1}});
  with({{6, 3}, {8, 4}});
  with({{0, 1}, {4, 3}});
  with({{2, 1}, {2, 1}});

  // Two segments that differ by an ulp at their ends.
  const double above = std::nextafter(0.7, 1.0);
  const Segment2<double> low{{0.1, 0.7}, {1.1, above}}, high{{0.1, above}, {1.1, 0.7}};
  const SegmentCrossing<double> found = contact::crossing(low, high);
  std::printf("\nan ulp apart: %s at x = %.17g, right within %.1e\n", text(found.meeting),
              found.point.x(), found.point_bound);
  const auto slopes = contact::crossing_by_slopes(low, high);
  if (slopes) std::printf("by slopes:             x = %.17g\n", slopes->x());
}
