// misconception: metres-for-fraction
// caught by: a segment through the plane meets it at a fraction of its length
// seen: https://github.com/jrouwe/JoltPhysics.js/issues/154
//   a fraction is to be multiplied by a normalised direction
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  const Eigen::Vector3d direction = (segment.end - segment.start).normalized();
  const double closing = -plane.normal.dot(direction);
  if (closing == 0) return std::nullopt;
  const double t = (plane.normal.dot(segment.start) - plane.offset) / closing;
  if (!(t >= 0 && t <= 1)) return std::nullopt;
  return contact::RayHit<double>{t, segment.start + t * direction};
}

}  // namespace exercise
