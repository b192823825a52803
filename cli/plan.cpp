// contact plan: which effects a scene calls for, with the inequality and the numbers that decide.

#include <contact/plan.hpp>

#include "commands.hpp"
#include "plan_report.hpp"
#include "scenes/scene_file.hpp"
#include "terminal.hpp"

namespace contact::cli {

namespace {

struct Words {
  std::string scene;
  std::vector<std::string> with;
  std::vector<std::string> without;
  double step = 0;
  bool stepped = false;
  bool json = false;
};

/// The effects of a list of names.
std::vector<Effect> effects_of(const std::vector<std::string>& names) {
  std::vector<Effect> effects;
  for (const std::string& name : names) {
    const std::optional<Effect> effect = effect_named(name);
    if (effect && can_be_switched(*effect)) {
      effects.push_back(*effect);
      continue;
    }
    std::string known;
    for (const Effect one : all_effects) {
      if (can_be_switched(one))
        known += (known.empty() ? "" : ", ") + std::string(effect_name(one));
    }
    throw grading::UnknownName(
        effect ? "'" + name + "' is a value; it is not switched on or off. These are: " + known
               : "there is no effect called '" + name + "'; there are " + known);
  }
  return effects;
}

int run(const Words& words) {
  PlanOptions options;
  options.overrides.with = effects_of(words.with);
  options.overrides.without = effects_of(words.without);
  for (const Effect effect : options.overrides.with) {
    for (const Effect other : options.overrides.without) {
      if (effect == other)
        throw grading::UnknownName("'" + std::string(effect_name(effect)) +
                                   "' is asked for both with and without");
    }
  }
  if (words.stepped) {
    if (!(std::isfinite(words.step) && words.step > 0))
      throw grading::UnknownName("--step " + number_text(words.step) +
                                 ": must be finite and greater than 0, in seconds");
    options.step = words.step;
  }
  const std::filesystem::path file = scene_path(words.scene);
  Scene scene;
  try {
    scene = scenes::read_scene(file);
  } catch (const scenes::SceneFileError& error) {
    note(error.what());
    return exit_not_passed;
  }
  const Plan plan = plan_scene(scene, options);
  if (words.json)
    say(plan_json(scene, plan).dump(1));
  else
    say(plan_text(scene, plan, Style(stdout)));
  return exit_passed;
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  const auto words = std::make_shared<Words>();
  CLI::App* command =
      app.add_subcommand("plan", "Which effects a scene calls for, with the numbers that decide");
  command->add_option("SCENE", words->scene, "A scene file, or the name of a scene of the book")
      ->required();
  command->add_option("--with", words->with, "Force an effect on; may be given again")
      ->type_name("EFFECT")
      ->allow_extra_args(false);
  command->add_option("--without", words->without, "Force an effect off; may be given again")
      ->type_name("EFFECT")
      ->allow_extra_args(false);
  CLI::Option* step =
      command->add_option("--step", words->step, "Go step by step, in steps of so many seconds")
          ->type_name("SECONDS");
  command->add_flag("--json", words->json, "Print JSON");
  command->callback([&action, words, step] {
    words->stepped = step->count() > 0;
    action = [words](Context&) { return run(*words); };
  });
}

}  // namespace contact::cli
