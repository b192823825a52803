#pragma once

#include <string>

#include "../../grading/verdict/verdict.hpp"
#include "../terminal/terminal.hpp"

namespace contact::cli {

struct ReportOptions {
  /// Everything the compiler said, instead of its first error.
  bool full = false;
  /// Every failure whole, instead of the first.
  bool all_failures = false;
};

/// A verdict as a reader sees it: the name of each test, then the first failure in full.
std::string report(const grading::Verdict& verdict, const Style& style,
                   const ReportOptions& options);

/// "passed: 7 of 7 points", the last line of a report.
std::string summary(const grading::Verdict& verdict, const Style& style);

}  // namespace contact::cli
