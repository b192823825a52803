// contact progress: points by chapter and by objective.

#include <nlohmann/json.hpp>

#include "../grading/progress.hpp"
#include "commands.hpp"
#include "terminal.hpp"

namespace contact::cli {

namespace {

using grading::Book;
using grading::Exercise;
using grading::points_text;

struct Tally {
  int exercises = 0;
  int passed = 0;
  double points = 0.0;
  double max_points = 0.0;

  void add(const Exercise& exercise, const grading::ExerciseProgress& done) {
    ++exercises;
    passed += done.passed.empty() ? 0 : 1;
    points += std::min(done.best_points, exercise.max_points());
    max_points += exercise.max_points();
  }
  [[nodiscard]] bool mastered() const { return exercises > 0 && passed == exercises; }
  [[nodiscard]] nlohmann::json json() const {
    return {{"exercises", exercises},
            {"passed", passed},
            {"points", points},
            {"max_points", max_points},
            {"mastered", mastered()}};
  }
};

// An objective may be written alone or as NN_slug/objective.
bool serves(const Exercise& exercise, const grading::Chapter& chapter,
            const grading::Objective& objective) {
  return exercise.objective == objective.id ||
         exercise.objective == chapter.slug + "/" + objective.id;
}

struct ChapterTally {
  const grading::Chapter* chapter;
  Tally all;
  std::vector<std::pair<const grading::Objective*, Tally>> objectives;
};

std::vector<ChapterTally> tally(const Book& book, const grading::Progress& progress) {
  std::vector<ChapterTally> result;
  for (const grading::Chapter& chapter : book.chapters()) {
    ChapterTally entry{&chapter, {}, {}};
    for (const grading::Objective& objective : chapter.objectives)
      entry.objectives.push_back({&objective, {}});
    for (const Exercise* exercise : book.exercises_of(chapter)) {
      const grading::ExerciseProgress done = progress.of(exercise->id());
      entry.all.add(*exercise, done);
      for (auto& [objective, sum] : entry.objectives) {
        if (serves(*exercise, chapter, *objective)) sum.add(*exercise, done);
      }
    }
    if (entry.all.exercises > 0) result.push_back(std::move(entry));
  }
  return result;
}

nlohmann::json json_of(const Book& book, const grading::Progress& progress) {
  nlohmann::json chapters = nlohmann::json::array();
  Tally total;
  for (const ChapterTally& entry : tally(book, progress)) {
    nlohmann::json json = entry.all.json();
    json["slug"] = entry.chapter->slug;
    json["objectives"] = nlohmann::json::array();
    for (const auto& [objective, sum] : entry.objectives) {
      nlohmann::json item = sum.json();
      item["id"] = objective->id;
      item["text"] = objective->text;
      json["objectives"].push_back(std::move(item));
    }
    chapters.push_back(std::move(json));
  }
  nlohmann::json exercises = nlohmann::json::object();
  for (const Exercise& exercise : book.exercises()) {
    const grading::ExerciseProgress done = progress.of(exercise.id());
    total.add(exercise, done);
    exercises[exercise.id()] = {{"attempts", done.attempts},
                                {"best_points", done.best_points},
                                {"max_points", exercise.max_points()},
                                {"passed", done.passed},
                                {"hints_shown", done.hints_shown},
                                {"solution_shown", done.solution_shown},
                                {"tests", done.tests}};
  }
  return {{"format", "contact-progress-report/1"},
          {"total", total.json()},
          {"chapters", chapters},
          {"exercises", exercises}};
}

void print(const Book& book, const grading::Progress& progress) {
  const Style style(stdout);
  Tally total;
  for (const ChapterTally& entry : tally(book, progress)) {
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
}

int run(Context& context, bool json) {
  const Book& book = context.book();
  const grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());
  if (json)
    say(json_of(book, progress).dump(2));
  else
    print(book, progress);
  return exit_passed;
}

}  // namespace

void add_progress(CLI::App& app, Action& action) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("progress", "Your points by chapter and objective");
  command->add_flag("--json", *json, "Print JSON");
  command->callback(
      [&action, json] { action = [json](Context& context) { return run(context, *json); }; });
}

}  // namespace contact::cli
