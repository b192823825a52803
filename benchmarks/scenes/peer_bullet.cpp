// Bullet: a dynamics world of its own, with sleeping, damping and the least speed of a bounce
// switched off.
#include <btBulletDynamicsCommon.h>

#include "programs.hpp"

namespace {

using scene_programs::Column;
using scene_programs::Motion;

btVector3 vector(const Column& c) { return {c[0], c[1], c[2]}; }
Column column(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

class BulletRun final : public scene_programs::Run {
 public:
  explicit BulletRun(double gravity)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity({0, 0, -gravity});
    world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
  }
  BulletRun(const BulletRun&) = delete;
  BulletRun& operator=(const BulletRun&) = delete;
  ~BulletRun() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  btCollisionShape* keep(std::unique_ptr<btCollisionShape> shape) {
    shapes_.push_back(std::move(shape));
    return shapes_.back().get();
  }
  btRigidBody& add(btCollisionShape* shape, double mass, const Column& place, double restitution,
                   double friction) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(vector(place));
    info.m_restitution = restitution;
    info.m_friction = friction;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setDamping(0, 0);
    body.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&body);
    return body;
  }

  void step(double seconds) override { world_.stepSimulation(seconds, 0, seconds); }
  std::vector<Motion> read() const override {
    std::vector<Motion> all;
    for (const auto& body : bodies_) {
      if (body->getMass() > 0)
        all.push_back(
            {column(body->getWorldTransform().getOrigin()), column(body->getLinearVelocity())});
    }
    return all;
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<scene_programs::Run> scene_programs::bullet(const Balls& scene) {
  auto run = std::make_unique<BulletRun>(scene.gravity);
  for (const Wall& wall : scene.walls) {
    run->add(run->keep(std::make_unique<btStaticPlaneShape>(vector(wall.normal), wall.offset)), 0,
             {}, 1, 0);
  }
  if (scene.plate > 0) {
    run->add(run->keep(std::make_unique<btBoxShape>(btVector3(scene.plate / 2, 10, 10))), 0, {}, 1,
             0);
  }
  btCollisionShape* ball = run->keep(std::make_unique<btSphereShape>(scene.radius));
  for (const Motion& motion : scene.balls) {
    btRigidBody& body = run->add(ball, 1, motion.place, 1, 0);
    body.setLinearVelocity(vector(motion.velocity));
    if (scene.bullets) {
      body.setCcdMotionThreshold(scene.radius);
      body.setCcdSweptSphereRadius(scene.radius / 2);
    }
  }
  return run;
}

std::unique_ptr<scene_programs::Run> scene_programs::bullet(const Stack& scene) {
  auto run = std::make_unique<BulletRun>(scene.gravity);
  run->add(run->keep(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), 0)), 0, {}, 0,
           scene.friction);
  btCollisionShape* box = run->keep(std::make_unique<btBoxShape>(btVector3(0.5, 0.5, 0.5)));
  for (int i = 0; i < scene.boxes; ++i) run->add(box, 1, {0, 0, i + 0.5}, 0, scene.friction);
  return run;
}
