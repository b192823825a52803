// misconception: balanced-for-still
// caught by: each ball is its own image
// seen: https://www.shaalaa.com/question-bank-solutions/consider-following-two-statements-a-linear-momentum-system-particles-zero-b-kinetic-energy-system-particles-zero-momentum-conservation-centre-mass-motion_66734
//   a test offers that all are at rest if the momenta add up to zero
#include "stays_in_a_plane.hpp"

namespace exercise {

std::array<bool, 3> inactive_axes(const Scene& scene) {
  std::array<bool, 3> still{};
  for (int k = 0; k < 3; ++k) {
    bool holds = scene.gravity(k) == 0;
    double momentum = 0;
    double push = 0;
    for (const Eigen::Vector3d& normal : scene.normals) push += normal(k);
    for (const Ball& ball : scene.balls) {
      momentum += ball.velocity(k);
      holds = holds && ball.centre(k) == scene.balls[0].centre(k);
    }
    holds = holds && momentum == 0 && push == 0;
    still[static_cast<std::size_t>(k)] = holds;
  }
  return still;
}

}  // namespace exercise
