// contact start: the student's own copy of a stub.

#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

bool start_exercise(const grading::Book& book, const grading::Exercise& exercise) {
  const fs::path copy = book.work_file(exercise);
  if (fs::exists(copy)) return false;
  fs::create_directories(copy.parent_path());
  grading::write_text(copy, grading::read_text(exercise.stub));
  return true;
}

namespace {

int run(Context& context, const std::vector<std::string>& names) {
  const grading::Book& book = context.book();
  for (const std::string& name : names) {
    for (const grading::Exercise* exercise : book.meant_by(name)) {
      const bool made = start_exercise(book, *exercise);
      const std::string copy = shown(book.work_file(*exercise));
      say(made ? "Your copy is " + copy : "Your copy already exists and was not changed: " + copy);
      if (names.size() > 1) continue;
      say("What it must do is stated in " + shown(exercise->contract));
      say("Edit it, then: ./contact check " + exercise->name +
          "   or leave running: ./contact watch " + exercise->name);
    }
  }
  return exit_passed;
}

}  // namespace

void add_start(Command app, Action& action) {
  auto names = std::make_shared<std::vector<std::string>>();
  const Command command =
      app.add_subcommand("start", "Copy an exercise's stub to your folder (never overwrites)");
  command
      .add_option("exercise", *names,
                  "Exercises or chapters: ray_triangle, 02_triangles/ray_triangle, 02_triangles")
      .required();
  command.callback(
      [&action, names] { action = [names](Context& context) { return run(context, *names); }; });
}

}  // namespace contact::cli
