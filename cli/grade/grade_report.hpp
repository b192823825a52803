#pragma once

// What `contact grade` says while it runs and at its end.

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "../../grading/grade/results.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

/// The progress of a grading, on standard error: one changing line on a terminal, otherwise an
/// occasional line.
class GradeProgress {
 public:
  GradeProgress(std::size_t total, int workers);
  ~GradeProgress();
  GradeProgress(const GradeProgress&) = delete;
  GradeProgress& operator=(const GradeProgress&) = delete;

  void finished(const grading::Job& job);
  /// A note between, which the line makes way for.
  void say_beside(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  void draw(const std::string& text);
  void clear();
  [[nodiscard]] std::string rest() const;

  std::size_t total_;
  std::size_t done_ = 0;
  bool terminal_;
  std::size_t drawn_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point said_ = start_;
};

/// The numbers of graded and refused submissions, the mean, and what this machine could not
/// enforce.
std::string grade_summary(const nlohmann::json& results, const grading::Summary& summary,
                          const Style& style);

/// The command that this program was started with, to be typed into a shell. What it keeps by
/// itself is left out: the seed, which a reader of reports must not see, and --recalibrate, which
/// would change the marks of others.
/// @param root the book's, whose ./contact starts the program
std::string command_again(const std::filesystem::path& root);

/// Every refusal, a line each.
std::string refusals(const nlohmann::json& results);

/// A table of the marks that changed, appeared or disappeared: before, after and why.
std::string changes_table(const nlohmann::json& changes, const Style& style);

}  // namespace contact::cli
