// Box2D 3: the plane y = 0 of the scene alone, in floats; its y is our z. It has no half-planes:
// the ground is a thick box.
#include <box2d/box2d.h>

#include <algorithm>

#include "peers.hpp"

namespace {

float f(double x) { return static_cast<float>(x); }

class Box2dWorld final : public peers::World {
 public:
  Box2dWorld(const peers::Scene& scene, int substeps)
      : substeps_(substeps > 0 ? substeps : 4), step_(f(scene.step)) {
    b2WorldDef world = b2DefaultWorldDef();
    world.gravity = {0, f(-scene.gravity)};
    world.enableSleep = false;
    world.restitutionThreshold = 0;
    // Friction of a pair is the geometric mean, restitution the larger.
    world_ = b2CreateWorld(&world);
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.material.friction = f(scene.friction);
    shape.material.restitution = f(scene.restitution);
    b2BodyDef ground = b2DefaultBodyDef();
    ground.position = {0, -5};
    const b2Polygon floor = b2MakeBox(500, 5);
    b2CreatePolygonShape(b2CreateBody(world_, &ground), &shape, &floor);
    for (const peers::Box& box : scene.boxes) {
      b2BodyDef body = b2DefaultBodyDef();
      body.type = b2_dynamicBody;
      body.position = {f(box.centre[0]), f(box.centre[2])};
      body.linearVelocity = {f(box.velocity[0]), f(box.velocity[2])};
      bodies_.push_back(b2CreateBody(world_, &body));
      shape.density = f(box.mass / (box.size[0] * box.size[2]));
      const b2Polygon polygon = b2MakeBox(f(box.size[0] / 2), f(box.size[2] / 2));
      b2CreatePolygonShape(bodies_.back(), &shape, &polygon);
    }
  }
  ~Box2dWorld() override { b2DestroyWorld(world_); }
  void step() override { b2World_Step(world_, step_, substeps_); }
  std::vector<peers::Motion> read() const override {
    std::vector<peers::Motion> all;
    for (const b2BodyId body : bodies_) {
      const auto x = b2Body_GetPosition(body);
      const b2Vec2 v = b2Body_GetLinearVelocity(body);
      all.push_back({{x.x, 0, x.y}, {v.x, 0, v.y}, {0, -b2Body_GetAngularVelocity(body), 0}});
    }
    return all;
  }

 private:
  b2WorldId world_{};
  std::vector<b2BodyId> bodies_;
  int substeps_;
  float step_;
};

}  // namespace

std::vector<peers::Program> peers::box2d_v3_programs() {
  const Make make = [](const Scene& scene, int substeps) {
    return std::make_unique<Box2dWorld>(scene, substeps);
  };
  return {{"Box2D 3 (float)", make, "substeps", true}};
}
