// misconception: plane-through-origin
// caught by: one ball and gravity
#include "stays_in_a_plane.hpp"

namespace exercise {

// The proof. Let every ball be in the plane x_k = c with v_k = 0 up to some moment. Gravity changes
// no v_k, since g_k = 0. The force of a smooth wall acts along its normal, and that of a smooth
// ball along the line of the centres, which lies in the plane: neither has a component along k. So
// no v_k changes at that moment either, nor in the flight after it. By induction no ball ever
// leaves the plane.
std::array<bool, 3> inactive_axes(const Scene& scene) {
  std::array<bool, 3> still{};
  for (int k = 0; k < 3; ++k) {
    bool holds = scene.gravity(k) == 0;
    for (const Eigen::Vector3d& normal : scene.normals) holds = holds && normal(k) == 0;
    for (const Ball& ball : scene.balls) {
      holds = holds && ball.velocity(k) == 0 && ball.centre(k) == 0;
    }
    still[static_cast<std::size_t>(k)] = holds;
  }
  return still;
}

}  // namespace exercise
