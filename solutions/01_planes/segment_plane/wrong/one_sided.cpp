// misconception: one-sided
// caught by: the plane is met from the front and from the back
// seen: https://github.com/RadicalCSG/Chisel.Prototype/pull/25
//   a ray that comes from behind the plane does not hit it
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if (d0 < 0 || d1 > 0) return std::nullopt;
  if (d0 == d1) return std::nullopt;
  const double t = d0 / (d0 - d1);
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
