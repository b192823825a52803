#include "report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace contact::cli {

namespace {

using grading::CompileError;
using grading::Failure;
using grading::Outcome;
using grading::points_text;
using grading::Remark;
using grading::TestStatus;
using grading::TestVerdict;
using grading::Verdict;

constexpr std::size_t label_width = 8;
constexpr std::size_t output_lines_shown = 20;

std::string status_word(TestStatus status, const Style& style) {
  const std::string word = padded(grading::words(status), 14);
  switch (status) {
    case TestStatus::passed:
      return style.good(word);
    case TestStatus::failed:
    case TestStatus::stopped:
      return style.bad(word);
    case TestStatus::not_attempted:
    case TestStatus::skipped:
      break;
  }
  return style.dim(word);
}

void labelled(std::string& text, std::string_view label, std::string_view value,
              const Style& style) {
  if (value.empty()) return;
  const std::string body = wrapped(value, 4 + label_width);
  text += "    " + style.dim(padded(label, label_width)) + body.substr(4 + label_width) + "\n";
}

// A failure, or what a test that passed has to show.
std::string failure_text(const TestVerdict& test, const Failure& failure, const Style& style) {
  std::string text = "\n  " + style.bold(test.name) + "\n";
  labelled(text, "asked", failure.asked, style);
  std::size_t width = 0;
  for (const auto& [name, value] : failure.inputs) width = std::max(width, name.size());
  bool first = true;
  for (const auto& [name, value] : failure.inputs) {
    text += "    " + style.dim(padded(first ? "input" : "", label_width)) + padded(name, width) +
            " = " + printable(value) + "\n";
    first = false;
  }
  labelled(text, "got", printable(failure.got), style);
  labelled(text, "right", failure.right, style);
  labelled(text, "allowed", failure.allowed, style);
  labelled(text, test.status == TestStatus::stopped ? "stopped" : "why", printable(failure.reason),
           style);
  labelled(text, "hint", failure.hint, style);
  if (test.visibility == grading::Visibility::values_withheld)
    labelled(text, "note", "this test does not show its values", style);
  return text;
}

std::string place(const CompileError& error) {
  std::string text = shown(error.file);
  if (error.line > 0) text += ":" + std::to_string(error.line);
  if (error.line > 0 && error.column > 0) text += ":" + std::to_string(error.column);
  return text;
}

// The errors after the first, each at its line and in words.
std::string further_errors(const Verdict& verdict) {
  std::string text;
  for (const Remark& remark : verdict.remarks) {
    if (remark.severity != "error" || remark.line == verdict.compile_error->line) continue;
    text +=
        "\n" + wrapped("line " + std::to_string(remark.line) + ": " + printable(remark.words), 2);
  }
  return text.empty() ? text : text + "\n";
}

std::string compile_error_text(const CompileError& error, const Style& style, bool full) {
  if (full) return indented(printable(error.full), 2) + "\n";
  std::string text = "  " + (error.file.empty() ? "" : style.bold(place(error)) + ": ") +
                     style.bad("error: ") + printable(error.message) + "\n";
  if (!error.excerpt.empty()) text += indented(printable(error.excerpt), 2) + "\n";
  if (!error.explanation.empty()) text += wrapped(printable(error.explanation), 2) + "\n";
  for (const grading::ContractLine& line : error.contract) {
    text += "\n  " +
            style.dim("the contract, " + shown(line.file) + ":" + std::to_string(line.line)) + "\n";
    text += indented(line.text, 4) + "\n";
  }
  return text;
}

// What the compiler warns of may be why a test fails: what is recognised first.
std::string warnings_text(const Verdict& verdict, const Style& style) {
  const auto known = std::find_if(verdict.remarks.begin(), verdict.remarks.end(),
                                  [](const Remark& remark) { return !remark.mistake.empty(); });
  const auto shown = known == verdict.remarks.end() ? verdict.remarks.begin() : known;
  if (shown == verdict.remarks.end()) return {};
  const std::string label = "the compiler warns: ";
  std::string text =
      wrapped(label + "line " + std::to_string(shown->line) + ": " + printable(shown->words), 2);
  return "\n" + text.replace(2, label.size(), style.warn(label)) + "\n";
}

std::string output_text(const std::string& output, const Style& style) {
  if (output.empty()) return {};
  std::string text = "\n  " + style.dim("your program printed") + "\n";
  std::size_t at = 0;
  for (std::size_t line = 0; line < output_lines_shown && at < output.size(); ++line) {
    const std::size_t end = std::min(output.find('\n', at), output.size());
    text += "    " + printable(output.substr(at, std::min<std::size_t>(end - at, 200))) + "\n";
    at = end + 1;
  }
  if (at < output.size()) text += "    " + style.dim("(and more)") + "\n";
  return text;
}

std::string seconds_text(const grading::Seconds& seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", seconds.compile + seconds.link + seconds.run);
  return text.data();
}

}  // namespace

std::string summary(const Verdict& verdict, const Style& style) {
  const std::string points =
      points_text(verdict.points) + " of " + points_text(verdict.max_points) + " points";
  const std::string word = std::string(grading::words(verdict.outcome));
  const std::string coloured = verdict.outcome == Outcome::passed          ? style.good(word)
                               : verdict.outcome == Outcome::not_attempted ? style.warn(word)
                                                                           : style.bad(word);
  return verdict.exercise + ": " + coloured +
         (verdict.outcome == Outcome::does_not_compile ? "" : ", " + points) + "  " +
         style.dim("(" + seconds_text(verdict.seconds) + ")");
}

std::string report(const Verdict& verdict, const Style& style, const ReportOptions& options) {
  std::string text = style.bold(verdict.exercise) + style.dim("  " + shown(verdict.file)) + "\n";
  if (verdict.compile_error) {
    text += compile_error_text(*verdict.compile_error, style, options.full);
    if (!options.full) text += further_errors(verdict);
    return text + "\n" + summary(verdict, style);
  }
  for (const TestVerdict& test : verdict.tests) {
    text += "  " + status_word(test.status, style) +
            padded(points_text(test.points) + "/" + points_text(test.max_points), 7) + test.name +
            "\n";
  }
  bool first = true;
  for (const TestVerdict& test : verdict.tests) {
    if (test.status != TestStatus::failed && test.status != TestStatus::stopped) continue;
    if (first || options.all_failures) text += failure_text(test, test.failure, style);
    first = false;
  }
  for (const TestVerdict& test : verdict.tests) {
    if (!test.finding.asked.empty()) text += failure_text(test, test.finding, style);
  }
  if (verdict.outcome == Outcome::failed) text += warnings_text(verdict, style);
  text += output_text(verdict.output, style);
  return text + "\n" + summary(verdict, style);
}

}  // namespace contact::cli
