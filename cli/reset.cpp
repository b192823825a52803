// contact reset: the pristine stub again; the student's version is kept.

#include <array>
#include <ctime>

#include "commands.hpp"
#include "terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

std::string stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d-%H%M%S", &parts);
  return text.data();
}

// A name that nothing has yet: two resets in one second keep two copies.
fs::path kept_path(const grading::Book& book, const grading::Exercise& exercise) {
  const fs::path folder = book.work() / ".kept" / exercise.chapter;
  const std::string base = exercise.name + "." + stamp();
  fs::path candidate = folder / (base + ".cpp");
  for (int i = 2; fs::exists(candidate); ++i)
    candidate = folder / (base + "-" + std::to_string(i) + ".cpp");
  return candidate;
}

int run(Context& context, const std::string& name) {
  const grading::Book& book = context.book();
  const grading::Exercise& exercise = book.exercise(name);
  const fs::path copy = book.work_file(exercise);
  if (fs::exists(copy)) {
    const std::string text = grading::read_text(copy);
    const std::string stub = grading::read_text(exercise.stub);
    if (text == stub) {
      say(shown(copy) + " is as it was given; there is nothing to reset.");
      return exit_passed;
    }
    const fs::path kept = kept_path(book, exercise);
    fs::create_directories(kept.parent_path());
    grading::write_text(kept, text);
    grading::write_text(copy, stub);
    say("Your version is kept as " + shown(kept));
  } else {
    start_exercise(book, exercise);
  }
  say(shown(copy) + " is as it was given.");
  return exit_passed;
}

}  // namespace

void add_reset(CLI::App& app, Action& action) {
  auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("reset", "Begin an exercise again; your version is kept");
  command->add_option("exercise", *name, "The exercise")->required();
  command->callback(
      [&action, name] { action = [name](Context& context) { return run(context, *name); }; });
}

}  // namespace contact::cli
