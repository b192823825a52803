// Bullet: boxes on a plane, with its sequential impulses. The ground is a thick box: with a box it
// finds all contact points in one step, with its half-space one in each.
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "peers.hpp"

namespace {

btVector3 vector(const peers::Numbers& x) { return {x[0], x[1], x[2]}; }
peers::Numbers numbers(const btVector3& x) { return {x.x(), x.y(), x.z()}; }

class BulletWorld final : public peers::World {
 public:
  BulletWorld(const peers::Scene& scene, int iterations)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        scene_(scene) {
    world_.setGravity({0, 0, -scene.gravity});
    if (iterations > 0) world_.getSolverInfo().m_numIterations = iterations;
    world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
    shapes_.push_back(std::make_unique<btBoxShape>(btVector3(500, 500, 5)));
    add(0, {0, 0, -5}, {0, 0, 0});
    for (const peers::Box& box : scene.boxes) {
      shapes_.push_back(std::make_unique<btBoxShape>(vector(box.size) / 2));
      add(box.mass, box.centre, box.velocity);
    }
  }
  ~BulletWorld() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  void step() override { world_.stepSimulation(scene_.step, 0, scene_.step); }
  std::vector<peers::Motion> read() const override {
    std::vector<peers::Motion> all;
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      all.push_back({numbers(bodies_[i]->getWorldTransform().getOrigin()),
                     numbers(bodies_[i]->getLinearVelocity()),
                     numbers(bodies_[i]->getAngularVelocity())});
    }
    return all;
  }

 private:
  // Friction and restitution of a pair are the products of the bodies'.
  void add(double mass, const peers::Numbers& centre, const peers::Numbers& velocity) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shapes_.back()->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shapes_.back().get(), inertia);
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(vector(centre));
    info.m_friction = std::sqrt(scene_.friction);
    info.m_restitution = std::sqrt(scene_.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setDamping(0, 0);
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    bodies_.back()->setLinearVelocity(vector(velocity));
    world_.addRigidBody(bodies_.back().get());
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  peers::Scene scene_;
};

}  // namespace

std::vector<peers::Program> peers::bullet_programs() {
  const Make make = [](const Scene& scene, int iterations) {
    return std::make_unique<BulletWorld>(scene, iterations);
  };
  return {{"Bullet 3.24", make, "iterations"}};
}
