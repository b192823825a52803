#include "in_order.hpp"

namespace exercise {

std::vector<Meeting> meetings(const std::vector<Bead>& /*beads*/, double /*until*/) {
  contact::todo();
}

}  // namespace exercise
