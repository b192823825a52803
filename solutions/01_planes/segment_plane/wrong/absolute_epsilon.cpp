// misconception: absolute-epsilon
// caught by: tiny distances keep their signs
// seen: https://github.com/RiSearcher/GeometRi.CSharp/issues/1
//   a threshold of 1e-9 takes segments for parallel
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const double d0 = plane.normal.dot(segment.start) - plane.offset;
  const double d1 = plane.normal.dot(segment.end) - plane.offset;
  if ((d0 > 0 && d1 > 0) || (d0 < 0 && d1 < 0)) return std::nullopt;
  if (std::abs(d0 - d1) < 1e-8) return std::nullopt;  // parallel
  const double t = d0 / (d0 - d1);
  return contact::RayHit<double>{t, segment.start + t * (segment.end - segment.start)};
}

}  // namespace exercise
