// contact start: the student's own copy of a stub.

#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../python.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

std::string beginning(Context& context, const grading::Exercise& exercise,
                      const std::string& form) {
  if (form == "write") return grading::read_text(exercise.stub);
  const grading::Book& book = context.book();
  const grading::ProcessResult made =
      run_python(context.loop(),
                 {python_of(book).string(), (book.book_root() / "grading/book/forms.py").string(),
                  "--root", book.root().string(), "--form", form, exercise.id()});
  if (!made.succeeded())
    throw grading::BookError(made.errors.substr(0, made.errors.find_last_not_of('\n') + 1));
  return made.output;
}

}  // namespace

void write_copy(const grading::Book& book, const grading::Exercise& exercise,
                const std::string& text, const std::string& form) {
  const fs::path copy = book.work_file(exercise);
  fs::create_directories(copy.parent_path());
  grading::write_text(copy, text);
  grading::Progress progress(book.work());
  if (progress.of(exercise.id()).form != form) progress.record_form(exercise.id(), form);
}

bool start_exercise(const grading::Book& book, const grading::Exercise& exercise) {
  if (book.started(exercise)) return false;
  write_copy(book, exercise, grading::read_text(exercise.stub), "write");
  return true;
}

namespace {

int run(Context& context, const std::vector<std::string>& names, const std::string& form) {
  const grading::Book& book = context.book();
  for (const std::string& name : names) {
    for (const grading::Exercise* exercise : book.meant_by(name)) {
      const bool made = !book.started(*exercise);
      if (made) write_copy(book, *exercise, beginning(context, *exercise, form), form);
      const std::string copy = shown(book.work_file(*exercise));
      say(made ? "Your copy is " + copy : "Your copy already exists and was not changed: " + copy);
      if (names.size() > 1) continue;
      say("What it must do is stated in " + shown(exercise->contract));
      say("Edit it, then: " + program_as_typed() + " check " + exercise->name +
          "   or leave running: " + program_as_typed() + " watch " + exercise->name);
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
  auto form = std::make_shared<std::string>("write");
  command
      .add_option("--form", *form,
                  "Begin with lines to put in order, with gaps to fill, or with the stub")
      .one_of({grading::forms.begin(), grading::forms.end()});
  command.callback([&action, names, form] {
    action = [names, form](Context& context) { return run(context, *names, *form); };
  });
}

}  // namespace contact::cli
