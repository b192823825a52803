#include "rough_surface.hpp"

namespace exercise {

Eigen::Vector3d after_rough_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                                   double k, double friction) {
  //? The impulse of the surface depends on the normal component of the velocity.
  //? gap: velocity.dot(normal)
  const double along_normal = velocity.dot(normal);
  //? A body that does not approach is not hit.
  //? gap: along_normal < 0
  if (!(along_normal < 0)) return velocity;
  //? What remains of the velocity is tangential; friction acts against it.
  //? gap: along_normal * normal
  const Eigen::Vector3d tangent = velocity - along_normal * normal;
  //? The speed of sliding limits what friction can take.
  //? gap: tangent.norm()
  const double slip = tangent.norm();
  //? The normal impulse changes the normal velocity by (1 + k) times its size. Friction takes at
  //? most μ times that, and never more than there is.
  //? gap: -friction * (1 + k) * along_normal
  const double taken = std::min(slip, -friction * (1 + k) * along_normal);
  //? As a factor the rest keeps the direction. Without slip there is nothing to divide by.
  //? gap: 1 - taken / slip
  const double kept = slip > 0 ? 1 - taken / slip : 0;
  //? The tangential part is reduced; the normal part is reversed and multiplied by k.
  //? gap: k * along_normal * normal
  return kept * tangent - k * along_normal * normal;
}

double rebound_tangent(double incidence, double k, double friction) {
  //? The same, divided by the normal velocity: the tangent decreases by μ(1 + k), not below 0, and
  //? the new normal velocity is k times the old.
  //? gap: incidence - friction * (1 + k)
  return std::max(0.0, incidence - friction * (1 + k)) / k;
}

}  // namespace exercise
