// Box3D: b3TimeOfImpact of the corners of two boxes, in floats. It turns them by a linear
// interpolation of quaternions.
#include <box3d/box3d.h>

#include <Eigen/Geometry>

#include "peers.hpp"

namespace {

using peers::Box;

struct Moving {
  std::array<b3Vec3, 8> corners;
  b3Sweep sweep;
};

b3Vec3 vector(const peers::Numbers& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}
b3Quat rotation(const std::array<peers::Numbers, 3>& axes) {
  Eigen::Matrix3d turn;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const peers::Numbers& axis = axes[static_cast<std::size_t>(k)];
    turn.col(k) = Eigen::Vector3d(axis[0], axis[1], axis[2]);
  }
  const Eigen::Quaterniond q(turn);
  return {vector({q.x(), q.y(), q.z()}), static_cast<float>(q.w())};
}
Moving moving(const Box& box) {
  Moving made;
  for (std::size_t i = 0; i < 8; ++i) {
    peers::Numbers p = box.half_lengths;
    for (std::size_t k = 0; k < 3; ++k) {
      if ((i >> k & 1) != 0) p[k] = -p[k];
    }
    made.corners[i] = vector(p);
  }
  peers::Numbers end = box.centre;
  for (std::size_t k = 0; k < 3; ++k) end[k] += box.displacement[k];
  made.sweep = {
      {0, 0, 0}, vector(box.centre), vector(end), rotation(box.axes), rotation(box.end_axes)};
  return made;
}

peers::Answer cast(const Moving& a, const Moving& b) {
  b3TOIInput input{};
  input.proxyA = {a.corners.data(), 8, 0};
  input.proxyB = {b.corners.data(), 8, 0};
  input.sweepA = a.sweep;
  input.sweepB = b.sweep;
  input.maxFraction = 1;
  const b3TOIOutput output = b3TimeOfImpact(&input);
  return {output.state == b3_toiStateHit || output.state == b3_toiStateOverlapped, output.fraction,
          output.state == b3_toiStateFailed || output.state == b3_toiStateUnknown};
}

}  // namespace

std::vector<peers::Caster> peers::box3d_casters() {
  return {{"Box3D, b3TimeOfImpact in float", true, false, Motion::between_quaternions,
           asking(moving, cast)}};
}
