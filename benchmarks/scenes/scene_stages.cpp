// A scene of the book for some seconds: of which stages it is composed, and what it did, as JSON.
// usage: scene_stages SCENE.json SECONDS [everything | +EFFECT | -EFFECT]...
//
// Effects are forced on or off. From event to event there is nothing to switch; `everything`
// composes a run of all effects of hard balls.
//
// benchmarks/scene_stages.py runs it and counts the instructions of run_scene(), stage by stage.
#include <contact/hard_sphere_scene.hpp>
#include <contact/plan.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "scenes/run_hard_spheres.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/scene_runs.hpp"

/// What is counted; its name is how valgrind finds it.
extern "C" void run_scene(const void* work);
extern "C" [[gnu::noinline]] void run_scene(const void* work) {
  (*static_cast<const std::function<void()>*>(work))();
}

namespace {

nlohmann::json with_everything(const std::string& file, double seconds) {
  const contact::HardSphereScene found =
      contact::hard_sphere_setup(contact::scenes::read_scene(file));
  const auto run = contact::scenes::compose_run(found.setup, contact::HardSphereComposition());
  contact::Vector3<double> sum = contact::Vector3<double>::Zero();
  const std::function<void()> work = [&] {
    run->advance(seconds);
    for (std::size_t i = 0; i < run->moving(); ++i) sum += run->position(i);
  };
  run_scene(&work);
  if (!sum.allFinite()) throw std::runtime_error("the balls have come to no place");
  return {{"event_driven", true},
          {"stages", nlohmann::json::array()},
          {"bytes_per_body", run->bytes_per_state()},
          {"steps", 0},
          {"parts", 0},
          {"hits", run->counts().hits}};
}

nlohmann::json measured(const std::string& file, double seconds,
                        const contact::PlanOptions& options) {
  const contact::Scene scene = contact::scenes::read_scene(file);
  const contact::Plan plan = contact::plan_scene(scene, options);
  if (const auto refusal = contact::scenes::run_refusal(scene, plan))
    throw std::runtime_error(scene.name + " cannot be simulated: " + *refusal);
  const auto run = contact::scenes::make_run(scene, plan);
  // Places are asked for at the end: a run that computes nothing before it is asked pays here.
  contact::Vector3<double> sum = contact::Vector3<double>::Zero();
  const std::function<void()> work = [&] {
    run->advance(seconds);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      sum += run->position(i) + run->orientation(i).v;
  };
  run_scene(&work);
  if (!sum.allFinite()) throw std::runtime_error(scene.name + " has come to no place");
  std::vector<std::string> stages;
  for (const contact::SceneStage& stage : run->stages()) stages.push_back(stage.name);
  const contact::SceneRunCounts counts = run->counts();
  return {{"event_driven", run->event_driven()},
          {"stages", stages},
          {"bytes_per_body", run->bytes_per_body()},
          {"steps", counts.steps},
          {"parts", counts.parts},
          {"hits", counts.hits}};
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 2 ? std::atof(argv[2]) : 0;
  contact::PlanOptions options;
  const bool everything = argc == 4 && std::string(argv[3]) == "everything";
  bool understood = seconds > 0;
  for (int i = 3; !everything && i < argc; ++i) {
    const std::string word = argv[i];
    const auto effect = contact::effect_named(word.substr(word.empty() ? 0 : 1));
    understood = understood && effect && (word[0] == '+' || word[0] == '-');
    if (!understood) break;
    (word[0] == '+' ? options.overrides.with : options.overrides.without).push_back(*effect);
  }
  if (!understood) {
    std::fprintf(stderr,
                 "usage: scene_stages SCENE.json SECONDS [everything | +EFFECT | -EFFECT]...\n");
    return 2;
  }
  try {
    const nlohmann::json result =
        everything ? with_everything(argv[1], seconds) : measured(argv[1], seconds, options);
    std::puts(result.dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scene_stages: %s\n", error.what());
    return 1;
  }
}
