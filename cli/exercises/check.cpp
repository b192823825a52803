// contact check: compile, link and run the student's copies, or those in an archive, against the
// tests.

#include <algorithm>

#include <nlohmann/json.hpp>

#include "../../grading/archive/archive.hpp"
#include "../../grading/progress/progress.hpp"
#include "../../grading/run/run.hpp"
#include "../commands.hpp"
#include "../terminal/terminal.hpp"
#include "report.hpp"

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
  /// What a reader knows the file by, if not by its path.
  std::string known_as = {};
};

// What is to be checked, and what is not.
struct Task {
  std::vector<Job> jobs;
  /// Copies that are still as they were given, whose verdict is known.
  std::vector<std::string> untouched;
  /// The archive that the copies come from; empty if they are the student's own.
  std::string archive;
  /// Files of it that answer to no exercise of this book.
  std::vector<std::string> unknown;
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

// All that is started: copies that were changed, and those that are still as they were given.
Task started(const grading::Book& book) {
  Task task;
  for (const Exercise& exercise : book.exercises()) {
    if (!book.started(exercise)) continue;
    const fs::path copy = book.work_file(exercise);
    if (grading::read_text(copy) == grading::read_text(exercise.stub))
      task.untouched.push_back(exercise.id());
    else
      task.jobs.push_back({&exercise, copy});
  }
  return task;
}

// The same of an archive, whose copies are put in a folder for the time of the check.
Task archived(const grading::Book& book, const std::string& name, const fs::path& folder) {
  if (!fs::exists(name)) throw grading::UnknownName("there is no file " + name);
  const grading::Submission submission = grading::read_submission(name);
  Task task;
  task.archive = name;
  for (const grading::ArchivedCopy& copy : submission.copies) {
    const auto exercise =
        std::find_if(book.exercises().begin(), book.exercises().end(),
                     [&](const Exercise& candidate) { return candidate.id() == copy.id(); });
    if (exercise == book.exercises().end()) {
      task.unknown.push_back(copy.path());
    } else if (copy.text == grading::read_text(exercise->stub)) {
      task.untouched.push_back(copy.id());
    } else {
      const fs::path file = folder / copy.path();
      fs::create_directories(file.parent_path());
      grading::write_text(file, copy.text);
      task.jobs.push_back({&*exercise, file, name + ":" + copy.path()});
    }
  }
  return task;
}

// A text that speaks of the file as the reader knows it, and not of where it was put.
std::string as_known(std::string text, const Job& job) {
  if (job.known_as.empty()) return text;
  for (const std::string& path : {job.file.string(), shown(job.file)}) {
    for (std::size_t at = text.find(path); at != std::string::npos;
         at = text.find(path, at + job.known_as.size()))
      text.replace(at, path.size(), job.known_as);
  }
  return text;
}

nlohmann::json as_known(nlohmann::json json, const Job& job) {
  if (json.is_string()) return as_known(json.get<std::string>(), job);
  if (json.is_structured()) {
    for (nlohmann::json& part : json) part = as_known(std::move(part), job);
  }
  return json;
}

struct Totals {
  double points = 0.0;
  double max_points = 0.0;
  std::size_t passed = 0;
  nlohmann::json results = nlohmann::json::array();
};

nlohmann::json json_of(const Task& task, const Totals& totals) {
  nlohmann::json document = {{"format", "contact-check/2"},
                             {"points", totals.points},
                             {"max_points", totals.max_points},
                             {"untouched", task.untouched},
                             {"results", totals.results}};
  if (!task.archive.empty()) {
    document["archive"] = task.archive;
    document["unknown"] = task.unknown;
  }
  return document;
}

void say_what_is_not_checked(const Task& task) {
  const std::size_t count = task.untouched.size();
  if (count > 0)
    note(std::to_string(count) + (count == 1 ? " copy is" : " copies are") +
         " as given, so not attempted.");
  for (const std::string& path : task.unknown)
    note("Skipped: " + path + " belongs to no exercise of this book.");
}

Totals check_all(Context& context, const Options& options, const std::vector<Job>& jobs) {
  const grading::Book& book = context.book();
  std::vector<const Exercise*> exercises;
  for (const Job& job : jobs) exercises.push_back(job.exercise);
  const grading::Limits limits = grading::limits_from_environment();
  const grading::BuildDescription build = grading::ready_build(context.loop(), book, exercises);
  grading::Progress progress(book.work());
  if (!progress.notice().empty()) note(progress.notice());

  const Style style(stdout);
  Totals totals;
  for (const Job& job : jobs) {
    const Verdict verdict = grading::check_file(
        context.loop(), book, build, *job.exercise, job.file, limits,
        job.file == book.work_file(*job.exercise) ? progress.known() : grading::ProgressRecord());
    if (job.file == book.work_file(*job.exercise)) progress.record(verdict);
    totals.passed += verdict.outcome == grading::Outcome::passed ? 1 : 0;
    totals.points += verdict.points;
    totals.max_points += verdict.max_points;
    if (options.json)
      totals.results.push_back(as_known(grading::to_json(verdict), job));
    else
      say(as_known(report(verdict, style, {options.full, options.all}), job) +
          (jobs.size() > 1 ? "\n" : ""));
  }
  return totals;
}

int check(Context& context, const Options& options, const Task& task) {
  if (!options.json) say_what_is_not_checked(task);
  for (const Job& job : task.jobs) {
    if (!fs::exists(job.file)) {
      note("You have not started " + job.exercise->id() + " yet: " + program_as_typed() +
           " start " + job.exercise->name);
      return exit_not_passed;
    }
  }
  if (task.jobs.empty() && task.untouched.empty())
    note(task.archive.empty()
             ? "Nothing is started yet. `" + program_as_typed() + " list` shows what there is; `" +
                   program_as_typed() + " start EXERCISE` begins."
             : "There is nothing to check in " + shown(task.archive) + ".");
  const Totals totals = task.jobs.empty() ? Totals{} : check_all(context, options, task.jobs);
  if (options.json)
    say(json_of(task, totals).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else if (task.jobs.size() > 1)
    say(std::to_string(totals.passed) + " of " + std::to_string(task.jobs.size()) +
        " exercises passed, " + grading::points_text(totals.points) + " of " +
        grading::points_text(totals.max_points) + " points.");
  const bool well = !task.jobs.empty() && totals.passed == task.jobs.size() && task.unknown.empty();
  return well ? exit_passed : exit_not_passed;
}

int run(Context& context, const Options& options) {
  const grading::Book& book = context.book();
  const bool archive =
      std::any_of(options.names.begin(), options.names.end(),
                  [](const std::string& name) { return grading::is_archive_name(name); });
  if (!archive)
    return check(context, options,
                 options.names.empty() ? started(book) : Task{jobs_for(book, options), {}, {}, {}});
  if (options.names.size() > 1)
    throw grading::UnknownName("an archive is checked alone: give one name, and no exercises");
  const grading::TemporaryFolder folder;
  return check(context, options, archived(book, options.names.front(), folder.path()));
}

}  // namespace

void add_check(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command =
      app.add_subcommand("check", "Check your copies; without a name, all that you have started");
  command.add_option("exercise", options->names,
                     "Exercises or chapters: ray_triangle, 02_triangles/ray_triangle, "
                     "work/02_triangles/ray_triangle.cpp; or one archive, FILE.zip");
  command.add_flag("--json", options->json, "Print JSON");
  command.add_flag("--full", options->full,
                   "On a compile error, print the compiler's complete output");
  command.add_flag("--all", options->all,
                   "Show every failure in full, not only the first; those of one cause once");
  command.callback([&action, options] {
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
