#include "progress_report.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace contact::grading {

namespace {

// An objective may be written alone or as NN_slug/objective.
bool serves(const Exercise& exercise, const Chapter& chapter, const Objective& objective) {
  return exercise.objective == objective.id ||
         exercise.objective == chapter.slug + "/" + objective.id;
}

nlohmann::json json_of(const Tally& tally) {
  return {{"exercises", tally.exercises},
          {"passed", tally.passed},
          {"points", tally.points},
          {"max_points", tally.max_points},
          {"mastered", tally.mastered()}};
}

}  // namespace

void Tally::add(const Exercise& exercise, const ExerciseProgress& done) {
  ++exercises;
  passed += done.passed.empty() ? 0 : 1;
  points += std::min(done.best_points, exercise.max_points());
  max_points += exercise.max_points();
}

std::vector<ChapterTally> tally(const Book& book, const ProgressRecord& progress) {
  std::vector<ChapterTally> result;
  for (const Chapter& chapter : book.chapters()) {
    ChapterTally entry{&chapter, {}, {}};
    for (const Objective& objective : chapter.objectives)
      entry.objectives.push_back({&objective, {}});
    for (const Exercise* exercise : book.exercises_of(chapter)) {
      const ExerciseProgress done = progress.of(exercise->id());
      entry.all.add(*exercise, done);
      for (auto& [objective, sum] : entry.objectives) {
        if (serves(*exercise, chapter, *objective)) sum.add(*exercise, done);
      }
    }
    if (entry.all.exercises > 0) result.push_back(std::move(entry));
  }
  return result;
}

nlohmann::json progress_report(const Book& book, const ProgressRecord& progress) {
  nlohmann::json chapters = nlohmann::json::array();
  Tally total;
  for (const ChapterTally& entry : tally(book, progress)) {
    nlohmann::json json = json_of(entry.all);
    json["slug"] = entry.chapter->slug;
    json["objectives"] = nlohmann::json::array();
    for (const auto& [objective, sum] : entry.objectives) {
      nlohmann::json item = json_of(sum);
      item["id"] = objective->id;
      item["text"] = objective->text;
      json["objectives"].push_back(std::move(item));
    }
    chapters.push_back(std::move(json));
  }
  nlohmann::json exercises = nlohmann::json::object();
  for (const Exercise& exercise : book.exercises()) {
    const ExerciseProgress done = progress.of(exercise.id());
    total.add(exercise, done);
    exercises[exercise.id()] = {{"attempts", done.attempts},
                                {"best_points", done.best_points},
                                {"max_points", exercise.max_points()},
                                {"passed", done.passed},
                                {"passed_as", done.passed_as},
                                {"hints_shown", done.hints_shown},
                                {"solution_shown", done.solution_shown},
                                {"tests", done.tests}};
  }
  return {{"format", "contact-progress-report/1"},
          {"total", json_of(total)},
          {"chapters", chapters},
          {"exercises", exercises}};
}

}  // namespace contact::grading
