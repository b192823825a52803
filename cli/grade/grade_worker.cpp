// contact grade-worker: grades the units named on standard input, one per line, and prints a line
// of JSON when each is done. It is an internal command that `contact grade` starts.

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>
#include <optional>

#include <poll.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "../../grading/grade/intake_ids.hpp"
#include "../../grading/grade/run_state.hpp"
#include "../../grading/grade/sha256.hpp"
#include "../../grading/grade/unit_time.hpp"
#include "../../grading/grade/watchdog.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Exercise;
using grading::Job;

struct Options {
  std::string run_file;
  std::string temporary;
  std::string machine;
  int parent = 0;
};

// A coordinator that is killed takes its workers with it: they get the time to end their boxes.
void end_with(int parent) {
  if (parent == 0) return;
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  if (::getppid() != parent) throw grading::Interrupted{};
}

// Lines of standard input; a signal ends the wait.
class Orders {
 public:
  explicit Orders(grading::Loop& loop) : loop_(loop) {}

  std::optional<std::string> next() {
    while (true) {
      const std::size_t end = text_.find('\n');
      if (end == std::string::npos) {
        if (ended_) return {};
        read();
        continue;
      }
      const std::string line = text_.substr(0, end);
      text_.erase(0, end + 1);
      if (!line.empty()) return line;
    }
  }

 private:
  void read() {
    pollfd input{0, POLLIN, 0};
    loop_.poll();
    // No signal is missed for longer than this, whenever it comes.
    constexpr int milliseconds = 100;
    if (::poll(&input, 1, milliseconds) <= 0) return;
    std::array<char, 4096> part{};
    const ssize_t count = ::read(0, part.data(), part.size());
    if (count > 0) text_.append(part.data(), static_cast<std::size_t>(count));
    if (count == 0) {
      ended_ = true;
      text_ += '\n';
    }
    if (count < 0 && errno != EINTR) throw grading::BookError("standard input cannot be read");
  }

  grading::Loop& loop_;
  std::string text_;
  bool ended_ = false;
};

// The folder for this worker's boxes goes with it, whatever ends it.
class OwnTemporary {
 public:
  explicit OwnTemporary(std::string path) : path_(std::move(path)) {}
  ~OwnTemporary() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  OwnTemporary(const OwnTemporary&) = delete;
  OwnTemporary& operator=(const OwnTemporary&) = delete;
  void use() const {
    if (!path_.empty()) ::setenv("TMPDIR", path_.c_str(), 1);
  }

 private:
  std::string path_;
};

grading::Machine machine_from(grading::Loop& loop, const std::string& file) {
  if (file.empty()) return grading::examine_machine(loop);
  return grading::machine_from_coordinator(nlohmann::json::parse(grading::read_text(file)));
}

std::string line_of(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

// Prints a line prepared in advance and ends this process at once, because a hanging thread may
// hold any lock. Its sandboxes end with it, and the process that started it removes its folder.
[[noreturn]] void end_out_of_time(const std::string& line) {
  if (::write(STDOUT_FILENO, line.data(), line.size()) < 0) {
    // The reader is gone; it notices the end of this process anyway.
  }
  ::_exit(exit_trouble);
}

// The book with which a pack is graded.
std::shared_ptr<const grading::Book> base_of(const grading::Run& run) {
  if (run.book_root == run.root) return nullptr;
  return std::make_shared<grading::Book>(run.book_root, run.book_root / "work");
}

class Worker {
 public:
  Worker(grading::Loop& loop, const grading::Run& run, const std::string& machine)
      : loop_(loop),
        run_(run),
        folder_(run.results),
        book_(run.root, run.root / "work", base_of(run)),
        build_(grading::read_build_description(run.build)),
        machine_(machine_from(loop, machine)),
        seat_(machine_),
        watchdog_(end_out_of_time) {
    if (machine_.level == grading::Level::none && !run.accept_weak)
      throw grading::BookError(
          "this machine cannot isolate a submission; `contact doctor` says "
          "what is missing");
  }

  // Reports say what the weakest of all machines that graded could not enforce.
  nlohmann::json ready() const {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    const fs::path file = folder_.grade() / "machines" / (grading::safe_id(host.data()) + ".json");
    fs::create_directories(file.parent_path());
    grading::write_text(file, grading::to_json(machine_).dump(1) + "\n");
    return {{"event", "ready"}, {"level", grading::words(machine_.level)}};
  }

  nlohmann::json grade(const Job& job) {
    folder_.log("start", job);
    nlohmann::json said = {{"submission", job.submission}, {"exercise", job.exercise}};
    try {
      const grading::Watchdog::Watch watch(watchdog_, run_.unit_seconds.at(job.exercise),
                                           out_of_time(job));
      const grading::Unit unit = graded(job);
      folder_.write_unit(unit);
      said["event"] = "finished";
      said["points"] = unit.verdict.at("points");
      said["near_limit"] = unit.near_limit;
      said["seconds"] = unit.seconds;
      folder_.log("finish", job);
    } catch (const grading::Interrupted&) {
      throw;
    } catch (const std::bad_alloc&) {
      trouble(said, "the grader itself ran out of memory", job);
    } catch (const std::exception& error) {
      trouble(said, error.what(), job);
    } catch (...) {
      trouble(said, "the grader failed without a message", job);
    }
    return said;
  }

 private:
  void trouble(nlohmann::json& said, const std::string& what, const Job& job) const {
    said["event"] = "trouble";
    said["what"] = what;
    folder_.log("trouble", job);
  }

  // The message for a unit that exceeds its time, prepared in advance, because later the process
  // may hang.
  [[nodiscard]] std::string out_of_time(const Job& job) const {
    return line_of({{"event", "trouble"},
                    {"submission", job.submission},
                    {"exercise", job.exercise},
                    {"what", grading::out_of_time_words(run_.unit_seconds.at(job.exercise))},
                    {"out_of_time", true}});
  }

  grading::Unit graded(const Job& job) {
    const Exercise& own = book_.exercise(job.exercise);
    const Exercise exercise = grading::with_private_tests(own, run_.private_tests);
    const std::string text = grading::read_text(folder_.text_file(job));
    grading::UnitSettings settings;
    settings.seed = run_.seed;
    settings.limits = run_.limits;
    settings.test_cpu_seconds = run_.test_seconds.at(job.exercise);
    if (const grading::PrivateExercise* more = run_.private_tests.of(job.exercise))
      settings.more_tests.push_back(more->program);
    const grading::UnitResult result =
        grading::grade_unit(loop_, book_, build_, machine_, seat_, exercise, text, settings);

    grading::Unit unit;
    unit.submission = job.submission;
    unit.exercise = job.exercise;
    unit.key = run_.keys.at(job.exercise);
    unit.key.code = grading::sha256(text);
    unit.gradable = result.verdict.outcome != grading::Outcome::does_not_compile;
    unit.near_limit = result.near_limit;
    unit.reruns = job.alone ? 1 : 0;
    unit.seconds = result.seconds;
    unit.verdict = grading::verdict_without_times(grading::to_json(result.verdict));
    return unit;
  }

  grading::Loop& loop_;
  const grading::Run& run_;
  grading::RunFolder folder_;
  grading::Book book_;
  grading::BuildDescription build_;
  grading::Machine machine_;
  grading::Seat seat_;
  grading::Watchdog watchdog_;
};

int run(Context& context, const Options& options) {
  const OwnTemporary temporary(options.temporary);
  end_with(options.parent);
  const grading::Run run = grading::read_run(options.run_file);
  Worker worker(context.loop(), run, options.machine);
  // After the seat is taken, whose lock lies where all programs of this machine look for it.
  temporary.use();
  const auto tell = [](const nlohmann::json& json) {
    std::string line = line_of(json);
    line.pop_back();
    say(line);
  };
  tell(worker.ready());
  Orders orders(context.loop());
  while (const std::optional<std::string> line = orders.next())
    tell(worker.grade(grading::job_from_order(*line)));
  return exit_passed;
}

}  // namespace

void add_grade_worker(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = app.add_subcommand(grade_worker_command);
  command.hide();
  command.add_option("run", options->run_file, "RUN.json").required();
  command.add_option("--temporary", options->temporary,
                     "A folder for its sandboxes, which it removes at its end");
  command.add_option("--machine", options->machine,
                     "What the coordinator found out about this machine; tried if not given");
  command.add_option("--parent", options->parent, "The process whose end is its end");
  command.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
