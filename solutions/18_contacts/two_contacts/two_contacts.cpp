#include "two_contacts.hpp"

namespace exercise {

Eigen::Matrix2d inverse_effective_masses(double mass, double inertia,
                                         const Eigen::Vector2d& lever_arms) {
  //? An impulse accelerates the centre of mass, and every point with it.
  //? gap: 1 / mass
  const Eigen::Matrix2d moved = Eigen::Matrix2d::Constant(1 / mass);
  //? It also changes the angular velocity, by its own lever arm. A point then moves by the one
  //? that it has itself; on the other side of the centre that is the other direction.
  //? gap: lever_arms * lever_arms.transpose() / inertia
  const Eigen::Matrix2d turned = lever_arms * lever_arms.transpose() / inertia;
  //? Both together.
  return moved + turned;
}

Eigen::Vector2d impulses(const Eigen::Matrix2d& a, const Eigen::Vector2d& b) {
  const double coupling = a(0, 1);
  //? Neither contact is too slow: no impulse.
  //? gap: b(0) >= 0 && b(1) >= 0
  if (b(0) >= 0 && b(1) >= 0) return {0, 0};
  //? The first contact alone, if that is a push and the second one is not too slow afterwards.
  //? gap: -b(0) / a(0, 0)
  //? gap: coupling * first + b(1) >= 0
  const double first = -b(0) / a(0, 0);
  if (first >= 0 && coupling * first + b(1) >= 0) return {first, 0};
  //? The second contact alone.
  //? gap: -b(1) / a(1, 1)
  //? gap: coupling * second + b(0) >= 0
  const double second = -b(1) / a(1, 1);
  if (second >= 0 && coupling * second + b(0) >= 0) return {0, second};
  //? Both: two equations a x = −b, solved by Cramer's rule.
  //? gap: a(0, 0) * a(1, 1) - coupling * coupling
  const double determinant = a(0, 0) * a(1, 1) - coupling * coupling;
  return {(coupling * b(1) - a(1, 1) * b(0)) / determinant,
          (coupling * b(0) - a(0, 0) * b(1)) / determinant};
}

}  // namespace exercise
