// misconception: absolute-epsilon
// caught by: the smallest component counts
// seen: https://github.com/flow123d/flow123d/issues/374 velocities below 1e-8 are taken for zero
#include "stays_in_a_plane.hpp"

namespace exercise {

std::array<bool, 3> inactive_axes(const Scene& scene) {
  std::array<bool, 3> still{};
  for (int k = 0; k < 3; ++k) {
    const double nothing = 1e-9;
    bool holds = std::abs(scene.gravity(k)) < nothing;
    for (const Eigen::Vector3d& normal : scene.normals)
      holds = holds && std::abs(normal(k)) < nothing;
    for (const Ball& ball : scene.balls) {
      holds = holds && std::abs(ball.velocity(k)) < nothing &&
              std::abs(ball.centre(k) - scene.balls[0].centre(k)) < nothing;
    }
    still[static_cast<std::size_t>(k)] = holds;
  }
  return still;
}

}  // namespace exercise
