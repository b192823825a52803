/// @file
/// The ray tests of other programs, each behind one function. Their headers stay in their own
/// files.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace peers {

/// A ray from x, y, z in a direction that need not be a unit vector.
struct RayOfFloats {
  std::array<float, 3> origin, direction;
};
struct BallOfFloats {
  std::array<float, 3> centre;
  float radius;
};
struct BoxOfFloats {
  std::array<float, 3> low, high;
};

/// Ray i is asked about body i. A ball and a box are solid, and touching counts. The second point
/// of each ray, origin + direction, is exact in double.
template <class Body>
struct Questions {
  std::vector<RayOfFloats> rays;
  std::vector<Body> bodies;
};

/// Tells of each ray whether it meets its body. The program's own rays and bodies were made before.
using Ask = std::function<void(std::vector<char>&)>;

Ask cgal(const Questions<BallOfFloats>& questions);
Ask cgal(const Questions<BoxOfFloats>& questions);
/// CGAL's boxes of doubles, that of its trees.
Ask cgal_bbox(const Questions<BoxOfFloats>& questions);

/// Any hit of a scene with one ball. Embree is float; its balls are surfaces, and so a ray that
/// starts inside meets its ball where it leaves.
/// @param device the device's configuration
Ask embree(const Questions<BallOfFloats>& questions, const char* device, bool robust);

/// Calls ask(ray, body) for each pair, and keeps the answers.
template <class Rays, class Bodies, class Call>
void in_turn(const Rays& rays, const Bodies& bodies, std::vector<char>& answers, const Call& ask) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    answers[i] = static_cast<char>(ask(rays[i], bodies[i]));
  }
}

}  // namespace peers
