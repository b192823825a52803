// misconception: friction-of-the-stop-alone
// caught by: friction acts during the whole change of the normal velocity
// seen: not found
#include "rough_surface.hpp"

namespace exercise {

Eigen::Vector3d after_rough_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                                   double k, double friction) {
  const double along_normal = velocity.dot(normal);
  if (!(along_normal < 0)) return velocity;
  const Eigen::Vector3d tangent = velocity - along_normal * normal;
  const double slip = tangent.norm();
  const double taken = std::min(slip, -friction * along_normal);
  const double kept = slip > 0 ? 1 - taken / slip : 0;
  return kept * tangent - k * along_normal * normal;
}

double rebound_tangent(double incidence, double k, double friction) {
  return std::max(0.0, incidence - friction) / k;
}

}  // namespace exercise
