#include "run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>

#include "run_turns.hpp"
#include "stop_words.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

// The limit is on processor time, so that a busy machine fails no test; a test that sleeps or waits
// is stopped later by the limit on elapsed time.
class TimeLimit {
 public:
  TimeLimit(const EventReader& reader, double seconds) : reader_(reader), seconds_(seconds) {}

  Ended operator()(int pid) {
    const double used = processor_seconds(pid);
    if (reader_.started().size() != seen_) {
      seen_ = reader_.started().size();
      used_before_ = std::max(used, 0.0);
      start_ = Clock::now();
    }
    const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
    if (used >= 0.0 && used - used_before_ > seconds_) return Ended::time;
    return wall > (used < 0.0 ? 1.0 : 4.0) * seconds_ + 1.0 ? Ended::time : Ended::by_itself;
  }

 private:
  const EventReader& reader_;
  double seconds_;
  std::size_t seen_ = 0;
  double used_before_ = 0.0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

Limits limits_from_environment() {
  Limits limits;
  if (const char* text = std::getenv("CONTACT_MEMORY_MB"); text != nullptr && *text != '\0') {
    char* end = nullptr;
    const long value = std::strtol(text, &end, 10);
    if (*end != '\0' || value < 64 || value > 1'000'000)
      throw BookError("CONTACT_MEMORY_MB is '" + std::string(text) +
                      "'; it must be a number of megabytes, 64 or more");
    limits.memory_mb = static_cast<int>(value);
  }
  return limits;
}

std::vector<TestResult> run_tests(Loop& loop, const Exercise& exercise, const fs::path& program,
                                  const Limits& limits, const Environment& environment,
                                  std::string& output) {
  const fs::path folder = program.parent_path();
  return run_in_turns(exercise, [&](const std::vector<std::string>& names) {
    ProcessSpec spec;
    spec.command = {program.string(), "-r", "contact::out=/dev/fd/3"};
    if (!names.empty()) {
      std::string lines;
      for (const std::string& name : names) lines += "\"" + escaped_test_name(name) + "\"\n";
      write_text(folder / "remaining", lines);
      spec.command.insert(spec.command.end(), {"--input-file", (folder / "remaining").string()});
    }
    spec.folder = folder;
    spec.environment = environment;
    spec.environment.emplace_back("CONTACT_MEMORY_MB", std::to_string(limits.memory_mb));
    spec.output_limit = limits.output_bytes;
    spec.output_stop = limits.output_bytes;
    Turn turn;
    spec.on_events = [&](std::string_view text) { turn.reader.feed(text); };
    spec.watchdog = TimeLimit(turn.reader, exercise.time_limit);
    spec.grace = 0.3;
    const ProcessResult process = run_process(loop, spec);
    if (output.size() < limits.output_bytes) output += process.output + errors_not_told(process);
    turn.died = !turn.reader.done() || process.signal != 0 || process.ended != Ended::by_itself;
    turn.knows_better = process.signal != 0;
    turn.why = why_stopped(process, exercise.time_limit);
    return turn;
  });
}

std::vector<Verdict> check_file_in_each(Loop& loop, const Book& book, const BuildDescription& build,
                                        const Exercise& exercise, const fs::path& source,
                                        const Limits& limits,
                                        const std::vector<std::string>& more_include,
                                        const std::vector<Environment>& environments) {
  const TemporaryFolder folder;
  const CompiledFile compiled =
      compile(loop, book, build, exercise, source, folder.path(), more_include);
  std::vector<Remark> remarks = compiled.said.remarks;
  std::optional<CompileError> error = compiled.said.error;
  Seconds seconds;
  seconds.compile = compiled.seconds;
  LinkedProgram linked;
  if (!error) {
    linked = link(loop, book, build, exercise, source, compiled.object, folder.path());
    seconds.link = linked.seconds;
    error = linked.said.error;
    if (error)
      remarks.insert(remarks.begin(), linked.said.remarks.begin(), linked.said.remarks.end());
  }
  std::vector<Verdict> verdicts;
  for (const Environment& environment : environments) {
    Verdict verdict;
    if (error) {
      verdict = judge_uncompiled(exercise, *error);
    } else {
      std::string output;
      const Clock::time_point start = Clock::now();
      const std::vector<TestResult> results =
          run_tests(loop, exercise, linked.program, limits, environment, output);
      seconds.run = std::chrono::duration<double>(Clock::now() - start).count();
      verdict = judge(exercise, book, results);
      verdict.output = std::move(output);
    }
    verdict.file = source.string();
    verdict.warnings = compiled.said.warnings;
    verdict.remarks = remarks;
    verdict.seconds = seconds;
    verdicts.push_back(std::move(verdict));
  }
  return verdicts;
}

Verdict check_file(Loop& loop, const Book& book, const BuildDescription& build,
                   const Exercise& exercise, const fs::path& source, const Limits& limits) {
  return std::move(
      check_file_in_each(loop, book, build, exercise, source, limits, {}, {{}}).front());
}

}  // namespace contact::grading
