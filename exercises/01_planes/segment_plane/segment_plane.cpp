#include "segment_plane.hpp"

namespace exercise {

std::optional<contact::RayHit<double>> segment_plane(const contact::Segment<double>& /*segment*/,
                                                     const contact::Plane<double>& /*plane*/) {
  // A hit is written `return contact::RayHit<double>{t, point};`, a miss `return std::nullopt;`.
  contact::todo();
}

}  // namespace exercise
