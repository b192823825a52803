// contact reset: the pristine stub again; the student's version is kept.

#include <array>
#include <ctime>

#include "../commands.hpp"
#include "../terminal/terminal.hpp"

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

}  // namespace

fs::path keep_aside(const grading::Book& book, const std::string& chapter, const std::string& name,
                    const std::string& text) {
  const fs::path folder = book.work() / ".kept" / chapter;
  const std::string base = name + "." + stamp();
  fs::path kept = folder / (base + ".cpp");
  // Two in one second are two copies.
  for (int i = 2; fs::exists(kept); ++i) kept = folder / (base + "-" + std::to_string(i) + ".cpp");
  fs::create_directories(folder);
  grading::write_text(kept, text);
  return kept;
}

namespace {

int run(Context& context, const std::string& name) {
  const grading::Book& book = context.book();
  const grading::Exercise& exercise = book.exercise(name);
  const fs::path copy = book.work_file(exercise);
  if (fs::exists(copy)) {
    const std::string text = grading::read_text(copy);
    const std::string stub = grading::read_text(exercise.stub);
    if (text == stub) {
      say(shown(copy) + " is unchanged; there is nothing to reset.");
      return exit_passed;
    }
    const fs::path kept = keep_aside(book, exercise.chapter, exercise.name, text);
    write_copy(book, exercise, stub, "write");
    say("Your version is kept as " + shown(kept));
  } else {
    start_exercise(book, exercise);
  }
  say(shown(copy) + " is unchanged.");
  return exit_passed;
}

}  // namespace

void add_reset(Command app, Action& action) {
  auto name = std::make_shared<std::string>();
  const Command command =
      app.add_subcommand("reset", "Begin an exercise again; your version is kept");
  command.add_option("exercise", *name, "The exercise").required();
  command.callback(
      [&action, name] { action = [name](Context& context) { return run(context, *name); }; });
}

}  // namespace contact::cli
