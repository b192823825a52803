// contact list: the exercises by chapter, with the status of each.

#include <nlohmann/json.hpp>

#include "../../grading/progress/progress.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

namespace {

using grading::Book;
using grading::Exercise;
using grading::ExerciseProgress;

struct Standing {
  std::string key;
  std::string words;
};

Standing standing(const Book& book, const Exercise& exercise, const ExerciseProgress& progress) {
  if (!progress.passed.empty()) return {"passed", "passed"};
  if (progress.attempts > 0)
    return {"attempted", grading::points_text(progress.best_points) + " of " +
                             grading::points_text(exercise.max_points()) + " points"};
  if (book.started(exercise)) return {"started", "started"};
  return {"not_started", "not started"};
}

nlohmann::json json_of(const Book& book, const grading::Progress& progress) {
  nlohmann::json chapters = nlohmann::json::array();
  for (const grading::Chapter& chapter : book.chapters()) {
    nlohmann::json exercises = nlohmann::json::array();
    for (const Exercise* exercise : book.exercises_of(chapter)) {
      const ExerciseProgress done = progress.of(exercise->id());
      exercises.push_back({{"id", exercise->id()},
                           {"title", exercise->title},
                           {"kind", exercise->kind},
                           {"objective", exercise->objective},
                           {"minutes", exercise->minutes},
                           {"status", standing(book, *exercise, done).key},
                           {"best_points", done.best_points},
                           {"max_points", exercise->max_points()},
                           {"attempts", done.attempts},
                           {"file", book.work_file(*exercise).string()}});
    }
    chapters.push_back({{"slug", chapter.slug},
                        {"title", chapter.title},
                        {"part", chapter.part},
                        {"status", chapter.status},
                        {"exercises", exercises}});
  }
  return {{"format", "contact-list/1"}, {"chapters", chapters}};
}

void print(const Book& book, const grading::Progress& progress) {
  const Style style(stdout);
  std::size_t width = 0;
  for (const Exercise& exercise : book.exercises()) width = std::max(width, exercise.name.size());
  for (const grading::Chapter& chapter : book.chapters()) {
    const std::vector<const Exercise*> exercises = book.exercises_of(chapter);
    if (exercises.empty()) continue;
    say(style.bold(chapter.slug) + "  " + chapter.title);
    for (const Exercise* exercise : exercises) {
      const Standing state = standing(book, *exercise, progress.of(exercise->id()));
      std::string word = padded(state.words, 16);
      if (state.key == "passed") word = style.good(word);
      if (state.key == "attempted") word = style.warn(word);
      if (state.key == "not_started") word = style.dim(word);
      say("  " + padded(exercise->name, width + 2) + word + padded(exercise->kind, 12) +
          exercise->title + " (" + grading::points_text(exercise->minutes) + " min)");
    }
  }
}

int run(Context& context, bool json) {
  const Book& book = context.book();
  const grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());
  if (json)
    say(json_of(book, progress).dump(2));
  else
    print(book, progress);
  for (const grading::BookProblem& problem : book.problems()) note(problem.what);
  return book.problems().empty() ? exit_passed : exit_trouble;
}

}  // namespace

void add_list(Command app, Action& action) {
  auto json = std::make_shared<bool>(false);
  const Command command =
      app.add_subcommand("list", "The exercises by chapter, with the status of each");
  command.add_flag("--json", *json, "Print JSON");
  command.callback(
      [&action, json] { action = [json](Context& context) { return run(context, *json); }; });
}

}  // namespace contact::cli
