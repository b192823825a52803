#include "coplanar.hpp"

namespace exercise {

bool in_one_plane(const contact::Triangle<double>& /*first*/,
                  const contact::Triangle<double>& /*second*/) {
  contact::todo();
}

bool meet_in_one_plane(const contact::Triangle<double>& /*first*/,
                       const contact::Triangle<double>& /*second*/) {
  contact::todo();
}

}  // namespace exercise
