// misconception: friction-turns-back
// caught by: friction stops the slip and does not reverse it
// seen: https://github.com/joshuaange/LSPIS/issues/3 friction sometimes reverses the velocity
#include "rough_surface.hpp"

namespace exercise {

Eigen::Vector3d after_rough_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                                   double k, double friction) {
  const double along_normal = velocity.dot(normal);
  if (!(along_normal < 0)) return velocity;
  const Eigen::Vector3d tangent = velocity - along_normal * normal;
  const double slip = tangent.norm();
  const double taken = -friction * (1 + k) * along_normal;
  const double kept = slip > 0 ? 1 - taken / slip : 0;
  return kept * tangent - k * along_normal * normal;
}

double rebound_tangent(double incidence, double k, double friction) {
  return (incidence - friction * (1 + k)) / k;
}

}  // namespace exercise
