// contact solution: the book's own answer, after passing or giving up.

#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

int run(Context& context, const std::string& name, bool give_up) {
  const grading::Exercise& exercise = context.book().exercise(name);
  grading::Progress progress(context.book().work());
  if (!progress.notice().empty()) note(progress.notice());
  const grading::ExerciseProgress done = progress.of(exercise.id());
  if (done.passed.empty() && !done.solution_shown && !give_up) {
    note("The solution of " + exercise.id() + " opens once its tests pass.");
    const int left = static_cast<int>(exercise.hints.size()) - done.hints_shown;
    if (left > 0)
      note("There " +
           std::string(left == 1 ? "is one more hint"
                                 : "are " + std::to_string(left) + " more hints") +
           ": " + program_as_typed() + " hint " + exercise.name);
    note("To see it anyway: " + program_as_typed() + " solution " + exercise.name + " --give-up");
    return exit_not_passed;
  }
  const std::string text = grading::solution_text(exercise);
  if (done.passed.empty()) progress.record_solution_shown(exercise.id());
  note(Style(stderr).dim("// " + shown(exercise.solution)));
  say(text.substr(0, text.find_last_not_of('\n') + 1));
  return exit_passed;
}

}  // namespace

void add_solution(Command app, Action& action) {
  auto name = std::make_shared<std::string>();
  auto give_up = std::make_shared<bool>(false);
  const Command command =
      app.add_subcommand("solution", "The book's solution, once you have passed");
  command.add_option("exercise", *name, "The exercise").required();
  command.add_flag("--give-up", *give_up, "Show it before you have passed");
  command.callback([&action, name, give_up] {
    action = [name, give_up](Context& context) { return run(context, *name, *give_up); };
  });
}

}  // namespace contact::cli
