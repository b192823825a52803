// Uses the planner without linking one of our libraries: does gravity matter to this ball?
#include <contact/plan/plan.hpp>
#include <iostream>

int main() {
  contact::Scene scene;
  scene.name = "a ball";
  scene.duration = 1;
  scene.tolerance.position = 0.01;
  scene.materials.resize(1);
  contact::SceneBody ball;
  ball.name = "ball";
  ball.shape = contact::BallShape{0.5};
  ball.mass = 1;
  ball.inertia = contact::Matrix3<double>::Identity() * 0.1;
  scene.bodies.push_back(ball);
  for (const double g : {0.0, 9.8}) {
    scene.gravity = {0, 0, -g};
    const contact::Plan plan = contact::plan_scene(scene);
    std::cout << contact::decision_on(plan, contact::Effect::gravity).on << '\n';
  }
}
