// contact plan: which effects a scene needs, with the inequality and the numbers that decide.

#include <optional>

#include <contact/plan/plan.hpp>
#include <contact/plan/plan_report.hpp>
#include <contact/scene/scene_file.hpp>

#include "../../grading/book/book.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "plan_measure.hpp"
#include "plan_options.hpp"

namespace contact::cli {

namespace {

constexpr const char* all_of_them = "all";

struct Words {
  std::string scene;
  scenes::PlanWords plan;
  std::string explain;  // an effect, or all; empty: only a summary is printed
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

/// The one effect that is explained; nothing: all are.
std::optional<Effect> explained(const Words& words) {
  if (words.explain.empty() || words.explain == all_of_them) return std::nullopt;
  const std::optional<Effect> effect = effect_named(words.explain);
  if (effect) return effect;
  std::string known;
  for (const Effect one : all_effects)
    known += (known.empty() ? "" : ", ") + std::string(effect_name(one));
  throw grading::UnknownName("--explain " + shortened(words.explain) +
                             ": there is no such effect; there are " + known);
}

int run(const Words& words) {
  const std::optional<Effect> only = explained(words);
  const PlanOptions options = typed_plan_options(words.plan);
  const std::filesystem::path file = scene_path(words.scene);
  Scene scene;
  Plan plan;
  std::vector<scenes::MeasuredEffect> measured;
  try {
    ProgressLine progress(1);
    progress.tell(0, "reading " + file.filename().string());
    scene = scenes::read_scene(file);
    progress.tell(0, "planning " + std::to_string(scene.bodies.size()) + " bodies");
    plan = plan_scene(scene, options);
    if (words.measure) measured = measure_effects(scene, plan, options, progress);
  } catch (const scenes::SceneFileError& error) {
    note(error.what());
    return exit_not_passed;
  }
  if (words.json)
    say(scenes::plan_json(scene, plan, measured).dump(1));
  else if (!words.explain.empty() || words.measure)
    say(scenes::plan_text(scene, plan, measured, style_of_table(Style(stdout)), only));
  else
    say(scenes::plan_summary(scene, plan, style_of_table(Style(stdout))));
  return exit_passed;
}

}  // namespace

void add_plan(Command app, Action& action) {
  const auto words = std::make_shared<Words>();
  const Command command = app.add_subcommand(plan_command);
  command.add_option("SCENE", words->scene, "A scene file, or the name of a scene of the book");
  add_plan_words(command, words->plan);
  command
      .add_option("--explain", words->explain,
                  "Print every condition with its numbers, and the cost: of one effect, or of all")
      .alone(all_of_them)
      .type_name("EFFECT");
  command.add_flag("--measure", words->measure,
                   "Run the scene with each effect switched, and report what that costs");
  command.add_flag("--json", words->json, "Print JSON");
  command.callback([&action, words] {
    // In `plan --explain SCENE` the scene stands in the place of an effect.
    if (words->scene.empty() && !words->explain.empty() && !effect_named(words->explain)) {
      words->scene = words->explain;
      words->explain = all_of_them;
    }
    if (words->scene.empty())
      throw MissingOption("SCENE is required: contact plan bouncing_ball, for example");
    action = [words](Context&) { return run(*words); };
  });
}

}  // namespace contact::cli
