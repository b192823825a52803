#pragma once

// The Python that makes every report of results.json, grading/reports, run as a process.

#include <optional>
#include <string>
#include <vector>

#include "run_state.hpp"

namespace contact::grading {

/// A module of grading/reports, to be run by the book's own Python.
/// @throws BookError, with what to do, if that Python is not there or may not be reached
ProcessSpec report_module(const Book& book, const std::string& module);

/// What is asked of the reports.
struct ReportOptions {
  std::vector<std::string> formats;  ///< all, if there are none
  std::string due;                   ///< as the reports' Python reads it
};

class ReportWriter {
 public:
  ReportWriter(const Book& book, ReportOptions options)
      : book_(book), options_(std::move(options)) {}

  /// The reports can be written, and what they are asked for is understood, now or not at all:
  /// where there are no results, all that they do is say so. May run beside anything else.
  /// @throws UnknownName if it is not understood; BookError if they cannot be written
  void require() const;
  /// @param again how what could not be graded is graded; nothing if there is none of it
  /// @throws BookError that says where the marks are
  void write(Loop& loop, const RunFolder& folder, const std::optional<std::string>& again) const;

 private:
  [[nodiscard]] ProcessResult run(Loop& loop, const std::filesystem::path& results,
                                  const std::optional<std::string>& again) const;

  const Book& book_;
  ReportOptions options_;
};

}  // namespace contact::grading
