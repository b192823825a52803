#include "sphere_plane.hpp"

namespace exercise {

bool meets(const contact::Sphere<double>& /*sphere*/, const contact::Plane<double>& /*plane*/) {
  contact::todo();
}

bool meets_loose(const contact::Sphere<double>& /*sphere*/, const LoosePlane& /*plane*/) {
  contact::todo();
}

}  // namespace exercise
