// Box2D 3: b2TimeOfImpact of two rectangles without a radius, in floats. It turns them by a linear
// interpolation of cosine and sine.
#include <box2d/collision.h>

#include <cmath>

#include "peers.hpp"

namespace {

using peers::Box;

struct Moving {
  b2ShapeProxy proxy;
  b2Sweep sweep;
};

b2Rot rotation(double angle) {
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}
Moving moving(const Box& box) {
  const auto f = [](double x) { return static_cast<float>(x); };
  const float x = f(box.half_lengths[0]), y = f(box.half_lengths[1]);
  const b2Vec2 corners[4] = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  Moving made;
  made.proxy = b2MakeProxy(corners, 4, 0);
  made.sweep = {{0, 0},
                {f(box.centre[0]), f(box.centre[1])},
                {f(box.centre[0] + box.displacement[0]), f(box.centre[1] + box.displacement[1])},
                rotation(box.angle),
                rotation(box.angle + box.turn[2])};
  return made;
}

peers::Answer cast(const Moving& a, const Moving& b) {
  const b2TOIInput input{a.proxy, b.proxy, a.sweep, b.sweep, 1.0F};
  const b2TOIOutput output = b2TimeOfImpact(&input);
  return {output.state == b2_toiStateHit || output.state == b2_toiStateOverlapped, output.fraction,
          output.state == b2_toiStateFailed || output.state == b2_toiStateUnknown};
}

}  // namespace

std::vector<peers::Caster> peers::box2d_v3_casters() {
  return {{"Box2D 3, b2TimeOfImpact in float", true, true, Motion::between_directions,
           asking(moving, cast)}};
}
