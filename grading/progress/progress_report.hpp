#pragma once

// A reader's progress: points by chapter, by objective and by exercise.

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "../book/book.hpp"
#include "progress_record.hpp"

namespace contact::grading {

struct Tally {
  int exercises = 0;
  int passed = 0;
  double points = 0.0;
  double max_points = 0.0;

  void add(const Exercise& exercise, const ExerciseProgress& done);
  [[nodiscard]] bool mastered() const { return exercises > 0 && passed == exercises; }
};

struct ChapterTally {
  const Chapter* chapter;
  Tally all;
  std::vector<std::pair<const Objective*, Tally>> objectives;
};

/// The chapters that have exercises, in order. Points into `book`.
std::vector<ChapterTally> tally(const Book& book, const ProgressRecord& progress);

/// The document of `contact progress --json`.
nlohmann::json progress_report(const Book& book, const ProgressRecord& progress);

}  // namespace contact::grading
