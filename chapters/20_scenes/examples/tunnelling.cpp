// Four bodies in front of a wall one centimetre thick: the closing speed that energy allows, and
// the longest step with which nothing can pass through.
#include <contact/inertia.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_rules.hpp>
#include <cstdio>

namespace {

contact::Scene before_a_wall(const contact::SceneShape& shape, double speed,
                             double angular_velocity, double g) {
  contact::Scene scene;
  scene.materials.resize(1);
  scene.materials[0].restitution = 1;
  contact::SceneBody body;
  body.name = "body";
  body.shape = shape;
  body.mass = 1;
  if (const auto* box = std::get_if<contact::BoxShape>(&shape))
    body.inertia = contact::box_inertia<double>(body.mass, 2 * box->half_lengths);
  else
    body.inertia = contact::sphere_inertia(body.mass, std::get<contact::BallShape>(shape).radius);
  body.position = {-1, 0, 0};
  body.velocity = {speed, 0, 0};
  body.angular_velocity = {0, 0, angular_velocity};
  contact::SceneBody wall;
  wall.name = "wall";
  wall.shape = contact::BoxShape{{0.005, 1, 1}};
  wall.moves = false;
  scene.bodies = {body, wall};
  scene.gravity = {0, 0, -g};
  scene.duration = 1;
  return scene;
}

void show(const char* what, const contact::Scene& scene) {
  // [longest-step]
  const contact::PlanInput q = contact::plan_input(scene);
  const contact::PairBound& pair = q.pairs.front();
  const double longest = 2 * pair.core / pair.closing;
  const contact::Inequality frame = contact::tunnelling_conditions(q, 1.0 / 60).front();
  const contact::Inequality fine = contact::tunnelling_conditions(q, 0.999 * longest).front();
  // [/longest-step]
  std::printf("%-24s%6.1f m/s  1/60 s: %.2f m %s %.3f m  %8.6f s: %s\n", what, pair.closing,
              frame.left, contact::holds(frame) ? "<" : "≥", frame.right, longest,
              contact::holds(fine) ? "proven" : "not proven");
}

}  // namespace

int main() {
  const contact::BallShape ball{0.02};
  const contact::BoxShape rod{{0.25, 0.02, 0.02}};
  show("a ball at 6 m/s", before_a_wall(ball, 6, 0, 0));
  show("the same in free fall", before_a_wall(ball, 6, 0, 10));
  show("a rod at 6 m/s", before_a_wall(rod, 6, 0, 0));
  show("a rod that spins, too", before_a_wall(rod, 6, 40, 0));
}
