// Jolt, in floats, in one thread. The ground is a thick box: this version has no half-spaces. Boxes
// are sharp (convex radius 0; by default 5 cm are rounded). Within an iteration it takes contacts
// in the order of a hash, so in a stack neither upwards nor downwards.
#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/PhysicsSettings.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>

#include "peers.hpp"

namespace {

float f(double x) { return static_cast<float>(x); }
JPH::Vec3 vector(const peers::Numbers& x) { return {f(x[0]), f(x[1]), f(x[2])}; }
peers::Numbers numbers(const JPH::Vec3& v) { return {v.GetX(), v.GetY(), v.GetZ()}; }

/// What all worlds share.
struct Library {
  Library() {
    JPH::RegisterDefaultAllocator();
    JPH::Factory::sInstance = new JPH::Factory;
    JPH::RegisterTypes();
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() {
    JPH::UnregisterTypes();
    delete JPH::Factory::sInstance;
    JPH::Factory::sInstance = nullptr;
  }
};

class JoltWorld final : public peers::World {
 public:
  JoltWorld(const peers::Scene& scene, int iterations) : step_(f(scene.step)) {
    world_.Init(1024, 0, 1024, 1024, layers_, of_layers_, pairs_);
    world_.SetGravity({0, 0, f(-scene.gravity)});
    JPH::PhysicsSettings settings = world_.GetPhysicsSettings();
    if (iterations > 0) settings.mNumVelocitySteps = static_cast<JPH::uint>(iterations);
    settings.mMinVelocityForRestitution = 0;
    settings.mAllowSleeping = false;
    world_.SetPhysicsSettings(settings);
    add(scene, {0, {1000, 1000, 10}, {0, 0, -5}, {}});
    for (const peers::Box& box : scene.boxes) bodies_.push_back(add(scene, box));
    world_.OptimizeBroadPhase();
  }
  void step() override { world_.Update(step_, 1, &memory_, &jobs_); }
  std::vector<peers::Motion> read() const override {
    std::vector<peers::Motion> all;
    const JPH::BodyInterface& bodies = world_.GetBodyInterfaceNoLock();
    for (const JPH::BodyID body : bodies_) {
      all.push_back({numbers(bodies.GetCenterOfMassPosition(body)),
                     numbers(bodies.GetLinearVelocity(body)),
                     numbers(bodies.GetAngularVelocity(body))});
    }
    return all;
  }

 private:
  // The friction of a pair is the root of the bodies' product, its restitution the larger one.
  JPH::BodyID add(const peers::Scene& scene, const peers::Box& box) {
    const bool moves = box.mass > 0;
    JPH::BodyCreationSettings body(new JPH::BoxShape(vector(box.size) / 2, 0), vector(box.centre),
                                   JPH::Quat::sIdentity(),
                                   moves ? JPH::EMotionType::Dynamic : JPH::EMotionType::Static, 0);
    body.mFriction = f(scene.friction);
    body.mRestitution = f(scene.restitution);
    body.mLinearVelocity = vector(box.velocity);
    body.mLinearDamping = body.mAngularDamping = 0;
    body.mOverrideMassProperties = JPH::EOverrideMassProperties::CalculateInertia;
    body.mMassPropertiesOverride.mMass = f(box.mass);
    return world_.GetBodyInterface().CreateAndAddBody(
        body, moves ? JPH::EActivation::Activate : JPH::EActivation::DontActivate);
  }

  JPH::TempAllocatorImpl memory_{16 << 20};
  JPH::JobSystemSingleThreaded jobs_{JPH::cMaxPhysicsJobs};
  JPH::BroadPhaseLayerInterfaceTable layers_{1, 1};
  JPH::ObjectVsBroadPhaseLayerFilter of_layers_;
  JPH::ObjectLayerPairFilter pairs_;
  JPH::PhysicsSystem world_;
  std::vector<JPH::BodyID> bodies_;
  float step_;
};

}  // namespace

std::vector<peers::Program> peers::jolt_programs() {
  const Make make = [](const Scene& scene, int iterations) {
    static const Library library;
    return std::make_unique<JoltWorld>(scene, iterations);
  };
  return {{"Jolt 5.0 (float)", make, "iterations"}};
}
