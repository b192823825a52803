#include "fifteen_axes.hpp"

namespace exercise {

double gap_along(const contact::OrientedBox<double>& /*first*/,
                 const contact::OrientedBox<double>& /*second*/,
                 const Eigen::Vector3d& /*direction*/) {
  contact::todo();
}

LargestGap largest_gap(const contact::OrientedBox<double>& /*first*/,
                       const contact::OrientedBox<double>& /*second*/) {
  contact::todo();
}

}  // namespace exercise
