// Bullet: contact stiffness and damping of two bodies, which it combines as springs in series and
// dampers in parallel: each gets twice the stiffness and half of the damping.
#include <btBulletDynamicsCommon.h>

#include <memory>

#include "peers.hpp"

namespace {

struct Settings {
  bool split_impulse;  ///< its default: deep overlaps are corrected without a change of velocity
  bool ahead;          ///< its default: contacts across a gap of up to 2 cm
  int iterations;
};

class World {
 public:
  World(const peers::Scene& scene, const Settings& settings)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        plane_(btVector3(0, 0, 1), 0),
        ball_(scene.radius),
        scene_(scene),
        ahead_(settings.ahead) {
    world_.setGravity({0, 0, -scene.gravity});
    world_.getSolverInfo().m_splitImpulse = settings.split_impulse ? 1 : 0;
    world_.getSolverInfo().m_numIterations = settings.iterations;
    add_body(&plane_, 0, 0);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  btRigidBody* add(double height) { return add_body(&ball_, scene_.mass, height + scene_.radius); }
  void step() { world_.stepSimulation(scene_.step, 0, scene_.step); }

 private:
  btRigidBody* add_body(btCollisionShape* shape, double mass, double height) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin({0, 0, height});
    info.m_friction = 0;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody* body = bodies_.back().get();
    body->setDamping(0, 0);
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setContactStiffnessAndDamping(2 * scene_.stiffness, scene_.damping / 2);
    if (!ahead_) body->setContactProcessingThreshold(0);
    world_.addRigidBody(body);
    return body;
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btStaticPlaneShape plane_;
  btSphereShape ball_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  peers::Scene scene_;
  bool ahead_;
};

auto drop(Settings settings) {
  return [settings](const peers::Scene& scene, double height, int steps) {
    World world(scene, settings);
    const btRigidBody* ball = world.add(height);
    std::vector<double> heights{height};
    for (int i = 0; i < steps; ++i) {
      world.step();
      heights.push_back(ball->getWorldTransform().getOrigin().z() - scene.radius);
    }
    return heights;
  };
}
auto stack(Settings settings) {
  return [settings](const peers::Scene& scene, int balls, int steps) {
    World world(scene, settings);
    std::vector<const btRigidBody*> bodies;
    for (int i = 0; i < balls; ++i) bodies.push_back(world.add(2 * i * scene.radius));
    for (int i = 0; i < steps; ++i) world.step();
    std::vector<double> sunk;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      sunk.push_back((2 * static_cast<double>(i) + 1) * scene.radius -
                     bodies[i]->getWorldTransform().getOrigin().z());
    }
    return sunk;
  };
}

}  // namespace

std::vector<peers::Program> peers::bullet_programs() {
  constexpr Settings as_it_comes{true, true, 10};
  constexpr Settings no_split{false, true, 10};
  constexpr Settings no_gaps{false, false, 10};
  constexpr Settings patient{false, false, 1000};
  return {{"Bullet, as it comes", drop(as_it_comes), stack(as_it_comes)},
          {"Bullet, without split impulse", drop(no_split), stack(no_split)},
          {"  and without contacts across gaps", drop(no_gaps), stack(no_gaps)},
          {"  and with 1000 iterations", {}, stack(patient)}};
}
