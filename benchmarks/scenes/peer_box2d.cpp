// Box2D: the plane alone, in floats. Its y is our z. Walls are thick boxes, since it has no
// half-planes.
#include <box2d/box2d.h>

#include <cmath>

#include "programs.hpp"

namespace {

using scene_programs::Motion;

class Box2dRun final : public scene_programs::Run {
 public:
  explicit Box2dRun(double gravity) : world_(b2Vec2(0.0F, static_cast<float>(-gravity))) {
    world_.SetAllowSleeping(false);
  }

  void add_still(const b2Shape& shape, float friction) {
    const b2BodyDef definition;
    add_shape(*world_.CreateBody(&definition), shape, 0, friction);
  }
  void add(const b2Shape& shape, const Motion& motion, float restitution, float friction,
           bool bullet) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.bullet = bullet;
    definition.position.Set(static_cast<float>(motion.place[0]),
                            static_cast<float>(motion.place[2]));
    definition.linearVelocity.Set(static_cast<float>(motion.velocity[0]),
                                  static_cast<float>(motion.velocity[2]));
    bodies_.push_back(world_.CreateBody(&definition));
    add_shape(*bodies_.back(), shape, restitution, friction);
  }

  // Its manual's numbers of iterations.
  void step(double seconds) override { world_.Step(static_cast<float>(seconds), 8, 3); }
  std::vector<Motion> read() const override {
    std::vector<Motion> all;
    for (const b2Body* body : bodies_) {
      const b2Vec2 x = body->GetPosition();
      const b2Vec2 v = body->GetLinearVelocity();
      all.push_back({{x.x, 0, x.y}, {v.x, 0, v.y}});
    }
    return all;
  }

 private:
  static void add_shape(b2Body& body, const b2Shape& shape, float restitution, float friction) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.restitution = restitution;
    fixture.restitutionThreshold = 0;
    fixture.friction = friction;
    body.CreateFixture(&fixture);
  }

  b2World world_;
  std::vector<b2Body*> bodies_;
};

}  // namespace

std::unique_ptr<scene_programs::Run> scene_programs::box2d(const Balls& scene) {
  auto run = std::make_unique<Box2dRun>(scene.gravity);
  for (const Wall& wall : scene.walls) {
    constexpr double thick = 5;
    const double depth = wall.offset - thick;
    b2PolygonShape box;
    box.SetAsBox(static_cast<float>(thick), 1000.0F,
                 b2Vec2(static_cast<float>(depth * wall.normal[0]),
                        static_cast<float>(depth * wall.normal[2])),
                 static_cast<float>(std::atan2(wall.normal[2], wall.normal[0])));
    run->add_still(box, 0);
  }
  if (scene.plate > 0) {
    b2PolygonShape box;
    box.SetAsBox(static_cast<float>(scene.plate / 2), 10);
    run->add_still(box, 0);
  }
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(scene.radius);
  for (const Motion& motion : scene.balls) run->add(circle, motion, 1, 0, scene.bullets);
  return run;
}

std::unique_ptr<scene_programs::Run> scene_programs::box2d(const Stack& scene) {
  auto run = std::make_unique<Box2dRun>(scene.gravity);
  const auto friction = static_cast<float>(scene.friction);
  b2PolygonShape floor;
  floor.SetAsBox(100, 1, b2Vec2(0, -1), 0);
  run->add_still(floor, friction);
  b2PolygonShape box;
  box.SetAsBox(0.5F, 0.5F);
  for (int i = 0; i < scene.boxes; ++i) run->add(box, {{0, 0, i + 0.5}, {}}, 0, friction, false);
  return run;
}
