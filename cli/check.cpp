// contact check: compile, link and run the student's copies against the tests.

#include <nlohmann/json.hpp>

#include "../grading/progress.hpp"
#include "../grading/run.hpp"
#include "commands.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Exercise;
using grading::Verdict;

struct Options {
  std::vector<std::string> names;
  bool json = false;
  bool full = false;
  bool all = false;
};

struct Job {
  const Exercise* exercise;
  fs::path file;
};

// A path to a file checks that file (an author's, say); a name checks the student's copy.
Job job_for(const grading::Book& book, const std::string& name) {
  const Exercise* exercise = &book.exercise(name);
  if (const fs::path path(name); path.extension() == ".cpp") {
    if (!fs::is_regular_file(path)) throw grading::UnknownName("there is no file " + name);
    return {exercise, fs::absolute(path).lexically_normal()};
  }
  return {exercise, book.work_file(*exercise)};
}

std::vector<Job> jobs_for(const grading::Book& book, const Options& options) {
  std::vector<Job> jobs;
  for (const std::string& name : options.names) {
    if (const grading::Chapter* chapter = book.find_chapter(name);
        chapter != nullptr && !book.find_exercise(name)) {
      for (const Exercise* exercise : book.exercises_of(*chapter)) {
        if (book.started(*exercise)) jobs.push_back({exercise, book.work_file(*exercise)});
      }
    } else {
      jobs.push_back(job_for(book, name));
    }
  }
  return jobs;
}

// What is started, in two parts: copies that were changed, and those that are still as they were
// given, whose verdict is known.
struct Started {
  std::vector<Job> changed;
  std::vector<std::string> untouched;
};

Started started(const grading::Book& book) {
  Started result;
  for (const Exercise& exercise : book.exercises()) {
    if (!book.started(exercise)) continue;
    const fs::path copy = book.work_file(exercise);
    if (grading::read_text(copy) == grading::read_text(exercise.stub))
      result.untouched.push_back(exercise.id());
    else
      result.changed.push_back({&exercise, copy});
  }
  return result;
}

int run(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  std::vector<Job> jobs = jobs_for(book, options);
  std::vector<std::string> untouched;
  if (options.names.empty()) {
    Started all = started(book);
    jobs = std::move(all.changed);
    untouched = std::move(all.untouched);
  }
  if (!untouched.empty() && !options.json)
    note(std::to_string(untouched.size()) + (untouched.size() == 1 ? " copy is" : " copies are") +
         " as given, so not attempted.");
  for (const Job& job : jobs) {
    if (!fs::exists(job.file)) {
      note("You have not started " + job.exercise->id() + " yet: ./contact start " +
           job.exercise->name);
      return exit_not_passed;
    }
  }
  if (jobs.empty()) {
    if (untouched.empty())
      note(
          "Nothing is started yet. `contact list` shows what there is; `contact start EXERCISE` "
          "begins.");
    if (options.json)
      say(nlohmann::json{{"format", "contact-check/1"},
                         {"points", 0.0},
                         {"max_points", 0.0},
                         {"untouched", untouched},
                         {"results", nlohmann::json::array()}}
              .dump(2));
    return exit_not_passed;
  }
  std::vector<const Exercise*> exercises;
  for (const Job& job : jobs) exercises.push_back(job.exercise);
  const grading::Limits limits = grading::limits_from_environment();
  const grading::BuildDescription build = grading::ready_build(context.loop(), book, exercises);
  grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());

  const Style style(stdout);
  nlohmann::json results = nlohmann::json::array();
  double points = 0.0;
  double max_points = 0.0;
  std::size_t passed = 0;
  for (const Job& job : jobs) {
    const Verdict verdict =
        grading::check_file(context.loop(), book, build, *job.exercise, job.file, limits);
    if (job.file == book.work_file(*job.exercise)) progress.record(verdict);
    passed += verdict.outcome == grading::Outcome::passed ? 1 : 0;
    points += verdict.points;
    max_points += verdict.max_points;
    if (options.json)
      results.push_back(grading::to_json(verdict));
    else
      say(report(verdict, style, {options.full, options.all}) + (jobs.size() > 1 ? "\n" : ""));
  }
  if (options.json)
    say(nlohmann::json{{"format", "contact-check/1"},
                       {"points", points},
                       {"max_points", max_points},
                       {"untouched", untouched},
                       {"results", results}}
            .dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else if (jobs.size() > 1)
    say(std::to_string(passed) + " of " + std::to_string(jobs.size()) + " exercises passed, " +
        grading::points_text(points) + " of " + grading::points_text(max_points) + " points.");
  return passed == jobs.size() ? exit_passed : exit_not_passed;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("check", "Check your copies; all that you have started if none is named");
  command->add_option("exercise", options->names,
                      "Exercises or chapters: ray_triangle, 02_triangles/ray_triangle, "
                      "work/02_triangles/ray_triangle.cpp");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--full", options->full,
                    "On a compile error, print all that the compiler said");
  command->add_flag("--all", options->all, "Show every failure whole, not only the first");
  command->callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
