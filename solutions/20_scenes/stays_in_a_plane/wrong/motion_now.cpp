// misconception: forces-left-out
// caught by: one ball and gravity
// seen: https://github.com/erincatto/box2d/issues/906 bodies fall asleep at their highest point
#include "stays_in_a_plane.hpp"

namespace exercise {

std::array<bool, 3> inactive_axes(const Scene& scene) {
  std::array<bool, 3> still{};
  for (int k = 0; k < 3; ++k) {
    bool holds = true;
    for (const Ball& ball : scene.balls) {
      holds = holds && ball.velocity(k) == 0 && ball.centre(k) == scene.balls[0].centre(k);
    }
    still[static_cast<std::size_t>(k)] = holds;
  }
  return still;
}

}  // namespace exercise
