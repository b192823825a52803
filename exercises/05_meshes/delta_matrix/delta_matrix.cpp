#include "delta_matrix.hpp"

namespace exercise {

Eigen::Matrix4d delta_matrix(const Motion& /*body*/) { contact::todo(); }

contact::Segment<double> segment_seen(const Motion& /*a*/, const Motion& /*b*/,
                                      const Eigen::Vector3d& /*vertex*/) {
  contact::todo();
}

double chord_bound(const Motion& /*a*/, const Motion& /*b*/, const Eigen::Vector3d& /*vertex*/) {
  contact::todo();
}

}  // namespace exercise
