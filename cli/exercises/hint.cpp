// contact hint: one more each time.

#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

int run(Context& context, const std::string& name, bool again) {
  const grading::Exercise& exercise = context.book().exercise(name);
  grading::Progress progress(context.book().work());
  if (!progress.notice().empty()) note(progress.notice());
  const auto count = static_cast<int>(exercise.hints.size());
  if (count == 0) {
    say(exercise.id() + " has no hints: it is meant to be done without.");
    return exit_passed;
  }
  int known = std::min(progress.of(exercise.id()).hints_shown, count);
  if (!again && known < count) known = progress.record_hint(exercise.id());
  if (known == 0) {
    say("No hint of " + exercise.id() + " has been shown yet.");
    return exit_passed;
  }
  const Style style(stdout);
  for (int i = again ? 0 : known - 1; i < known; ++i) {
    say(style.bold("Hint " + std::to_string(i + 1) + " of " + std::to_string(count)));
    say(wrapped(exercise.hints[static_cast<std::size_t>(i)], 2));
  }
  if (known == count)
    say(style.dim("That is the last one; `" + program_as_typed() + " hint " + exercise.name +
                  " --again` shows all."));
  return exit_passed;
}

}  // namespace

void add_hint(Command app, Action& action) {
  auto name = std::make_shared<std::string>();
  auto again = std::make_shared<bool>(false);
  const Command command = app.add_subcommand("hint", "One more hint for an exercise each time");
  command.add_option("exercise", *name, "The exercise").required();
  command.add_flag("--again", *again, "Show again the hints shown so far");
  command.callback([&action, name, again] {
    action = [name, again](Context& context) { return run(context, *name, *again); };
  });
}

}  // namespace contact::cli
