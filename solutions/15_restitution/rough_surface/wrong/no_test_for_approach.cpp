// misconception: bounce-when-separating
// caught by: what moves away is left alone
#include "rough_surface.hpp"

namespace exercise {

Eigen::Vector3d after_rough_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                                   double k, double friction) {
  const double along_normal = velocity.dot(normal);
  const Eigen::Vector3d tangent = velocity - along_normal * normal;
  const double slip = tangent.norm();
  const double taken = std::min(slip, friction * (1 + k) * std::abs(along_normal));
  const double kept = slip > 0 ? 1 - taken / slip : 0;
  return kept * tangent - k * along_normal * normal;
}

double rebound_tangent(double incidence, double k, double friction) {
  return std::max(0.0, incidence - friction * (1 + k)) / k;
}

}  // namespace exercise
