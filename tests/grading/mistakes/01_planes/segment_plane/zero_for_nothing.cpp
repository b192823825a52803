// mistake: wrong-type-returned
// says: For nothing, write std::nullopt.
#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& segment,
                                                     const contact::Plane<double>& plane) {
  if (plane.normal.dot(segment.start) > plane.offset) return 0;  // here
  return std::nullopt;
}

}  // namespace exercise
