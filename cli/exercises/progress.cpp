// contact progress: points by chapter and by objective.

#include <nlohmann/json.hpp>

#include "../../grading/progress/progress.hpp"
#include "../../grading/progress/progress_report.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

using grading::Book;
using grading::ChapterTally;
using grading::points_text;
using grading::Tally;

// Those that passed, but not from the stub: in which form they did.
void print_forms(const Book& book, const grading::Progress& progress) {
  for (const grading::Exercise& exercise : book.exercises()) {
    const auto passed_as = progress.of(exercise.id()).passed_as;
    if (passed_as.empty() || passed_as.contains("write")) continue;
    std::string forms;
    for (const auto& [form, time] : passed_as) forms += (forms.empty() ? "" : ", ") + form;
    say("Not written from the stub: " + exercise.id() + " (" + forms + ")");
  }
}

void print(const Book& book, const grading::Progress& progress) {
  const Style style(stdout);
  Tally total;
  for (const ChapterTally& entry : grading::tally(book, progress.known())) {
    const Tally& all = entry.all;
    say(style.bold(entry.chapter->slug) + "  " + points_text(all.points) + " of " +
        points_text(all.max_points) + " points, " + std::to_string(all.passed) + " of " +
        std::to_string(all.exercises) + " exercises passed");
    for (const auto& [objective, sum] : entry.objectives) {
      if (sum.exercises == 0) continue;
      const std::string state =
          padded(sum.mastered() ? "mastered"
                                : points_text(sum.points) + " of " + points_text(sum.max_points),
                 12);
      say("  " + (sum.mastered() ? style.good(state) : state) + objective->text);
    }
    total.exercises += all.exercises;
    total.passed += all.passed;
    total.points += all.points;
    total.max_points += all.max_points;
  }
  say("In all: " + points_text(total.points) + " of " + points_text(total.max_points) +
      " points, " + std::to_string(total.passed) + " of " + std::to_string(total.exercises) +
      " exercises passed.");
  print_forms(book, progress);
}

int run(Context& context, bool json) {
  const Book& book = context.book();
  const grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());
  if (json)
    say(grading::progress_report(book, progress.known()).dump(2));
  else
    print(book, progress);
  return exit_passed;
}

}  // namespace

void add_progress(Command app, Action& action) {
  auto json = std::make_shared<bool>(false);
  const Command command = app.add_subcommand("progress", "Your points by chapter and objective");
  command.add_flag("--json", *json, "Print JSON");
  command.callback(
      [&action, json] { action = [json](Context& context) { return run(context, *json); }; });
}

}  // namespace contact::cli
