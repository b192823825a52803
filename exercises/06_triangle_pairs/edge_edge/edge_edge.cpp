#include "edge_edge.hpp"

namespace exercise {

bool in_one_plane(const contact::Segment<double>& /*a*/, const contact::Segment<double>& /*b*/) {
  contact::todo();
}

bool edges_meet(const contact::Segment<double>& /*a*/, const contact::Segment<double>& /*b*/) {
  contact::todo();
}

std::optional<EdgeContact> edge_contact(const contact::Segment<double>& /*a*/,
                                        const contact::Segment<double>& /*b*/,
                                        const Eigen::Vector3d& /*inside_b*/) {
  contact::todo();
}

}  // namespace exercise
