// The lesson's table of effects: each scene that it names needs the effect of its row.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene_file.hpp>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plan_scenes.hpp"
#include "soundness.hpp"

// Named, because files of tests are compiled together.
namespace plan_needed {
namespace {

using contact::Effect;
using contact::Scene;

struct Row {
  std::string effect;
  std::string needed_in;  ///< a scene's name in backticks, or words
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The rows that begin with an effect.
std::vector<Row> table() {
  std::ifstream lesson(CONTACT_SOURCE_DIR "/chapters/20_scenes/lesson.md");
  std::vector<Row> rows;
  bool inside = false;
  for (std::string line; std::getline(lesson, line);) {
    if (line.find("| Effect | Off when |") == 0) {
      inside = true;
      std::getline(lesson, line);
      continue;
    }
    if (!inside) continue;
    if (line.empty() || line[0] != '|') break;
    const std::string name = trimmed(line.substr(1, line.find('|', 1) - 1));
    const auto last = line.rfind('|', line.size() - 2);
    if (!name.empty())
      rows.push_back({name, trimmed(line.substr(last + 1, line.size() - last - 2))});
  }
  return rows;
}

/// The effects that a run may be without, by the names in a plan.
std::map<std::string, Effect> effects_by_name() {
  std::map<std::string, Effect> found;
  for (const Effect effect : contact::all_effects) {
    if (effect == Effect::event_driven) break;  // the first that is none of them
    found["`" + std::string(contact::effect_name(effect)) + "`"] = effect;
  }
  return found;
}

const std::map<std::string, Effect> effects = effects_by_name();

}  // namespace

TEST_CASE("the lesson's table has each effect that can be left out") {
  std::set<std::string> names;
  for (const Row& row : table()) names.insert(row.effect);
  for (const auto& [name, effect] : effects) {
    CAPTURE(name);
    CHECK(names.count(name) == 1);
  }
  CHECK(names.size() == effects.size());
}

namespace {

using contact::SceneRun;

Scene named(const std::string& needed_in) {
  REQUIRE(needed_in.size() > 2);
  REQUIRE(needed_in.front() == '`');
  const std::string name = needed_in.substr(1, needed_in.find('`', 1) - 1);
  Scene scene = contact::scenes::read_scene(CONTACT_SOURCE_DIR "/chapters/20_scenes/scenes/" +
                                            name + ".json");
  // Of twenty dominoes three are enough, and take little time.
  if (name == "dominoes") {
    const auto first = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [](const auto& body) { return body.name == "domino_0"; });
    REQUIRE(scene.bodies.end() - first >= 20);
    scene.bodies.erase(first + 3, first + 20);
  }
  return scene;
}

/// The largest distance between the positions of a point of a body in two runs, at sixteen times.
double farthest(const Scene& scene, SceneRun& one, SceneRun& other, double end) {
  double most = 0;
  for (int k = 1; k <= 16; ++k) {
    one.advance(end * k / 16);
    other.advance(end * k / 16);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (!scene.bodies[i].moves) continue;
      const contact::Vector3<double> by = one.position(i) - other.position(i);
      most = std::max(most, by.norm());
      if (contact::is_ball(scene.bodies[i])) continue;
      const auto turned = contact::matrix_of(one.orientation(i));
      const auto right = contact::matrix_of(other.orientation(i));
      const double radius = contact::rotation_radius(scene.bodies[i].shape);
      for (int axis = 0; axis < 3; ++axis) {
        const contact::Vector3<double> off = by + radius * (turned.col(axis) - right.col(axis));
        most = std::max(most, off.norm());
      }
    }
  }
  return most;
}

/// How far bodies move along each axis, in ascending order.
std::vector<double> extents(const Scene& scene, SceneRun& run, double end) {
  std::vector<double> most(3, 0.0);
  for (int k = 1; k <= 16; ++k) {
    run.advance(end * k / 16);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis)
        most[static_cast<std::size_t>(axis)] =
            std::max(most[static_cast<std::size_t>(axis)],
                     std::abs(run.position(i)(axis) - scene.bodies[i].position(axis)));
    }
  }
  std::sort(most.begin(), most.end());
  return most;
}

}  // namespace

TEST_CASE("without an effect, the scene that the lesson's table names is wrong") {
  for (const Row& row : table()) {
    const Effect effect = effects.at(row.effect);
    if (row.needed_in.front() != '`') continue;
    if (effect == Effect::third_dimension || effect == Effect::second_dimension) continue;
    CAPTURE(row.effect, row.needed_in);
    const Scene scene = named(row.needed_in);
    const contact::Plan plan = contact::plan_scene(scene);
    CHECK(contact::decision_on(plan, effect).on);
    contact::PlanOptions options;
    options.overrides.without = {effect};
    const auto with = plan_scenes::run_of(scene);
    const auto without = plan_scenes::run_of(scene, options);
    const double end = soundness::comparable_time(scene, plan);
    CHECK(farthest(scene, *with, *without, end) > plan.tolerance);
  }
}

TEST_CASE("in the scene that the lesson's table names for a dimension, bodies move along it") {
  for (const Row& row : table()) {
    const Effect effect = effects.at(row.effect);
    if (effect != Effect::third_dimension && effect != Effect::second_dimension) continue;
    CAPTURE(row.effect, row.needed_in);
    const Scene scene = named(row.needed_in);
    const contact::Plan plan = contact::plan_scene(scene);
    CHECK(contact::decision_on(plan, effect).on);
    const auto run = plan_scenes::run_of(scene);
    const auto moved = extents(scene, *run, soundness::comparable_time(scene, plan));
    CHECK(moved[effect == Effect::third_dimension ? 0 : 1] > std::max(plan.tolerance, 1e-3));
  }
}

}  // namespace plan_needed
