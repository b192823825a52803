#include "friction_clamp.hpp"

namespace exercise {

double normal_sum(double sum, double velocity, double effective_mass) {
  //? The visit by itself: the velocity becomes 0.
  //? gap: sum - velocity * effective_mass
  const double stopped = sum - velocity * effective_mass;
  //? The sum must be a push. A visit may take back what earlier ones gave.
  //? gap: std::max(stopped, 0.0)
  return std::max(stopped, 0.0);
}

Friction friction_after(const Eigen::Vector2d& sum, const Eigen::Vector2d& slip,
                        double effective_mass, double mu, double normal) {
  //? The visit by itself: the slip becomes 0.
  //? gap: sum - slip * effective_mass
  const Eigen::Vector2d stopped = sum - slip * effective_mass;
  //? Coulomb's law bounds the length of the sum, for all directions alike.
  //? gap: mu * normal
  //? gap: stopped.norm()
  const double most = mu * normal;
  const double length = stopped.norm();
  //? On the edge of the disc the contact still sticks.
  //? gap: length <= most
  const bool sticks = length <= most;
  //? The nearest vector of the disc has the same direction.
  //? gap: stopped * (most / length)
  const Eigen::Vector2d after = sticks ? stopped : Eigen::Vector2d(stopped * (most / length));
  //? Earlier visits have already given the old sum to the bodies.
  //? gap: after - sum
  return {after, after - sum, sticks};
}

}  // namespace exercise
