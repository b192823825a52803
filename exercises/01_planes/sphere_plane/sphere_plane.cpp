#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& /*sphere*/, const contact::Plane<double>& /*plane*/) {
  contact::todo();
}

bool meets_raw(const contact::Sphere<double>& /*sphere*/, const RawPlane& /*plane*/) {
  contact::todo();
}

}  // namespace exercise
