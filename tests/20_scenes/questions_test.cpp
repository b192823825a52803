#include "support/questions.hpp"

#include <cmath>
#include <set>
#include <vector>

#include <contact/plan/plan.hpp>

#define CONTACT_FIGURE_NO_MAIN
#include <contact/figure.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/scene/scene_file.hpp>
namespace passing {
#include "figures/passing.cpp"
}

namespace questions_test {

using contact::Effect;
using contact::Scene;
using Vector = contact::Vector3<double>;

namespace {

contact::SceneBody ball(const char* name, const Vector& position, const Vector& velocity,
                        double radius) {
  contact::SceneBody body;
  body.name = name;
  body.shape = contact::BallShape{radius};
  body.mass = 1;
  body.inertia = Vector::Constant(0.4 * radius * radius).asDiagonal();
  body.position = position;
  body.velocity = velocity;
  return body;
}

Scene scene_of(std::vector<contact::SceneBody> bodies, double duration, double friction = 0) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].restitution = 1;
  scene.materials[0].friction = friction;
  scene.bodies = std::move(bodies);
  scene.duration = duration;
  return scene;
}

Scene two_balls() {
  return scene_of({ball("a", {-1, 0, 0}, {3, 0, 0}, 0.1), ball("b", {1, 0, 0}, {-4, 0, 0}, 0.1)},
                  10);
}

Scene book_scene(const std::string& name) {
  return contact::scenes::read_scene(CONTACT_SOURCE_DIR "/chapters/20_scenes/scenes/" + name +
                                     ".json");
}

bool is_on(const Scene& scene, Effect effect) {
  return contact::decision_on(contact::plan_scene(scene), effect).on;
}

/// The largest number for which a condition holds that holds below it and not above.
template <class Holds>
double largest(double low, double high, const Holds& holds_at) {
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (holds_at(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

KEY("what-a-reader-refuses") {
  const char* const text = R"({"format": "contact-scene/1", "units": "SI", "name": "x",
    "about": "x.", "gravity": [0, 0, 0],
    "materials": [{"name": "m", "restitution": 1, "friction": 0}],
    "bodies": [{"name": "a", "shape": {"type": "sphere", "radius": 1}, "material": "m", "mass": 1,
      "frcition": 0.5, "position": [0, 0, 0]}],
    "duration": 1, "tolerance": {"position": 1}})";
  try {
    contact::scenes::scene_from_text(text, "x.json");
  } catch (const contact::scenes::SceneFileError& error) {
    const std::string said = error.what();
    return said.find("bodies[0].frcition") != std::string::npos &&
                   said.find("known are") != std::string::npos
               ? 2
               : 3;
  }
  return 0;
}

KEY("no-faster-than") {
  const Scene scene = two_balls();
  double energy = 0;
  for (const auto& body : scene.bodies) energy += body.mass * body.velocity.squaredNorm() / 2;
  return questions::Gaps{{"energy", energy}, {"speed", contact::scene_bounds(scene).speed}};
}

KEY("closing-at-most") { return contact::scene_bounds(two_balls()).pairs.at(0).closing; }

KEY("bullet-step") {
  const Scene scene = book_scene("bullet_and_wall");
  const contact::PlanInput q = contact::plan_input(scene);
  return 1e6 * largest(0, 1, [&q](double h) {
           return contact::holds(contact::tunnelling_conditions(q, h).front());
         });
}

KEY("gravity-off") {
  Scene scene = scene_of({ball("a", {0, 0, 0}, {1, 0, 0}, 0.1)}, 1);
  scene.gravity = {0, 0, -10};
  scene.tolerance.position = 0.001;
  return 1000 * largest(0, 1, [&scene](double duration) {
           scene.duration = duration;
           return !is_on(scene, Effect::gravity);
         });
}

KEY("rough-head-on") {
  Scene scene = two_balls();
  scene.materials[0].friction = 0.5;
  if (is_on(scene, Effect::friction)) return 0;
  scene.materials[0].restitution = 0.5;
  return is_on(scene, Effect::friction) ? 2 : 1;
}

KEY("smallest-number") {
  Scene scene = book_scene("billiards_break");
  if (is_on(scene, Effect::third_dimension)) return -1;
  scene.bodies.back().position.z() = 5e-324;
  return is_on(scene, Effect::third_dimension) ? 2 : 0;
}

KEY("not-proven") {
  // Of no decision of any scene of the book is something off without a proof that holds.
  for (const auto& file :
       contact::scenes::scenes_in(CONTACT_SOURCE_DIR "/chapters/20_scenes/scenes")) {
    const contact::Plan plan = contact::plan_scene(contact::scenes::read_scene(file));
    const contact::Decision& resting = contact::decision_on(plan, Effect::resting);
    if (!resting.on && !resting.proven) return 1;
    for (const contact::Proof& proof : resting.tried) {
      if (resting.on && contact::is_proven(proof)) return -1;
    }
  }
  return 0;
}

KEY("from-scene-to-run") {
  // What each item requires before it.
  const std::vector<std::set<int>> needs{{4}, {}, {1}, {0}, {2}};
  std::vector<int> order;
  std::set<int> done;
  while (order.size() < needs.size()) {
    std::vector<int> possible;
    for (int i = 0; i < static_cast<int>(needs.size()); ++i) {
      const auto& before = needs[static_cast<std::size_t>(i)];
      if (done.count(i) == 0 &&
          std::includes(done.begin(), done.end(), before.begin(), before.end()))
        possible.push_back(i);
    }
    if (possible.size() != 1) return std::vector<int>{};  // two right orders would be no question
    order.push_back(possible.front());
    done.insert(possible.front());
  }
  return order;
}

KEY("tight-step") {
  passing::Input in{1.6, 20, 0, 0.0145, 0.1, 0, 0};
  const double winning = passing::compute(in).tight;
  in.step = 0.025;
  return questions::Construct{winning, passing::compute(in).tight};
}

KEY("why-friction-stays") {
  const auto on = [](double aside) {
    Scene scene = two_balls();
    scene.materials[0].friction = 0.5;
    scene.bodies[0].position.y() += aside;
    return is_on(scene, Effect::friction);
  };
  return questions::Claim{on(0.01), on(0)};
}

}  // namespace questions_test
