// misconception: hits-beyond-the-end
// caught by: a segment through the plane meets it at a fraction of its length
// seen: https://github.com/sympy/sympy/issues/15069
//   a segment is cut with a plane as if it were a line
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if (d0 == d1) return std::nullopt;
  const double t = d0 / (d0 - d1);
  if (t < 0) return std::nullopt;
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
