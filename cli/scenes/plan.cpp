// contact plan: which effects a scene needs, with the inequality and the numbers that decide.

#include <contact/plan/plan.hpp>
#include <contact/plan/plan_report.hpp>
#include <contact/scene/scene_file.hpp>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "plan_measure.hpp"
#include "plan_options.hpp"

namespace contact::cli {

namespace {

struct Words {
  std::string scene;
  scenes::PlanWords plan;
  bool measure = false;
  bool json = false;
};

scenes::TableStyle style_of_table(const Style& style) {
  scenes::TableStyle table;
  table.bold = [style](std::string_view text) { return style.bold(text); };
  table.dim = [style](std::string_view text) { return style.dim(text); };
  table.good = [style](std::string_view text) { return style.good(text); };
  table.warn = [style](std::string_view text) { return style.warn(text); };
  table.padded = padded;
  table.wrapped = wrapped;
  return table;
}

int run(const Words& words) {
  const PlanOptions options = typed_plan_options(words.plan);
  const std::filesystem::path file = scene_path(words.scene);
  Scene scene;
  try {
    scene = scenes::read_scene(file);
  } catch (const scenes::SceneFileError& error) {
    note(error.what());
    return exit_not_passed;
  }
  const Plan plan = plan_scene(scene, options);
  std::vector<scenes::MeasuredEffect> measured;
  if (words.measure) {
    ProgressLine progress(1);
    measured = measure_effects(scene, plan, options, progress);
  }
  if (words.json)
    say(scenes::plan_json(scene, plan, measured).dump(1));
  else
    say(scenes::plan_text(scene, plan, measured, style_of_table(Style(stdout))));
  return exit_passed;
}

}  // namespace

void add_plan(Command app, Action& action) {
  const auto words = std::make_shared<Words>();
  const Command command = app.add_subcommand(plan_command);
  command.add_option("SCENE", words->scene, "A scene file, or the name of a scene of the book")
      .required();
  add_plan_words(command, words->plan);
  command.add_flag("--measure", words->measure,
                   "Run the scene with each effect switched, and report what that costs");
  command.add_flag("--json", words->json, "Print JSON");
  command.callback([&action, words] { action = [words](Context&) { return run(*words); }; });
}

}  // namespace contact::cli
