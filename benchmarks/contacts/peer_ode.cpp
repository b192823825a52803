// ODE: boxes on a plane, by its exact solver (dWorldStep) and by its iterations (dWorldQuickStep).
// Friction is a pyramid whose axes ODE chooses.
#include <ode/ode.h>

#include <cstdarg>

#include "peers.hpp"

namespace {

void ignore_message(int, const char*, va_list) {}

/// ODE is one for the whole program.
class Library {
 public:
  Library() {
    dInitODE2(0);
    dSetMessageHandler(ignore_message);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { dCloseODE(); }
};

peers::Numbers numbers(const dReal* x) { return {x[0], x[1], x[2]}; }

class OdeWorld final : public peers::World {
 public:
  OdeWorld(const peers::Scene& scene, bool quick, int iterations)
      : world_(dWorldCreate()),
        space_(dSimpleSpaceCreate(nullptr)),
        contacts_(dJointGroupCreate(0)),
        scene_(scene),
        quick_(quick) {
    dWorldSetGravity(world_, 0, 0, -scene.gravity);
    dWorldSetAutoDisableFlag(world_, 0);
    if (iterations > 0) dWorldSetQuickStepNumIterations(world_, iterations);
    dCreatePlane(space_, 0, 0, 1, 0);
    for (const peers::Box& box : scene.boxes) {
      dMass mass;
      dMassSetBoxTotal(&mass, box.mass, box.size[0], box.size[1], box.size[2]);
      dBodyID body = dBodyCreate(world_);
      dBodySetMass(body, &mass);
      dGeomSetBody(dCreateBox(space_, box.size[0], box.size[1], box.size[2]), body);
      dBodySetPosition(body, box.centre[0], box.centre[1], box.centre[2]);
      dBodySetLinearVel(body, box.velocity[0], box.velocity[1], box.velocity[2]);
      bodies_.push_back(body);
    }
  }
  ~OdeWorld() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  void step() override {
    dSpaceCollide(space_, this, &OdeWorld::on_near);
    if (quick_) {
      dWorldQuickStep(world_, scene_.step);
    } else {
      dWorldStep(world_, scene_.step);
    }
    dJointGroupEmpty(contacts_);
  }
  std::vector<peers::Motion> read() const override {
    std::vector<peers::Motion> all;
    for (dBodyID body : bodies_) {
      all.push_back({numbers(dBodyGetPosition(body)), numbers(dBodyGetLinearVel(body)),
                     numbers(dBodyGetAngularVel(body))});
    }
    return all;
  }

 private:
  static void on_near(void* self, dGeomID first, dGeomID second) {
    auto& world = *static_cast<OdeWorld*>(self);
    dContact contacts[8]{};
    const int count = dCollide(first, second, 8, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      contacts[i].surface.mode = dContactApprox1 | dContactBounce;
      contacts[i].surface.mu = world.scene_.friction;
      contacts[i].surface.bounce = world.scene_.restitution;
      contacts[i].surface.bounce_vel = 0;
      dJointAttach(dJointCreateContact(world.world_, world.contacts_, &contacts[i]),
                   dGeomGetBody(first), dGeomGetBody(second));
    }
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<dBodyID> bodies_;
  peers::Scene scene_;
  bool quick_;
};

peers::Make make(bool quick) {
  return [quick](const peers::Scene& scene, int iterations) {
    static const Library library;
    return std::make_unique<OdeWorld>(scene, quick, iterations);
  };
}

}  // namespace

std::vector<peers::Program> peers::ode_programs() {
  return {{"ODE 0.16, dWorldStep", make(false), ""},
          {"ODE 0.16, dWorldQuickStep", make(true), "iterations"}};
}
