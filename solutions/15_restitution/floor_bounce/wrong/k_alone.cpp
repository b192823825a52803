// misconception: one-of-one-plus-k
// caught by: a ball that falls vertically leaves with k times its speed
// seen: https://huggingface.co/datasets/nvidia/Nemotron-CC-Math-v1
//   the thread "Realtime Bouncing, Independent of Angles": the factor 2, for k = 1, is forgotten
#include "floor_bounce.hpp"

namespace exercise {

Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double k) {
  const double along_normal = velocity.dot(normal);
  if (!(along_normal < 0)) return velocity;
  return velocity - k * along_normal * normal;
}

}  // namespace exercise
