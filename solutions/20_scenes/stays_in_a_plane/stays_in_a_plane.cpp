#include "stays_in_a_plane.hpp"

namespace exercise {

// The proof. Let every ball be in the plane x_k = c with v_k = 0 up to some moment. Gravity changes
// no v_k, since g_k = 0. The force of a smooth wall acts along its normal, and that of a smooth
// ball along the line of the centres, which lies in the plane: neither has a component along k. So
// no v_k changes at that moment either, nor in the flight after it. By induction no ball ever
// leaves the plane.
std::array<bool, 3> inactive_axes(const Scene& scene) {
  //? No axis is inactive until it is proven.
  std::array<bool, 3> still{};
  //? The proof is made for each axis by itself.
  for (int k = 0; k < 3; ++k) {
    //? Gravity along the axis would change the velocity along it.
    //? gap: scene.gravity(k) == 0
    bool holds = scene.gravity(k) == 0;
    //? A wall pushes along its normal, which must have no component along the axis.
    //? gap: normal(k) == 0
    for (const Eigen::Vector3d& normal : scene.normals) holds = holds && normal(k) == 0;
    //? All balls must be in one plane orthogonal to the axis, and none may leave it.
    //? gap: ball.velocity(k) == 0
    //? gap: ball.centre(k) == scene.balls[0].centre(k)
    for (const Ball& ball : scene.balls) {
      holds = holds && ball.velocity(k) == 0 && ball.centre(k) == scene.balls[0].centre(k);
    }
    //? All conditions of the proof held, or one did not.
    still[static_cast<std::size_t>(k)] = holds;
  }
  //? This is the answer for the three axes.
  return still;
}

}  // namespace exercise
