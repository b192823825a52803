#include "run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <set>

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

std::string text_at(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Follows the event stream of one process and knows which test is running.
class EventReader {
 public:
  void feed(std::string_view text) {
    buffer_ += text;
    for (std::size_t end = buffer_.find('\n'); end != std::string::npos; end = buffer_.find('\n')) {
      event(buffer_.substr(0, end));
      buffer_.erase(0, end + 1);
    }
  }

  [[nodiscard]] bool running() const { return !current_.empty(); }
  [[nodiscard]] const std::string& current() const { return current_; }
  [[nodiscard]] bool done() const { return done_; }
  [[nodiscard]] int starts() const { return starts_; }
  [[nodiscard]] Clock::time_point started() const { return started_; }
  [[nodiscard]] std::vector<TestResult>& results() { return results_; }

 private:
  void event(const std::string& line) {
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object()) return;
    const std::string kind = text_at(json, "event");
    if (kind == "start") {
      current_ = text_at(json, "test");
      started_ = Clock::now();
      ++starts_;
    } else if (kind == "end") {
      TestResult result = result_from_json(json);
      result.name = text_at(json, "test");
      results_.push_back(std::move(result));
      current_.clear();
    } else if (kind == "done") {
      done_ = true;
    }
  }

  std::string buffer_;
  std::string current_;
  bool done_ = false;
  int starts_ = 0;
  Clock::time_point started_;
  std::vector<TestResult> results_;
};

// Time is the processor's, so that a busy machine fails nobody; a test that sleeps or waits meets
// the wall clock later.
class TimeLimit {
 public:
  TimeLimit(const EventReader& reader, double seconds) : reader_(reader), seconds_(seconds) {}

  Ended operator()(int pid) {
    const double used = processor_seconds(pid);
    if (reader_.starts() != seen_) {
      seen_ = reader_.starts();
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
  int seen_ = 0;
  double used_before_ = 0.0;
  Clock::time_point start_ = Clock::now();
};

// An assertion's own sentence is worth more than the name of its signal.
std::string assertion_in(const std::string& printed) {
  if (const std::size_t at = printed.rfind("terminate called"); at != std::string::npos) {
    std::string text = printed.substr(at, 600);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }
  std::size_t at = printed.rfind("Assertion `");
  if (at == std::string::npos) at = printed.rfind("Assertion '");
  if (at == std::string::npos) return {};
  const std::size_t start =
      printed.rfind('\n', at) == std::string::npos ? 0 : printed.rfind('\n', at) + 1;
  const std::string before = printed.substr(start, at - start);
  std::string sentence =
      printed.substr(at, std::min<std::size_t>(printed.find('\n', at) - at, 400));
  // Most assertions that a student meets are a library's own, about an index or an empty container.
  if (before.find("/Eigen/") != std::string::npos)
    return "Eigen found a wrong index or size: " + sentence;
  if (before.find("/c++/") != std::string::npos)
    return "the standard library found a wrong index or an empty container: " + sentence;
  return sentence;
}

// What a program printed, without the line that already stands in the reason.
std::string without_assertion(const std::string& printed) {
  std::string result;
  std::size_t at = 0;
  while (at < printed.size()) {
    const std::size_t end = std::min(printed.find('\n', at), printed.size() - 1) + 1;
    const std::string line = printed.substr(at, end - at);
    if (line.find("Assertion `") == std::string::npos &&
        line.find("Assertion '") == std::string::npos)
      result += line;
    at = end;
  }
  return result;
}

std::string seconds_text(double seconds) {
  const std::string text = points_text(seconds);
  return text + (text == "1" ? " second" : " seconds");
}

std::string why_stopped(const ProcessResult& process, const Exercise& exercise) {
  switch (process.ended) {
    case Ended::time:
      return "no answer after " + seconds_text(exercise.time_limit) +
             ": an endless loop, or far too much work";
    case Ended::output:
      return "it printed without end and was stopped";
    case Ended::by_itself:
      break;
  }
  if (process.signal != 0) return signal_in_words(process.signal, process.errors);
  return "the program ended by itself (exit code " + std::to_string(process.exit_code) +
         "): does your code call exit()?";
}

// Catch2 may say "SIGSEGV - ..." itself before the process dies; our words then replace its own.
void put_in_words(TestResult& result, const std::string& reason) {
  result.status = TestStatus::stopped;
  result.failure.got.clear();
  result.failure.right.clear();
  result.failure.allowed.clear();
  result.failure.reason = reason;
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

std::string escaped_test_name(const std::string& name) {
  std::string result;
  for (const char c : name) {
    if (std::string_view(",[]*\"\\~").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string signal_in_words(int signal, const std::string& printed) {
  const std::string assertion = assertion_in(printed);
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      return "segmentation fault: it touched memory that is not its own (an index out of range, an "
             "empty optional or "
             "container, or a function that calls itself without end)";
    case SIGABRT:
      return assertion.empty()
                 ? "aborted: it called abort(), or an exception left a noexcept function"
                 : "aborted: " + assertion;
    case SIGFPE:
      return "arithmetic fault: an integer was divided by zero";
    case SIGILL:
    case SIGTRAP:
      return "illegal instruction: often the end of a function that promises a value and returns "
             "none";
    case SIGKILL:
      return "killed by the system: out of memory?";
    default:
      return std::string("ended by signal ") + std::to_string(signal) + " (" + ::strsignal(signal) +
             ")";
  }
}

std::vector<TestResult> run_tests(Loop& loop, const Exercise& exercise, const fs::path& program,
                                  const Limits& limits, std::string& output) {
  std::vector<TestResult> results;
  std::set<std::string> finished;
  const auto take = [&](TestResult result) {
    if (finished.insert(result.name).second) results.push_back(std::move(result));
  };
  const fs::path folder = program.parent_path();
  // Each turn settles at least one test, or ends.
  for (std::size_t turn = 0; turn <= exercise.tests.size(); ++turn) {
    ProcessSpec spec;
    spec.command = {program.string(), "-r", "contact::out=/dev/fd/3"};
    if (turn > 0) {
      std::string names;
      for (const TestSpec& test : exercise.tests) {
        if (finished.count(test.name) == 0) names += "\"" + escaped_test_name(test.name) + "\"\n";
      }
      if (names.empty()) break;
      write_text(folder / "remaining", names);
      spec.command.insert(spec.command.end(), {"--input-file", (folder / "remaining").string()});
    }
    spec.folder = folder;
    spec.environment = {{"CONTACT_MEMORY_MB", std::to_string(limits.memory_mb)}};
    spec.output_limit = limits.output_bytes;
    spec.output_stop = limits.output_bytes;
    EventReader reader;
    spec.on_events = [&](std::string_view text) { reader.feed(text); };
    spec.watchdog = TimeLimit(reader, exercise.time_limit);
    spec.grace = 0.3;
    const ProcessResult process = run_process(loop, spec);
    if (output.size() < limits.output_bytes)
      output += process.output +
                (process.signal == SIGABRT ? without_assertion(process.errors) : process.errors);

    std::vector<TestResult>& seen = reader.results();
    // After a crash Catch2 still says how the test ended and that all is done, then lets the signal
    // through.
    const bool died = !reader.done() || process.signal != 0 || process.ended != Ended::by_itself;
    if (died && !reader.running() && !seen.empty() && seen.back().status == TestStatus::stopped &&
        (process.signal != 0 || seen.back().failure.reason.empty()))
      put_in_words(seen.back(), why_stopped(process, exercise));
    for (TestResult& result : seen) take(std::move(result));
    if (!died) break;
    if (reader.running()) {
      TestResult result;
      result.name = reader.current();
      result.seconds = std::chrono::duration<double>(Clock::now() - reader.started()).count();
      put_in_words(result, why_stopped(process, exercise));
      take(std::move(result));
    } else if (seen.empty()) {
      // It died before any test began (a constructor of a global, say): every test left has the
      // same end.
      for (const TestSpec& test : exercise.tests) {
        TestResult result;
        result.name = test.name;
        put_in_words(result, "before the test began: " + why_stopped(process, exercise));
        take(std::move(result));
      }
      break;
    }
  }
  return results;
}

Verdict check_file(Loop& loop, const Book& book, const BuildDescription& build,
                   const Exercise& exercise, const fs::path& source, const Limits& limits,
                   const std::vector<std::string>& more_include) {
  const TemporaryFolder folder;
  const CompiledFile compiled =
      compile(loop, book, build, exercise, source, folder.path(), more_include);
  Verdict verdict;
  Seconds seconds;
  seconds.compile = compiled.seconds;
  std::vector<Remark> remarks = compiled.said.remarks;
  if (compiled.said.error) {
    verdict = judge_uncompiled(exercise, *compiled.said.error);
  } else {
    const LinkedProgram linked =
        link(loop, book, build, exercise, source, compiled.object, folder.path());
    seconds.link = linked.seconds;
    if (linked.said.error) {
      verdict = judge_uncompiled(exercise, *linked.said.error);
      remarks.insert(remarks.begin(), linked.said.remarks.begin(), linked.said.remarks.end());
    } else {
      std::string output;
      const Clock::time_point start = Clock::now();
      const std::vector<TestResult> results =
          run_tests(loop, exercise, linked.program, limits, output);
      seconds.run = std::chrono::duration<double>(Clock::now() - start).count();
      verdict = judge(exercise, book, results);
      verdict.output = std::move(output);
    }
  }
  verdict.file = source.string();
  verdict.warnings = compiled.said.warnings;
  verdict.remarks = std::move(remarks);
  verdict.seconds = seconds;
  return verdict;
}

}  // namespace contact::grading
