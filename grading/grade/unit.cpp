#include "unit.hpp"

#include <algorithm>
#include <chrono>

#include "../run/run_turns.hpp"
#include "../run/stop_words.hpp"
#include "broker.hpp"
#include "unit_compile.hpp"
#include "unit_time.hpp"

namespace fs = std::filesystem;

namespace contact::grading {

namespace {

using Clock = std::chrono::steady_clock;

// The judge runs what the book and the instructor wrote; these only end it if an answer leads it
// astray.
constexpr int kJudgeMemory = 1024;
constexpr double kJudgeSecondsATest = 10.0;
constexpr std::size_t kJudgeEvents = 32u << 20;

BoxSpec answer_box(const fs::path& program, const UnitSettings& settings) {
  const GradeLimits& limits = settings.limits;
  BoxSpec spec;
  spec.kind = BoxKind::answer;
  spec.command = {"/answer"};
  spec.read_only = {{program, "/answer"}};
  // The broker ends it to the millisecond; this is for when it cannot.
  spec.limits.cpu_seconds = settings.test_cpu_seconds + 1.0;
  spec.limits.wall_seconds = test_wall_seconds(settings);
  spec.limits.memory_mb = limits.memory_mb;
  spec.limits.processes = limits.processes;
  spec.limits.output_bytes = limits.output_bytes;
  spec.limits.files_mb = limits.files_mb;
  spec.limits.files = limits.files;
  return spec;
}

BoxSpec judge_box(const fs::path& tests, const Exercise& exercise, const UnitSettings& settings,
                  const std::vector<std::string>& names, double seconds, int broker) {
  BoxSpec spec;
  spec.kind = BoxKind::judge;
  spec.command = {"/tests", "-r", "contact"};
  for (const std::string& name : names)
    spec.command.push_back("\"" + escaped_test_name(name) + "\",");
  spec.read_only = {{tests, "/tests"}};
  spec.environment = {{"CONTACT_BROKER", "3"},
                      {"CONTACT_ANSWER_BYTES", std::to_string(settings.limits.answer_bytes)},
                      {"CONTACT_CALLS", std::to_string(settings.limits.calls)}};
  if (!settings.seed.empty()) spec.environment.emplace_back("CONTACT_SEED", settings.seed);
  spec.descriptors = {{broker, 3}};
  const auto tests_in_it = static_cast<double>(exercise.tests.size());
  spec.limits.cpu_seconds = kJudgeSecondsATest * tests_in_it;
  spec.limits.wall_seconds = seconds;
  spec.limits.memory_mb = kJudgeMemory;
  spec.limits.processes = 1;
  spec.limits.output_bytes = kJudgeEvents;
  spec.limits.files = 0;
  return spec;
}

// Grades one program of tests after another and remembers what the submission used and printed.
class Judging {
 public:
  Judging(Loop& loop, const Machine& machine, const Seat& seat, const Exercise& exercise,
          const fs::path& program, const UnitSettings& settings)
      : loop_(loop),
        machine_(machine),
        seat_(seat),
        exercise_(exercise),
        settings_(settings),
        answer_(answer_box(program, settings)),
        answer_time_{settings.test_cpu_seconds, settings.limits.idle_seconds,
                     settings.limits.idle_seconds_in_all},
        time_(exercise, settings) {}

  void run(const fs::path& tests) {
    time_ = JudgingTime(exercise_, settings_);
    std::vector<TestResult> results = run_in_turns(
        exercise_, [&](const std::vector<std::string>& names) { return turn(tests, names); });
    for (TestResult& result : results) results_.push_back(std::move(result));
  }

  [[nodiscard]] const std::vector<TestResult>& results() const { return results_; }
  [[nodiscard]] std::string& output() { return output_; }
  [[nodiscard]] bool near_limit() const { return near_limit_; }

 private:
  Turn turn(const fs::path& tests, const std::vector<std::string>& names) {
    Broker broker(loop_, machine_, seat_, answer_, answer_time_);
    Box judge(loop_, machine_, seat_,
              judge_box(tests, exercise_, settings_, names, time_.next(), broker.judge_end()));
    broker.let_go_of_judge_end();
    while (!judge.ended()) {
      loop_.run_once();
      broker.serve(judge);
    }
    const BoxEnd end = judge.wait();
    time_.spend(end.process.seconds);
    Turn turn;
    turn.reader.feed(end.process.output);
    turn.died =
        !turn.reader.done() || end.process.signal != 0 || end.process.ended != Ended::by_itself;
    turn.knows_better = true;
    turn.why = "the tests could not go on with what it answered (" + judge_end(end) + ")";
    if (turn.died && turn.reader.started().empty())
      throw BookError("the tests of " + exercise_.id() +
                      " do not start in their box: " + judge_end(end) + end.process.errors);
    near_limit_ = near_limit_ || turn.died;
    remember(broker.finish(), turn.reader);
    return turn;
  }

  static std::string judge_end(const BoxEnd& end) {
    if (end.process.ended == Ended::time) return "they ran out of time";
    if (end.process.ended == Ended::output) return "they had too much to say";
    if (end.out_of_memory) return "they ran out of memory";
    if (end.process.signal != 0) return "signal " + std::to_string(end.process.signal);
    return "exit code " + std::to_string(end.process.exit_code);
  }

  // The output is measured when it is complete: whether it was too long, and the report on it, must
  // not depend on the time of reading.
  void keep_output(const ProcessResult& process, TestResult* result) {
    const std::size_t most = settings_.limits.output_bytes;
    if (process.bytes_printed > most) {
      output_ += "(more than " + std::to_string(most) + " bytes in one test, which are not kept)\n";
      if (result != nullptr) {
        result->status = TestStatus::stopped;
        result->failure = Failure{};
        result->failure.reason = printed_too_much;
      }
      return;
    }
    for (const std::string& text : {process.output, errors_not_told(process)})
      output_ += text.substr(0, most - std::min(output_.size(), most));
  }

  void remember(const std::vector<Answered>& answered, EventReader& reader) {
    for (TestResult& result : reader.results()) result.seconds = 0.0;
    for (const Answered& one : answered) {
      const ProcessResult& process = one.end.process;
      // That it was idle is believed at once: no neighbour can make it sleep.
      near_limit_ = near_limit_ || one.end.out_of_memory || process.ended == Ended::time ||
                    one.end.cpu_seconds > settings_.test_cpu_seconds / 2;
      TestResult* const asked = result_of(one, reader);
      keep_output(process, asked);
      if (asked != nullptr) asked->seconds += one.end.cpu_seconds;
    }
  }

  static TestResult* result_of(const Answered& answered, EventReader& reader) {
    if (answered.test == 0 || answered.test > reader.started().size()) return nullptr;
    const std::string& name = reader.started()[answered.test - 1];
    for (TestResult& result : reader.results()) {
      if (result.name == name) return &result;
    }
    return nullptr;
  }

  Loop& loop_;
  const Machine& machine_;
  const Seat& seat_;
  const Exercise& exercise_;
  const UnitSettings& settings_;
  const BoxSpec answer_;
  AnswerTime answer_time_;
  JudgingTime time_;
  std::vector<TestResult> results_;
  std::string output_;
  bool near_limit_ = false;
};

// It could not have what it asked for: perhaps only because others had it.
bool lacked_something(const TestVerdict& test) {
  const std::string& reason = test.failure.reason;
  return test.status == TestStatus::stopped &&
         (reason.starts_with("ran out of memory") ||
          reason.find("Resource temporarily unavailable") != std::string::npos);
}

}  // namespace

UnitResult grade_unit(Loop& loop, const Book& book, const BuildDescription& build,
                      const Machine& machine, const Seat& seat, const Exercise& exercise,
                      std::string_view text, const UnitSettings& settings) {
  const Clock::time_point start = Clock::now();
  const TemporaryFolder folder;
  const fs::path file = fs::path(exercise.chapter) / (exercise.name + ".cpp");
  fs::create_directories(folder.path() / exercise.chapter);
  write_text(folder.path() / file, std::string(text));
  for (const fs::path& path :
       {folder.path(), folder.path() / exercise.chapter, folder.path() / file})
    seat.give(path);

  UnitResult unit;
  CompiledUnit compiled = compile_unit(loop, book, build, machine, seat, exercise, file, text,
                                       folder.path(), settings.limits);
  unit.near_limit = compiled.near_limit;
  const Clock::time_point run_start = Clock::now();
  if (compiled.said.error) {
    unit.verdict = judge_uncompiled(exercise, std::move(*compiled.said.error));
  } else {
    Judging judging(loop, machine, seat, exercise, compiled.program, settings);
    judging.run(build.exercises.at(exercise.id()).asks);
    for (const fs::path& more : settings.more_tests) judging.run(more);
    // results.json is the instructor's; the reports withhold what a student may not see.
    unit.verdict = judge(exercise, book, judging.results(), Reader::instructor);
    unit.verdict.output = std::move(judging.output());
    unit.near_limit = unit.near_limit || judging.near_limit();
    compiled.seconds.run = std::chrono::duration<double>(Clock::now() - run_start).count();
  }
  unit.verdict.file = file.string();
  unit.verdict.warnings = std::move(compiled.said.warnings);
  unit.verdict.remarks = std::move(compiled.said.remarks);
  unit.verdict.seconds = compiled.seconds;
  for (const TestVerdict& test : unit.verdict.tests) {
    unit.slowest_test = std::max(unit.slowest_test, test.seconds);
    unit.near_limit = unit.near_limit || lacked_something(test);
  }
  unit.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return unit;
}

}  // namespace contact::grading
