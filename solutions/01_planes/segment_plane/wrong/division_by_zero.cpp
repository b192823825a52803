// misconception: division-by-zero
// caught by: a segment in the plane, or of no length, has no single point
// seen: https://github.com/libgdx/libgdx/pull/5286 the hit of a parallel segment is NaN
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0)) return std::nullopt;
  const double t = d0 / (d0 - d1);
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
