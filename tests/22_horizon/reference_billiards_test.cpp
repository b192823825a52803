// The lesson's opening: a ball of the billiards break, displaced by an ulp.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <limits>
#include <memory>

namespace {

using contact::Scene;
using contact::SceneRun;

std::unique_ptr<SceneRun> run_of(const Scene& scene) {
  return contact::scenes::make_run(scene, contact::plan_scene(scene));
}

struct Distances {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
};

/// How far each ball is from where it is in the other run, at a time.
Distances apart(const Scene& scene, SceneRun& one, SceneRun& other, double at) {
  one.advance(at);
  other.advance(at);
  Distances found;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    const double distance = (one.position(i) - other.position(i)).norm();
    found.least = std::min(found.least, distance);
    found.most = std::max(found.most, distance);
  }
  return found;
}

}  // namespace

TEST_CASE("an ulp in the position of one ball displaces one by a metre in 5 s, all in 10 s") {
  Scene scene = contact::scenes::read_scene(CONTACT_SOURCE_DIR
                                            "/chapters/20_scenes/scenes/billiards_break.json");
  scene.duration = 10;
  Scene twin = scene;
  const auto ball = std::find_if(twin.bodies.begin(), twin.bodies.end(),
                                 [](const auto& body) { return body.name == "ball_4"; });
  REQUIRE(ball != twin.bodies.end());
  const double x = ball->position.x();
  ball->position.x() = std::nextafter(x, 9.0);
  CHECK(ball->position.x() - x < 1.2e-16);
  const auto one = run_of(scene);
  const auto other = run_of(twin);
  CHECK(apart(scene, *one, *other, 1).most < 1e-13);
  CHECK(apart(scene, *one, *other, 5).most > 1);
  CHECK(apart(scene, *one, *other, 10).least > 0.1);
}
