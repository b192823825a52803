#include "again.hpp"

#include <algorithm>

namespace contact::grading {

namespace {

constexpr std::size_t times_for_inputs = 2;
constexpr int times_for_smaller = 3;
constexpr int times_for_hint = 4;

}  // namespace

std::optional<Again> failed_again(const ProgressRecord& before, const Verdict& verdict) {
  const TestVerdict* test = first_failure(verdict);
  if (test == nullptr || verdict.code.empty()) return {};
  std::vector<std::string> codes = before.of(verdict.exercise).failed_with(test->name);
  if (std::find(codes.begin(), codes.end(), verdict.code) == codes.end())
    codes.push_back(verdict.code);
  if (codes.size() < times_for_inputs) return {};
  const int times = static_cast<int>(codes.size());
  const std::string look = test->status != TestStatus::failed ? ""
                           : times < times_for_smaller        ? "inputs"
                                                              : "smaller";
  return Again{test->name, times, look};
}

void add_next_hint(const Exercise& exercise, const ProgressRecord& before, Verdict& verdict) {
  const std::optional<Again> again = failed_again(before, verdict);
  if (!again || again->times < times_for_hint) return;
  const ExerciseProgress known = before.of(verdict.exercise);
  const std::vector<std::string> codes = known.failed_with(again->test);
  const bool same_code = std::find(codes.begin(), codes.end(), verdict.code) != codes.end();
  const int number = known.hints_shown + (same_code ? 0 : 1);
  if (number < 1 || number > static_cast<int>(exercise.hints.size())) return;
  for (TestVerdict& test : verdict.tests) {
    if (test.name != again->test) continue;
    if (!test.look) test.look.emplace();
    test.look->hint_number = number;
    test.look->hint = exercise.hints[static_cast<std::size_t>(number - 1)];
  }
}

}  // namespace contact::grading
