// misconception: old-velocity-in-both
// caught by: from rest, explicit Euler stays and symplectic Euler moves
// seen: https://github.com/SciML/OrdinaryDiffEq.jl/issues/577
#include "two_eulers.hpp"

namespace exercise {

Body explicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  return {body.position + step * body.velocity, body.velocity + step * acceleration};
}

Body semi_implicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  return {body.position + step * body.velocity, body.velocity + step * acceleration};
}

}  // namespace exercise
