// ODE: a contact joint with ERP h k / (h k + c) and CFM 1 / (h k + c), which its manual gives for a
// spring and a damper, by its two steppers. All bodies move on one vertical line.
#include <ode/ode.h>

#include <cstdarg>
#include <cstddef>
#include <string_view>

#include "peers.hpp"

namespace {

peers::Messages messages;
void count_message(int, const char* text, va_list) {
  ++(std::string_view(text).starts_with("LCP internal error") ? messages.internal_errors
                                                              : messages.others);
}

/// ODE is one for the whole program.
class Library {
 public:
  Library() {
    dInitODE2(0);
    dSetMessageHandler(count_message);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { dCloseODE(); }
};

class World {
 public:
  World(const peers::Scene& scene, bool quick)
      : world_(dWorldCreate()),
        space_(dSimpleSpaceCreate(nullptr)),
        contacts_(dJointGroupCreate(0)),
        scene_(scene),
        quick_(quick) {
    dWorldSetGravity(world_, 0, 0, -scene.gravity);
    dWorldSetAutoDisableFlag(world_, 0);
    dCreatePlane(space_, 0, 0, 1, 0);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  dBodyID add(double height) {
    dMass mass;
    dMassSetSphereTotal(&mass, scene_.mass, scene_.radius);
    dBodyID body = dBodyCreate(world_);
    dBodySetMass(body, &mass);
    dGeomSetBody(dCreateSphere(space_, scene_.radius), body);
    dBodySetPosition(body, 0, 0, height + scene_.radius);
    return body;
  }
  void step() {
    dSpaceCollide(space_, this, &World::on_near);
    if (quick_) {
      dWorldQuickStep(world_, scene_.step);
    } else {
      dWorldStep(world_, scene_.step);
    }
    dJointGroupEmpty(contacts_);
  }

 private:
  static void on_near(void* self, dGeomID first, dGeomID second) {
    auto& world = *static_cast<World*>(self);
    dContact contact{};
    if (dCollide(first, second, 1, &contact.geom, sizeof(dContact)) == 0) return;
    const double spring = world.scene_.step * world.scene_.stiffness;
    const double sum = spring + world.scene_.damping;
    contact.surface.mode = dContactSoftERP | dContactSoftCFM;
    contact.surface.soft_erp = spring / sum;
    contact.surface.soft_cfm = 1 / sum;
    contact.surface.mu = 0;
    dJointAttach(dJointCreateContact(world.world_, world.contacts_, &contact), dGeomGetBody(first),
                 dGeomGetBody(second));
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  peers::Scene scene_;
  bool quick_;
};

auto drop(bool quick) {
  return [quick](const peers::Scene& scene, double height, int steps) {
    static const Library library;
    World world(scene, quick);
    dBodyID ball = world.add(height);
    std::vector<double> heights{height};
    for (int i = 0; i < steps; ++i) {
      world.step();
      heights.push_back(dBodyGetPosition(ball)[2] - scene.radius);
    }
    return heights;
  };
}
auto stack(bool quick) {
  return [quick](const peers::Scene& scene, int balls, int steps) {
    static const Library library;
    World world(scene, quick);
    std::vector<dBodyID> bodies;
    for (int i = 0; i < balls; ++i) bodies.push_back(world.add(2 * i * scene.radius));
    for (int i = 0; i < steps; ++i) world.step();
    std::vector<double> sunk;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      sunk.push_back((2 * static_cast<double>(i) + 1) * scene.radius -
                     dBodyGetPosition(bodies[i])[2]);
    }
    return sunk;
  };
}

}  // namespace

std::vector<peers::Program> peers::ode_programs() {
  return {{"ODE, dWorldStep", drop(false), stack(false)},
          {"ODE, dWorldQuickStep", drop(true), stack(true)}};
}

peers::Messages peers::ode_messages() { return messages; }
