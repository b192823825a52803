// Box3D, in floats. It has no half-spaces: the ground is a thick box.
#include <box3d/box3d.h>

#include "peers.hpp"

namespace {

float f(double x) { return static_cast<float>(x); }
b3Vec3 vector(const peers::Numbers& x) { return {f(x[0]), f(x[1]), f(x[2])}; }
template <class Vector>
peers::Numbers numbers(const Vector& v) {
  return {v.x, v.y, v.z};
}

class Box3dWorld final : public peers::World {
 public:
  Box3dWorld(const peers::Scene& scene, int substeps)
      : substeps_(substeps > 0 ? substeps : 4), step_(f(scene.step)) {
    b3WorldDef world = b3DefaultWorldDef();
    world.gravity = {0, 0, f(-scene.gravity)};
    world.enableSleep = false;
    world.restitutionThreshold = 0;
    world_ = b3CreateWorld(&world);
    b3ShapeDef shape = b3DefaultShapeDef();
    shape.baseMaterial.friction = f(scene.friction);
    shape.baseMaterial.restitution = f(scene.restitution);
    b3BodyDef ground = b3DefaultBodyDef();
    ground.position = {0, 0, -5};
    const b3BoxHull floor = b3MakeBoxHull(500, 500, 5);
    b3CreateHullShape(b3CreateBody(world_, &ground), &shape, &floor.base);
    for (const peers::Box& box : scene.boxes) {
      b3BodyDef body = b3DefaultBodyDef();
      body.type = b3_dynamicBody;
      body.position = {f(box.centre[0]), f(box.centre[1]), f(box.centre[2])};
      body.linearVelocity = vector(box.velocity);
      bodies_.push_back(b3CreateBody(world_, &body));
      shape.density = f(box.mass / (box.size[0] * box.size[1] * box.size[2]));
      const b3BoxHull hull =
          b3MakeBoxHull(f(box.size[0] / 2), f(box.size[1] / 2), f(box.size[2] / 2));
      b3CreateHullShape(bodies_.back(), &shape, &hull.base);
    }
  }
  ~Box3dWorld() override { b3DestroyWorld(world_); }
  void step() override { b3World_Step(world_, step_, substeps_); }
  std::vector<peers::Motion> read() const override {
    std::vector<peers::Motion> all;
    for (const b3BodyId body : bodies_) {
      all.push_back({numbers(b3Body_GetPosition(body)), numbers(b3Body_GetLinearVelocity(body)),
                     numbers(b3Body_GetAngularVelocity(body))});
    }
    return all;
  }

 private:
  b3WorldId world_{};
  std::vector<b3BodyId> bodies_;
  int substeps_;
  float step_;
};

}  // namespace

std::vector<peers::Program> peers::box3d_programs() {
  const Make make = [](const Scene& scene, int substeps) {
    return std::make_unique<Box3dWorld>(scene, substeps);
  };
  return {{"Box3D (float)", make, "substeps"}};
}
