// contact dev check: proves of the whole tree that stubs, solutions, wrong answers and null answers
// get what they must.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../commands.hpp"
#include "../grade/dev_box.hpp"
#include "../terminal/terminal.hpp"
#include "dev_check.hpp"
#include "dev_mutants.hpp"
#include "dev_registry.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Exercise;

struct Options {
  std::vector<std::string> names;
  bool json = false;
  bool files_only = false;
  unsigned jobs = 0;
};

// One line that is written over and over, on a terminal only.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted) : on_(wanted && ::isatty(fileno(stderr)) == 1) {}
  ~ProgressLine() { show(""); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  void show(const std::string& text) {
    if (!on_) return;
    std::fprintf(stderr, "\r%s\r%s", padded("", last_).c_str(), text.c_str());
    std::fflush(stderr);
    last_ = display_width(text);
  }

 private:
  bool on_;
  std::size_t last_ = 0;
};

std::string target_of(const Exercise& exercise) {
  return "exercise_" + exercise.chapter + "_" + exercise.name;
}

// Builds whatever is not current, generated code too. If one exercise does not build, the others
// must still be checked.
void build_all(grading::Loop& loop, const grading::Book& book,
               std::vector<const Exercise*>& exercises, std::vector<DevResult>& results) {
  std::vector<std::string> targets;
  for (const Exercise* exercise : exercises) targets.push_back(target_of(*exercise));
  try {
    grading::build_target(loop, book, targets);
    return;
  } catch (const grading::BookError&) {
    // Said below, for those that it is true of.
  }
  std::vector<const Exercise*> usable;
  for (const Exercise* exercise : exercises) {
    try {
      grading::build_target(loop, book, {target_of(*exercise)});
      usable.push_back(exercise);
    } catch (const grading::BookError& error) {
      results.push_back({"exercise", exercise->id(), {error.what()}});
    }
  }
  exercises = std::move(usable);
}

std::vector<DevResult> check_answers(const grading::Book& book,
                                     const grading::BuildDescription& build,
                                     const std::vector<AnswerJob>& jobs, unsigned workers,
                                     ProgressLine& line) {
  const grading::Limits limits = grading::limits_from_environment();
  std::vector<std::vector<DevResult>> by_job(jobs.size());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> interrupted{false};
  std::mutex mutex;
  std::size_t done = 0;
  std::string failure;
  const auto work = [&] {
    grading::Loop loop;
    try {
      for (std::size_t i = next++; i < jobs.size() && !interrupted; i = next++) {
        by_job[i] = check_answer(loop, book, build, jobs[i], limits);
        const std::lock_guard<std::mutex> lock(mutex);
        line.show(std::to_string(++done) + " of " + std::to_string(jobs.size()) +
                  " answers checked: " + jobs[i].name);
      }
    } catch (const grading::Interrupted&) {
      interrupted = true;
    } catch (const std::exception& error) {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = error.what();
      interrupted = true;
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < workers; ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (!failure.empty()) throw grading::BookError(failure);
  if (interrupted) throw grading::Interrupted{};
  std::vector<DevResult> results;
  for (std::vector<DevResult>& of_job : by_job)
    std::move(of_job.begin(), of_job.end(), std::back_inserter(results));
  return results;
}

std::string plural(const std::string& kind) {
  return kind == "generated code" || kind.ends_with("s") ? kind : kind + "s";
}

int print(const std::vector<DevResult>& results, bool json) {
  const Style style(stdout);
  std::map<std::string, std::array<int, 2>> counts;
  int passed = 0;
  int failed = 0;
  nlohmann::json list = nlohmann::json::array();
  for (const DevResult& result : results) {
    const bool good = result.problems.empty();
    (good ? passed : failed) += 1;
    counts[result.kind][good ? 0 : 1] += 1;
    list.push_back({{"kind", result.kind},
                    {"name", result.name},
                    {"passed", good},
                    {"problems", result.problems},
                    {"said", result.said}});
    if (good && !json && !result.said.empty()) say(result.said);
    if (good || json) continue;
    say(style.bad("failed") + "  " + result.kind + " " + style.bold(result.name));
    if (!result.said.empty()) say(wrapped(result.said, 10, 110));
    for (const std::string& problem : result.problems) say(wrapped(problem, 10, 110));
  }
  if (json) {
    nlohmann::json by_kind = nlohmann::json::object();
    for (const auto& [kind, count] : counts)
      by_kind[plural(kind)] = {{"passed", count[0]}, {"failed", count[1]}};
    say(nlohmann::json{{"format", "contact-dev-check/1"},
                       {"passed", passed},
                       {"failed", failed},
                       {"counts", by_kind},
                       {"results", list}}
            .dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    std::string text;
    for (const auto& [kind, count] : counts)
      text += (text.empty() ? "" : ", ") + std::to_string(count[0] + count[1]) + " " + plural(kind);
    say(text + ".");
    say(std::to_string(passed) + " passed, " + std::to_string(failed) + " failed");
  }
  return failed == 0 ? exit_passed : exit_not_passed;
}

int run(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  std::vector<DevResult> results = check_book_files(book);
  std::vector<const Exercise*> exercises = book.chosen(options.names);
  if (!options.names.empty()) {
    std::erase_if(results, [&](const DevResult& result) {
      return std::none_of(exercises.begin(), exercises.end(),
                          [&](const Exercise* exercise) { return exercise->id() == result.name; });
    });
  }
  if (options.names.empty()) {
    for (DevResult& result : check_lessons(context.loop(), book))
      results.push_back(std::move(result));
  }
  const grading::TemporaryFolder folder;
  for (DevResult& result : apply_patches(context.loop(), book, exercises, folder.path()))
    results.push_back(std::move(result));
  for (DevResult& result : write_forms(context.loop(), book, exercises, folder.path()))
    results.push_back(std::move(result));
  if (!exercises.empty() && !options.files_only) {
    ProgressLine line(!options.json);
    line.show("Building what is not current ...");
    build_all(context.loop(), book, exercises, results);
    const grading::BuildDescription build = grading::read_build_description(book.build_dir());
    const std::vector<AnswerJob> jobs = answer_jobs(exercises, folder.path());
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    for (DevResult& result :
         check_answers(book, build, jobs, options.jobs > 0 ? options.jobs : cores, line))
      results.push_back(std::move(result));
  }
  return print(results, options.json);
}

}  // namespace

void add_dev(Command app, Action& action) {
  const Command command = app.add_subcommand(dev_command);
  command.require_subcommand();
  auto options = std::make_shared<Options>();
  const Command check = command.add_subcommand(
      "check",
      "Check that stubs, solutions, wrong answers and null answers get the right verdicts");
  check.add_option("exercise", options->names, "Only these exercises, or those of these chapters");
  check.add_option("--jobs", options->jobs, "Answers checked in parallel (default: one per core)");
  check.add_flag("--files", options->files_only, "Check only the files; build and run nothing");
  check.add_flag("--json", options->json, "Print JSON");
  check.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
  add_dev_mutants(command, action);
  add_dev_registry(command, action);
#ifdef CONTACT_GRADE
  add_dev_box(command, action);
  add_dev_grade(command, action);
#endif
}

}  // namespace contact::cli
