#include "friction_switch.hpp"

namespace exercise {

namespace {

using Vector = Eigen::Vector3d;

/// The coefficient of block and surface.
double coefficient(const Block& block) { return std::min(block.friction, block.surface_friction); }

/// Whether it is proven that friction never changes this block's motion.
bool never_slides(const Block& block, const Vector& gravity) {
  //? Without a coefficient no friction acts, however the block slides.
  //? gap: coefficient(block) == 0
  if (coefficient(block) == 0) return true;
  //? If velocity and gravity are parallel to the normal, exactly, no tangential velocity can arise.
  //? gap: block.normal.cross(gravity).isZero(0)
  return block.normal.cross(block.velocity).isZero(0) && block.normal.cross(gravity).isZero(0);
}

}  // namespace

Stepped step_blocks(const std::vector<Block>& blocks, const Vector& gravity, double step) {
  //? Friction is off until a block calls for it.
  Stepped result{false, {}};
  //? One block for which there is no proof is enough to switch friction on.
  //? gap: !never_slides(block, gravity)
  for (const Block& block : blocks) {
    if (!never_slides(block, gravity)) result.friction = true;
  }
  //? Then every block makes its step.
  for (const Block& block : blocks) {
    //? Gravity acts first.
    //? gap: gravity * step
    Vector v = block.velocity + gravity * step;
    //? The part of the velocity into the surface is what the surface must stop.
    //? gap: -block.normal.dot(v)
    const double pressed = -block.normal.dot(v);
    //? Only a block that presses on the surface is stopped; then only tangential velocity is left.
    //? gap: pressed * block.normal
    if (pressed > 0) {
      v += pressed * block.normal;
      //? Friction takes at most μ times the normal change, and never more than the slip.
      //? gap: std::min(slip, coefficient(block) * pressed)
      const double slip = v.norm();
      if (result.friction && slip > 0) v -= std::min(slip, coefficient(block) * pressed) / slip * v;
    }
    //? The new velocity of this block is part of the result.
    result.velocities.push_back(v);
  }
  //? All blocks have made their step.
  return result;
}

}  // namespace exercise
