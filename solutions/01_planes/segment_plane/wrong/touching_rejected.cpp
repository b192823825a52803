// misconception: touching-rejected
// caught by: an end on the plane counts
// seen: https://github.com/nicklockwood/Euclid/issues/112
//   an end on the plane is found in one direction only
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if ((d0 >= 0 && d1 >= 0) || (d0 <= 0 && d1 <= 0)) return std::nullopt;
  const double t = d0 / (d0 - d1);
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
