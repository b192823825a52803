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

void inputs_text(std::string& text, const grading::CloserLook::Inputs& inputs, const Style& style) {
  std::size_t width = 0;
  for (const auto& [name, value] : inputs) width = std::max(width, name.size());
  bool first = true;
  for (const auto& [name, value] : inputs) {
    text += "    " + style.dim(padded(first ? "input" : "", label_width)) + padded(name, width) +
            " = " + printable(value) + "\n";
    first = false;
  }
}

void answer_text(std::string& text, const Failure& failure, const Style& style,
                 std::string_view reason = "stopped") {
  inputs_text(text, failure.inputs, style);
  labelled(text, "got", printable(failure.got), style);
  labelled(text, "right", failure.right, style);
  labelled(text, "allowed", failure.allowed, style);
  labelled(text, reason, printable(failure.reason), style);
  labelled(text, "hint", failure.hint, style);
  if (!failure.questions.empty()) {
    labelled(text, "hint", "Several mistakes give this answer. Is one of them in your code?",
             style);
    for (const std::string& question : failure.questions)
      labelled(text, "", "- " + question, style);
  }
}

// The inputs of a question in one line, cut where it would be long.
std::string in_one_line(const grading::CloserLook::Inputs& inputs) {
  constexpr std::size_t most = 240;
  std::string text;
  for (const auto& [name, value] : inputs)
    text += (text.empty() ? "" : ", ") + name + " = " + printable(value);
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

// What is said of a test that has failed before with other code.
std::string look_text(const grading::CloserLook& look, const Style& style) {
  std::string text;
  const int asked = look.right + look.wrong;
  if (asked > 0)
    text += "\n" +
            wrapped("Of " + std::to_string(asked) + (asked == 1 ? " question" : " questions") +
                        " in this test, your code answers " + std::to_string(look.right) +
                        " right and " + std::to_string(look.wrong) + " wrong.",
                    4) +
            "\n";
  const auto lines = [&](const char* what, const std::vector<grading::CloserLook::Inputs>& list) {
    if (list.empty()) return;
    text += "    " + style.dim(what) + "\n";
    for (const grading::CloserLook::Inputs& inputs : list)
      text += wrapped(in_one_line(inputs), 6) + "\n";
  };
  lines("right, for example, for (numbers to four digits)", look.right_inputs);
  lines("wrong, for example, for", look.wrong_inputs);
  if (look.smaller) {
    text += "\n    With simpler inputs it is wrong too:\n";
    answer_text(text, *look.smaller, style);
  }
  if (look.hint_number > 0)
    text += "\n" + wrapped("Hint " + std::to_string(look.hint_number) + ": " + look.hint, 4) + "\n";
  return text;
}

// What a test that passed has to show.
std::string finding_text(const TestVerdict& test, const Style& style) {
  std::string text = "\n  " + style.bold(test.name) + "\n";
  labelled(text, "asked", test.finding.asked, style);
  answer_text(text, test.finding, style, "why");
  if (test.visibility == grading::Visibility::values_withheld)
    labelled(text, "note", "this test does not show its values", style);
  return text;
}

std::string failure_text(const Verdict& verdict, const TestVerdict& test, const Style& style) {
  std::string text = "\n  " + style.bold(test.name) + "\n";
  labelled(text, "asked", test.failure.asked, style);
  answer_text(text, test.failure, style, test.status == TestStatus::stopped ? "stopped" : "why");
  if (test.visibility == grading::Visibility::values_withheld)
    labelled(text, "note", "this test does not show its values", style);
  const std::vector<std::string> same = grading::same_mistake(verdict, test);
  if (!same.empty()) {
    std::string names;
    for (const std::string& name : same) names += (names.empty() ? "" : "; ") + name;
    text += wrapped("The same mistake also fails: " + names + ".", 4) + "\n";
  }
  if (test.look) text += look_text(*test.look, style);
  return text;
}

// Why tests were skipped, each reason once.
std::string skipped_text(const Verdict& verdict, const Style& style) {
  std::string text;
  std::vector<std::string> told;
  for (const TestVerdict& test : verdict.tests) {
    const std::string& reason = test.failure.reason;
    if (test.status != TestStatus::skipped ||
        std::find(told.begin(), told.end(), reason) != told.end())
      continue;
    told.push_back(reason);
    text += "\n" + style.dim(wrapped("skipped: " + reason, 2));
  }
  return text.empty() ? text : text + "\n";
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
    if (first || (options.all_failures && test.same_as.empty()))
      text += failure_text(verdict, test, style);
    first = false;
  }
  for (const TestVerdict& test : verdict.tests) {
    if (!test.finding.asked.empty()) text += finding_text(test, style);
  }
  text += skipped_text(verdict, style);
  if (verdict.outcome == Outcome::failed) text += warnings_text(verdict, style);
  text += output_text(verdict.output, style);
  return text + "\n" + summary(verdict, style);
}

}  // namespace contact::cli
