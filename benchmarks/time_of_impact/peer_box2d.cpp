// Box2D 2.4: b2TimeOfImpact of two rectangles, in floats. It aims at a distance of a slop of 5 mm
// less than the polygons' radii.
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include "peers.hpp"

namespace {

using peers::Box;

struct Moving {
  b2PolygonShape shape;
  b2Sweep sweep;
};

Moving moving(const Box& box) {
  const auto f = [](double x) { return static_cast<float>(x); };
  Moving made;
  made.shape.SetAsBox(f(box.half_lengths[0]), f(box.half_lengths[1]));
  made.sweep.localCenter.SetZero();
  made.sweep.c0.Set(f(box.centre[0]), f(box.centre[1]));
  made.sweep.c.Set(f(box.centre[0] + box.displacement[0]), f(box.centre[1] + box.displacement[1]));
  made.sweep.a0 = f(box.angle);
  made.sweep.a = f(box.angle + box.turn[2]);
  made.sweep.alpha0 = 0;
  return made;
}

peers::Answer cast(const Moving& a, const Moving& b) {
  b2TOIInput input;
  input.proxyA.Set(&a.shape, 0);
  input.proxyB.Set(&b.shape, 0);
  input.sweepA = a.sweep;
  input.sweepB = b.sweep;
  input.tMax = 1;
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input);
  const bool overlapped = output.state == b2TOIOutput::e_overlapped;
  return {overlapped || output.state == b2TOIOutput::e_touching, output.t,
          output.state == b2TOIOutput::e_failed || output.state == b2TOIOutput::e_unknown};
}

}  // namespace

std::vector<peers::Caster> peers::box2d_casters() {
  return {{"Box2D 2.4, b2TimeOfImpact in float", true, true, Motion::constant_rate,
           asking(moving, cast)}};
}
