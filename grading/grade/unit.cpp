#include "unit.hpp"

#include <algorithm>
#include <chrono>

#include "../run_turns.hpp"
#include "../stop_words.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

UnitResult grade_unit(Loop& loop, const Book& book, const BuildDescription& build, const Machine&,
                      const Seat&, const Exercise& exercise, std::string_view text,
                      const UnitSettings& settings) {
  const Clock::time_point start = Clock::now();
  const TemporaryFolder folder;
  const fs::path name = fs::path(exercise.chapter) / (exercise.name + ".cpp");
  fs::create_directories(folder.path() / exercise.chapter);
  write_text(folder.path() / name, std::string(text));
  const Answer answer{name, SourceText(std::string(text))};
  UnitResult unit;
  Explained said;

  ProcessSpec compile;
  compile.command = compile_command(build, exercise, name, "answer.o");
  compile.folder = folder.path();
  compile.environment = compiler_environment();
  compile.time_limit = settings.limits.compile_cpu_seconds;
  ProcessResult result = run_process(loop, compile);
  said = compiler_said(result, build, exercise, answer);
  if (!said.error) {
    ProcessSpec link;
    link.command = server_link_command(build, exercise, "answer.o", "answer");
    link.folder = folder.path();
    link.environment = compiler_environment();
    result = run_process(loop, link);
    Explained linked = linker_said(result, exercise, answer);
    said.error = linked.error;
    said.remarks.insert(said.remarks.begin(), linked.remarks.begin(), linked.remarks.end());
  }
  if (said.error) {
    unit.verdict = judge_uncompiled(exercise, *said.error);
  } else {
    std::string output;
    const auto run = [&](const std::vector<std::string>& names) {
      ProcessSpec spec;
      spec.command = {build.exercises.at(exercise.id()).asks, "-r", "contact::out=/dev/fd/3"};
      for (const std::string& test : names)
        spec.command.push_back("\"" + escaped_test_name(test) + "\",");
      spec.environment = {{"CONTACT_SERVER", (folder.path() / "answer").string()},
                          {"CONTACT_SEED", settings.seed}};
      if (settings.seed.empty()) spec.environment.pop_back();
      Turn turn;
      spec.on_events = [&](std::string_view bytes) { turn.reader.feed(bytes); };
      const ProcessResult ended = run_process(loop, spec);
      output += ended.output + ended.errors;
      turn.died = !turn.reader.done() || ended.signal != 0;
      turn.why = why_stopped(ended, settings.test_cpu_seconds);
      return turn;
    };
    const std::vector<TestResult> results = run_in_turns(exercise, run);
    unit.verdict = judge(exercise, book, results);
    unit.verdict.output = std::move(output);
  }
  unit.verdict.file = name.string();
  unit.verdict.warnings = said.warnings;
  unit.verdict.remarks = said.remarks;
  unit.seconds = seconds_since(start);
  for (const TestVerdict& test : unit.verdict.tests)
    unit.slowest_test = std::max(unit.slowest_test, test.seconds);
  return unit;
}

}  // namespace contact::grading
