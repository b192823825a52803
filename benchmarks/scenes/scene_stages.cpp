// A scene of the book for some seconds: of which stages it is composed, and what it did, as JSON.
// usage: scene_stages SCENE.json SECONDS [everything | step=SECONDS | +EFFECT | -EFFECT]...
//
// The scene lasts so many seconds, for its plan too. Effects are forced on or off. From event to
// event it is the composition of hard balls that has them or not, though its plan would leave it as
// it is; `everything` is the composition of all.
//
// benchmarks/scene_stages.py runs it and counts the instructions of run_scene(), stage by stage.
#include <algorithm>
#include <contact/events/hard_sphere_make.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

/// What is counted; its name is how valgrind finds it.
extern "C" void run_scene(const void* work);
extern "C" [[gnu::noinline]] void run_scene(const void* work) {
  (*static_cast<const std::function<void()>*>(work))();
}

namespace {

/// What the plan expects each effect to cost, and whether it is on.
nlohmann::json estimates(const contact::Plan& plan) {
  nlohmann::json effects = nlohmann::json::object();
  for (const contact::Decision& decision : plan.decisions)
    effects[std::string(contact::effect_name(decision.effect))] = {
        {"on", decision.on}, {"instructions", decision.saving.instructions}};
  return effects;
}

/// The smallest composition for hard balls, with the effects that are forced on or off.
contact::HardSphereComposition composition_of(const contact::HardSphereSetup& setup,
                                              const contact::Overrides& overrides) {
  contact::HardSphereComposition made = contact::compose_hard_spheres(setup);
  auto& [dimension, gravity, sizes, restitution, grid] = made.effects;
  std::size_t count = static_cast<std::size_t>(dimension);
  for (const int axis : {0, 1, 2}) {
    const auto end = made.axes.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::find(made.axes.begin(), end, axis) == end) made.axes[count++] = axis;
  }
  for (const contact::Effect effect : overrides.with) {
    if (effect == contact::Effect::gravity) gravity = true;
    if (effect == contact::Effect::restitution) restitution = true;
    if (effect == contact::Effect::second_dimension) dimension = std::max(dimension, 2);
    if (effect == contact::Effect::third_dimension) dimension = 3;
    if (effect == contact::Effect::broad_phase) grid = true;
  }
  for (const contact::Effect effect : overrides.without)
    if (effect == contact::Effect::broad_phase) grid = false;
  return made;
}

nlohmann::json of_hard_balls(
    const contact::Scene& scene, double seconds,
    const std::function<contact::HardSphereComposition(const contact::HardSphereSetup&)>& compose) {
  const contact::HardSphereScene found = contact::hard_sphere_setup(scene);
  const auto run = contact::make_hard_spheres(found.setup, compose(found.setup));
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
          {"substeps", 0},
          {"hits", run->counts().hits}};
}

nlohmann::json measured(const contact::Scene& scene, double seconds,
                        const contact::PlanOptions& options, bool everything) {
  const contact::Plan plan = contact::plan_scene(scene, options);
  if (const auto refusal = contact::scenes::run_refusal(scene, plan))
    throw std::runtime_error(scene.name + " cannot be simulated: " + *refusal);
  const auto run = contact::scenes::make_run(scene, plan);
  nlohmann::json result;
  if (run->event_driven() && plan.pairs > 0) {
    result = of_hard_balls(scene, seconds, [&](const contact::HardSphereSetup& setup) {
      return everything ? contact::HardSphereComposition()
                        : composition_of(setup, options.overrides);
    });
  } else {
    // Positions are read at the end: a run that computes them only on request pays here.
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
    result = {{"event_driven", run->event_driven()},
              {"stages", stages},
              {"bytes_per_body", run->bytes_per_body()},
              {"steps", counts.steps},
              {"substeps", counts.substeps},
              {"hits", counts.hits},
              {"pairs", counts.pairs},
              {"contacts", counts.contacts},
              {"iterations", counts.iterations}};
  }
  result["step"] = plan.step;
  result["estimates"] = estimates(plan);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 2 ? std::atof(argv[2]) : 0;
  contact::PlanOptions options;
  const bool everything = argc == 4 && std::string(argv[3]) == "everything";
  bool understood = seconds > 0;
  for (int i = 3; !everything && i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("step=")) {
      options.step = std::atof(word.c_str() + 5);
      continue;
    }
    const auto effect = contact::effect_named(word.substr(word.empty() ? 0 : 1));
    understood = understood && effect && (word[0] == '+' || word[0] == '-');
    if (!understood) break;
    (word[0] == '+' ? options.overrides.with : options.overrides.without).push_back(*effect);
  }
  if (!understood) {
    std::fprintf(stderr,
                 "usage: scene_stages SCENE.json SECONDS [everything | step=SECONDS | +EFFECT | "
                 "-EFFECT]...\n");
    return 2;
  }
  try {
    contact::Scene scene = contact::scenes::read_scene(argv[1]);
    scene.duration = seconds;
    std::puts(measured(scene, seconds, options, everything).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scene_stages: %s\n", error.what());
    return 1;
  }
}
