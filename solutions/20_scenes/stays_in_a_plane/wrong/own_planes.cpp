// misconception: centres-left-out
// caught by: balls push along the line of their centres
// seen: https://github.com/godotengine/godot/issues/12500
//   bodies push each other out of the plane of a game
#include "stays_in_a_plane.hpp"

namespace exercise {

std::array<bool, 3> inactive_axes(const Scene& scene) {
  std::array<bool, 3> still{};
  for (int k = 0; k < 3; ++k) {
    bool holds = scene.gravity(k) == 0;
    for (const Eigen::Vector3d& normal : scene.normals) holds = holds && normal(k) == 0;
    for (const Ball& ball : scene.balls) {
      holds = holds && ball.velocity(k) == 0;
    }
    still[static_cast<std::size_t>(k)] = holds;
  }
  return still;
}

}  // namespace exercise
