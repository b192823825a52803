#include "run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>

#include "../progress/again.hpp"
#include "patience.hpp"
#include "run_turns.hpp"
#include "stop_words.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

// Stops a test that has used its processor time, or that takes too long on the clock.
class TimeLimit {
 public:
  TimeLimit(const EventReader& reader, const Patience& patience)
      : reader_(reader), patience_(patience) {}

  Ended operator()(int pid) {
    const double used = processor_seconds(pid);
    if (reader_.started().size() != seen_) {
      seen_ = reader_.started().size();
      used_before_ = std::max(used, 0.0);
      start_ = Clock::now();
    }
    elapsed_ = std::chrono::duration<double>(Clock::now() - start_).count();
    const TestTime may_take = patience_.of(reader_.current());
    seconds_ = may_take.processor;
    const double worked = used - used_before_;
    if (used >= 0.0 ? worked > may_take.processor : elapsed_ > may_take.processor + 1.0)
      return Ended::time;
    if (elapsed_ <= may_take.elapsed) return Ended::by_itself;
    seconds_ = may_take.elapsed;
    return worked < 0.1 * elapsed_ ? Ended::idle : Ended::time;
  }

  /// Of the test that runs, on the clock.
  [[nodiscard]] double elapsed() const { return elapsed_; }
  /// The limit that it met.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  const EventReader& reader_;
  const Patience& patience_;
  double seconds_ = 0.0;
  double elapsed_ = 0.0;
  std::size_t seen_ = 0;
  double used_before_ = 0.0;
  Clock::time_point start_ = Clock::now();
};

// These tests, or all if there are none, in one process.
Turn run_once(Loop& loop, const fs::path& program, const std::vector<std::string>& names,
              const Limits& limits, const Environment& environment, Patience& patience,
              std::string& output) {
  const fs::path folder = program.parent_path();
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
  TimeLimit limit(turn.reader, patience);
  spec.watchdog = [&](int pid) { return limit(pid); };
  spec.grace = 0.3;
  const ProcessResult process = run_process(loop, spec);
  if (output.size() < limits.output_bytes) output += process.output + errors_not_told(process);
  turn.died = !turn.reader.done() || process.signal != 0 || process.ended != Ended::by_itself;
  turn.knows_better = process.signal != 0;
  turn.why = why_stopped(process, limit.seconds());
  if (process.ended == Ended::time || process.ended == Ended::idle) {
    turn.why += patience.less_time();
    patience.ran_out(limit.elapsed());
    turn.enough = patience.enough();
  }
  return turn;
}

struct BuiltFile {
  std::vector<std::string> warnings;
  std::vector<Remark> remarks;
  std::optional<CompileError> error;
  fs::path program;
  Seconds seconds;
};

BuiltFile build_file(Loop& loop, const Book& book, const BuildDescription& build,
                     const Exercise& exercise, const fs::path& source, const fs::path& folder,
                     const std::vector<std::string>& more_include) {
  const CompiledFile compiled = compile(loop, book, build, exercise, source, folder, more_include);
  BuiltFile built;
  built.warnings = compiled.said.warnings;
  built.remarks = compiled.said.remarks;
  built.error = compiled.said.error;
  built.seconds.compile = compiled.seconds;
  if (built.error) return built;
  const LinkedProgram linked = link(loop, book, build, exercise, source, compiled.object, folder);
  built.seconds.link = linked.seconds;
  built.program = linked.program;
  built.error = linked.said.error;
  if (built.error)
    built.remarks.insert(built.remarks.begin(), linked.said.remarks.begin(),
                         linked.said.remarks.end());
  return built;
}

Verdict completed(Verdict verdict, const BuiltFile& built, const fs::path& source) {
  verdict.file = source.string();
  verdict.warnings = built.warnings;
  verdict.remarks = built.remarks;
  verdict.seconds.compile = built.seconds.compile;
  verdict.seconds.link = built.seconds.link;
  return verdict;
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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
  Patience patience(exercise);
  return run_in_turns(exercise, [&](const std::vector<std::string>& names) {
    return run_once(loop, program, names, limits, environment, patience, output);
  });
}

std::vector<Verdict> check_file_in_each(Loop& loop, const Book& book, const BuildDescription& build,
                                        const Exercise& exercise, const fs::path& source,
                                        const Limits& limits,
                                        const std::vector<std::string>& more_include,
                                        const std::vector<Environment>& environments) {
  const TemporaryFolder folder;
  const BuiltFile built =
      build_file(loop, book, build, exercise, source, folder.path(), more_include);
  std::vector<Verdict> verdicts;
  for (const Environment& environment : environments) {
    Verdict verdict;
    if (built.error) {
      verdict = judge_uncompiled(exercise, *built.error);
    } else {
      std::string output;
      const Clock::time_point start = Clock::now();
      verdict = judge(exercise, book,
                      run_tests(loop, exercise, built.program, limits, environment, output));
      verdict.seconds.run = seconds_since(start);
      verdict.output = std::move(output);
    }
    verdicts.push_back(completed(std::move(verdict), built, source));
  }
  return verdicts;
}

Verdict check_file(Loop& loop, const Book& book, const BuildDescription& build,
                   const Exercise& exercise, const fs::path& source, const Limits& limits,
                   const ProgressRecord& before) {
  const TemporaryFolder folder;
  const std::string code = code_of(read_text(source));
  const BuiltFile built = build_file(loop, book, build, exercise, source, folder.path(), {});
  if (built.error) return completed(judge_uncompiled(exercise, *built.error), built, source);
  std::string output;
  const Clock::time_point start = Clock::now();
  std::vector<TestResult> results = run_tests(loop, exercise, built.program, limits, {}, output);
  Verdict verdict = judge(exercise, book, results);
  verdict.code = code;
  const std::optional<Again> again = failed_again(before, verdict);
  if (again && !again->look.empty()) {
    Patience patience(exercise);
    std::string not_told_twice;
    const Turn turn = run_once(loop, built.program, {again->test}, limits,
                               {{"CONTACT_LOOK", again->look}}, patience, not_told_twice);
    for (TestVerdict& test : verdict.tests) {
      if (test.name == again->test && test.visibility == Visibility::shown)
        test.look = turn.reader.look();
    }
  }
  add_next_hint(exercise, before, verdict);
  verdict.seconds.run = seconds_since(start);
  verdict.output = std::move(output);
  return completed(std::move(verdict), built, source);
}

}  // namespace contact::grading
