/// @file
/// One table of all parts: a row is what was asked, a column a program.
#pragma once

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// Collects what the parts found.
class Summary {
 public:
  /// @param programs the columns
  explicit Summary(std::vector<std::string> programs) : programs_(std::move(programs)) {}

  /// Notes a program's answer; a program that is no column is left out.
  void add(const std::string& question, const std::string& program, const char* format,
           double value) {
    auto row = std::find_if(rows_.begin(), rows_.end(),
                            [&](const auto& each) { return each.first == question; });
    if (row == rows_.end()) row = rows_.insert(row, {question, {}});
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    row->second[program] = text;
  }

  void print() const {
    std::printf("side by side, medians; ms are of the processor\n%-34s", "");
    for (const std::string& program : programs_)
      std::printf(" %*s", width_of(program), program.c_str());
    std::printf("\n");
    for (const auto& [question, answers] : rows_) {
      std::printf("%-34s", question.c_str());
      for (const std::string& program : programs_) {
        const auto found = answers.find(program);
        std::printf(" %*s", width_of(program),
                    found == answers.end() ? "-" : found->second.c_str());
      }
      std::printf("\n");
    }
    std::printf("\n");
  }

 private:
  /// Narrow enough that a page shows all columns.
  static int width_of(const std::string& program) {
    return std::max(8, static_cast<int>(program.size()));
  }

  std::vector<std::string> programs_;
  std::vector<std::pair<std::string, std::map<std::string, std::string>>> rows_;
};
