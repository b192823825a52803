#include "friction_switch.hpp"

namespace exercise {

namespace {

using Vector = Eigen::Vector3d;

/// The coefficient of block and surface.
double coefficient(const Block& block) { return std::min(block.friction, block.surface_friction); }

/// Whether it is proven that friction never changes this block's motion.
bool never_slides(const Block& block, const Vector& gravity) {
  if (coefficient(block) == 0) return true;
  return block.normal.cross(block.velocity).isZero(0) && block.normal.cross(gravity).isZero(0);
}

}  // namespace

Stepped step_blocks(const std::vector<Block>& blocks, const Vector& gravity, double step) {
  Stepped result{false, {}};
  for (const Block& block : blocks) {
    if (!never_slides(block, gravity)) result.friction = true;
  }
  for (const Block& block : blocks) {
    Vector v = block.velocity + gravity * step;
    const double pressed = -block.normal.dot(v);
    if (pressed > 0) {
      v += pressed * block.normal;
      const double slip = v.norm();
      if (result.friction && slip > 0) v -= std::min(slip, coefficient(block) * pressed) / slip * v;
    }
    result.velocities.push_back(v);
  }
  return result;
}

}  // namespace exercise
