#include "slabs_overlap.hpp"

namespace exercise {

std::vector<Slab> slabs_of(const std::vector<Eigen::Vector3d>& /*directions*/,
                           const std::vector<Eigen::Vector3d>& /*vertices*/) {
  contact::todo();
}

bool between_each_pair(const std::vector<Eigen::Vector3d>& /*directions*/,
                       const std::vector<Slab>& /*slabs*/, const Eigen::Vector3d& /*point*/) {
  contact::todo();
}

int first_separating(const std::vector<Slab>& /*first*/, const std::vector<Slab>& /*second*/) {
  contact::todo();
}

std::vector<Slab> moved(const std::vector<Eigen::Vector3d>& /*directions*/,
                        const std::vector<Slab>& /*slabs*/,
                        const Eigen::Vector3d& /*displacement*/) {
  contact::todo();
}

}  // namespace exercise
