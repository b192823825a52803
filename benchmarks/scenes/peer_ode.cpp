// ODE: a hash space and the quick stepper. Its exact stepper gives up on a stack: four contacts a
// box are more than it needs, and its equations then have no one solution.
#include <ode/ode.h>

#include <cstddef>
#include <stdexcept>
#include <string>

#include "programs.hpp"

namespace {

using scene_programs::Column;
using scene_programs::Motion;

/// ODE is one for the whole program.
class Library {
 public:
  Library() { dInitODE2(0); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { dCloseODE(); }
};

class OdeRun final : public scene_programs::Run {
 public:
  OdeRun(double gravity, double restitution, double friction)
      : world_(dWorldCreate()),
        space_(dHashSpaceCreate(nullptr)),
        contacts_(dJointGroupCreate(0)),
        restitution_(restitution),
        friction_(friction) {
    dWorldSetGravity(world_, 0, 0, -gravity);
    dWorldSetAutoDisableFlag(world_, 0);
  }
  OdeRun(const OdeRun&) = delete;
  OdeRun& operator=(const OdeRun&) = delete;
  ~OdeRun() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  dSpaceID space() const { return space_; }
  void add(dGeomID shape, const dMass& mass, const Motion& motion) {
    dBodyID body = dBodyCreate(world_);
    dBodySetMass(body, &mass);
    dGeomSetBody(shape, body);
    dBodySetPosition(body, motion.place[0], motion.place[1], motion.place[2]);
    dBodySetLinearVel(body, motion.velocity[0], motion.velocity[1], motion.velocity[2]);
    bodies_.push_back(body);
  }

  void step(double seconds) override {
    dSpaceCollide(space_, this, &OdeRun::on_near);
    if (dWorldQuickStep(world_, seconds) == 0) throw std::runtime_error("ODE: out of memory");
    dJointGroupEmpty(contacts_);
  }
  std::vector<Motion> read() const override {
    std::vector<Motion> all;
    for (dBodyID body : bodies_) {
      const dReal* x = dBodyGetPosition(body);
      const dReal* v = dBodyGetLinearVel(body);
      all.push_back({{x[0], x[1], x[2]}, {v[0], v[1], v[2]}});
    }
    return all;
  }

 private:
  static void on_near(void* self, dGeomID first, dGeomID second) {
    auto& run = *static_cast<OdeRun*>(self);
    dBodyID a = dGeomGetBody(first);
    dBodyID b = dGeomGetBody(second);
    if (a == nullptr && b == nullptr) return;
    std::array<dContact, 8> contacts{};
    const int found = dCollide(first, second, static_cast<int>(contacts.size()), &contacts[0].geom,
                               sizeof(dContact));
    for (int i = 0; i < found; ++i) {
      dContact& contact = contacts[static_cast<std::size_t>(i)];
      contact.surface.mode = run.restitution_ > 0 ? dContactBounce : 0;
      contact.surface.bounce = run.restitution_;
      contact.surface.bounce_vel = 0;
      contact.surface.mu = run.friction_;
      dJointAttach(dJointCreateContact(run.world_, run.contacts_, &contact), a, b);
    }
  }

  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  double restitution_, friction_;
  std::vector<dBodyID> bodies_;
};

}  // namespace

std::unique_ptr<scene_programs::Run> scene_programs::ode(const Balls& scene) {
  static const Library library;
  auto run = std::make_unique<OdeRun>(scene.gravity, 1, 0);
  for (const Wall& wall : scene.walls)
    dCreatePlane(run->space(), wall.normal[0], wall.normal[1], wall.normal[2], wall.offset);
  if (scene.plate > 0) dCreateBox(run->space(), scene.plate, 20, 20);
  dMass mass;
  dMassSetSphereTotal(&mass, 1, scene.radius);
  for (const Motion& motion : scene.balls)
    run->add(dCreateSphere(run->space(), scene.radius), mass, motion);
  return run;
}

std::unique_ptr<scene_programs::Run> scene_programs::ode(const Stack& scene) {
  static const Library library;
  auto run = std::make_unique<OdeRun>(scene.gravity, 0, scene.friction);
  dCreatePlane(run->space(), 0, 0, 1, 0);
  dMass mass;
  dMassSetBoxTotal(&mass, 1, 1, 1, 1);
  for (int i = 0; i < scene.boxes; ++i)
    run->add(dCreateBox(run->space(), 1, 1, 1), mass, {{0, 0, i + 0.5}, {}});
  return run;
}
