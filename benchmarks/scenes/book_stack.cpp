// The book's boxes, step by step as their plan says, and with what the plan leaves out.
#include <contact/plan/plan.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/stepped/stepped_run.hpp>
#include <string>

#include "programs.hpp"

namespace {

using scene_programs::Motion;
using scene_programs::Stack;

contact::Scene scene_of(const Stack& stack) {
  contact::Scene scene;
  scene.name = "stack";
  scene.gravity = {0, 0, -stack.gravity};
  scene.materials = {{"brick", 0, stack.friction, {}, 0}};
  scene.duration = 10;
  scene.tolerance.position = 1e-6;
  contact::SceneBody floor;
  floor.name = "floor";
  floor.shape = contact::HalfSpaceShape{};
  floor.moves = false;
  scene.bodies.push_back(floor);
  for (int i = 0; i < stack.boxes; ++i) {
    contact::SceneBody box;
    box.name = "box_" + std::to_string(i);
    box.shape = contact::BoxShape{{0.5, 0.5, 0.5}};
    box.mass = 1;
    box.inertia = contact::solid_inertia(box.shape, 1);
    box.position = {0, 0, 0.5 + i};
    scene.bodies.push_back(box);
  }
  return scene;
}

class BookStack final : public scene_programs::Run {
 public:
  BookStack(const Stack& stack, const contact::Overrides& overrides)
      : scene_(scene_of(stack)),
        run_(contact::make_stepped_run(scene_,
                                       contact::plan_scene(scene_, {1.0 / 60, overrides}))) {}

  void step(double seconds) override {
    ++steps_;
    run_->advance(static_cast<double>(steps_) * seconds);
  }
  std::vector<Motion> read() const override {
    std::vector<Motion> all;
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) {
      const auto x = run_->position(i);
      const auto v = run_->velocity(i);
      all.push_back({{x(0), x(1), x(2)}, {v(0), v(1), v(2)}});
    }
    return all;
  }

 private:
  contact::Scene scene_;
  std::unique_ptr<contact::SceneRun> run_;
  long long steps_ = 0;
};

}  // namespace

std::unique_ptr<scene_programs::Run> scene_programs::book(const Stack& scene) {
  return std::make_unique<BookStack>(scene, contact::Overrides());
}

std::unique_ptr<scene_programs::Run> scene_programs::book_with_everything(const Stack& scene) {
  using contact::Effect;
  const contact::Overrides overrides{
      {Effect::rotation, Effect::gyroscopic_term, Effect::friction, Effect::continuous_detection},
      {Effect::sleeping}};
  return std::make_unique<BookStack>(scene, overrides);
}
