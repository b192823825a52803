// misconception: fraction-from-the-end
// caught by: a segment through the plane meets it at a fraction of its length
// seen: https://vidaara.org/cat/quant/coordinate-geometry/learn/section-formula
//   the trap of the section formula: a ratio taken from the other end
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0)) return std::nullopt;
  if (d0 == d1) return std::nullopt;
  const double t = d1 / (d1 - d0);
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
