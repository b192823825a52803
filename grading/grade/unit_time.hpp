#pragma once

// How long a unit may take on the clock, computed here and nowhere else. Every box of a unit has a
// limit of its own, so what a submission does cannot take longer than their sum. A unit that takes
// longer hangs for a reason of ours, and its worker is ended.

#include "unit.hpp"

namespace contact::grading {

/// Of a compile box and of a link box.
double compile_wall_seconds(const GradeLimits& limits);

/// Of the submission in one test.
double test_wall_seconds(const UnitSettings& settings);

/// Of the judge in one test, with the submission that it asks.
double judge_wall_seconds(const UnitSettings& settings);

/// Of all processes that judge one program of tests, one after the other. The first may take what
/// all its tests may; those that follow one that died share as much again, and each has at least
/// the time of one test.
class JudgingTime {
 public:
  JudgingTime(const Exercise& exercise, const UnitSettings& settings);
  /// What the next process may take.
  [[nodiscard]] double next() const;
  void spend(double seconds) { spent_ += seconds; }
  /// What all of them can take together.
  [[nodiscard]] double most() const;

 private:
  double tests_;
  double test_;
  double spent_ = 0.0;
};

/// Of a whole unit: compiled once, linked twice at most, its messages explained, judged by the
/// book's tests and by each program of settings.more_tests, and a margin for what comes between.
/// settings.limits.unit_seconds stands for it if it is not 0.
/// @param exercise with its private tests
double declared_seconds(const Exercise& exercise, const UnitSettings& settings);

/// Why a unit that outlived them could not be graded.
std::string out_of_time_words(double seconds);

}  // namespace contact::grading
