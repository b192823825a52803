// contact grade: marks a folder of untrusted submissions. grading/grade/session.hpp implements the
// grading; this file has the options and the messages.

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "../../grading/grade/session.hpp"
#include "../../grading/text/shown_text.hpp"
#include "../commands.hpp"
#include "../program.hpp"
#include "../terminal/terminal.hpp"
#include "grade_report.hpp"

namespace fs = std::filesystem;

namespace contact::cli {

namespace {

using grading::Book;
using grading::BookError;
using grading::Job;

struct Options {
  grading::SessionSettings session;
  std::string autograder;
  std::vector<std::string> why;  // of a student, in an exercise
  bool similar = false;
  bool json = false;
};

// --- What a session tells
// --------------------------------------------------------------------------------------

class Teller final : public grading::SessionListener {
 public:
  Teller(const grading::SessionSettings& settings, const Style& style)
      : settings_(settings), style_(style) {}

  void on_weak_machine(grading::Level level) override {
    note(style_.warn("This machine enforces less than it should (" +
                     std::string(grading::words(level)) +
                     "); `contact doctor` says what, and so do the reports."));
  }

  void on_passed_over(const std::vector<std::string>& entries) override {
    note("Ignored, because they are not submissions: " + listed(entries));
  }

  void on_absent(const std::vector<std::string>& entries) override {
    note("Named in " + settings_.ids + " and not there: " + listed(entries));
  }

  void on_measuring() override {
    note("Grading the exercises' own solutions, to measure their time ...");
  }

  void on_fewer_workers(int workers) override {
    note("Only " + std::to_string(workers) +
         " at a time: on this machine more would share a quota, and marks would vary.");
  }

  void on_reused(std::size_t units, std::size_t of) override {
    note(std::to_string(units) + " of " + std::to_string(of) + " units are graded already.");
  }

  void on_once_more(std::size_t units) override {
    note(std::to_string(units) + (units == 1 ? " unit was" : " units were") +
         " near a time limit: once more, alone ...");
  }

  void on_begin(std::size_t units, int workers) override { progress_.emplace(units, workers); }
  void on_graded(const Job& job) override { progress_->finished(job); }
  void on_end() override { progress_.reset(); }

  void on_note(const std::string& text) override {
    if (progress_)
      progress_->say_beside(text);
    else
      note(text);
  }

  // Boxes end with this program, and the next run removes their folder.
  void on_hang(const std::string& what) override {
    if (::write(STDERR_FILENO, what.data(), what.size()) < 0) {
      // The output is not read; the exit code says that nothing was graded.
    }
    ::_exit(exit_trouble);
  }

 private:
  static std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; ++i)
      text += (i == 0 ? "" : ", ") + grading::escaped(names[i]);
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                               : text;
  }

  const grading::SessionSettings& settings_;
  const Style& style_;
  std::optional<GradeProgress> progress_;
};

// --- What is said at the end
// --------------------------------------------------------------------------------------

void tell_troubles(const std::map<Job, std::string>& troubles, const std::string& again,
                   const Style& style) {
  for (const auto& [job, what] : troubles)
    note(style.bad("contact: ") + printable(job.submission) + ", " + job.exercise +
         " could not be graded: " + printable(what));
  note(std::string(troubles.size() == 1 ? "That is" : "Those are") +
       " not the student's fault and no mark: reports leave it empty. All other marks are "
       "written. Once the cause is fixed, this grades what is missing and nothing else:\n  " +
       again);
}

nlohmann::json troubles_json(const std::map<Job, std::string>& troubles) {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& [job, what] : troubles)
    json.push_back({{"submission", job.submission}, {"exercise", job.exercise}, {"problem", what}});
  return json;
}

void tell_as_json(const grading::SessionOutcome& outcome, const fs::path& results,
                  const std::string& again) {
  nlohmann::json document = grading::to_json(outcome.summary);
  document["format"] = "contact-grade-summary/1";
  document["results"] = results.string();
  document["machine"] = outcome.results.at("machine");
  document["units"] = grading::units_json(outcome);
  document["could_not_be_graded"] = troubles_json(outcome.troubles);
  if (!outcome.troubles.empty()) document["again"] = again;
  if (outcome.changes) document["changes"] = outcome.changes->at("changes");
  say(document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void tell(const grading::SessionOutcome& outcome, const fs::path& results, const Style& style) {
  say(grade_summary(outcome.results, outcome.summary, style));
  if (const std::string refused = refusals(outcome.results); !refused.empty())
    say(style.bad("Refused:") + "\n" + refused);
  if (outcome.changes) say(changes_table(*outcome.changes, style));
  if (!outcome.earlier.empty()) say("The earlier results: " + shown(outcome.earlier));
  say("Seed: " + outcome.seed + ". Reports: " + shown(results / "class.html") + ", " +
      shown(results / "gradebook.csv") + ", " + shown(results / "students") + "/");
}

// --- One grading
// --------------------------------------------------------------------------------------

int grade(Context& context, const Options& options) {
  grading::Loop& loop = context.loop();
  const Book& book = context.book();
  grading::SessionSettings settings = options.session;
  settings.version = program_version();
  settings.again = command_again(book.book_root());
  const Style style(stdout);
  Teller teller(settings, style);
  grading::Session session(loop, book, settings, teller);
  const grading::SessionOutcome& outcome = session.grade();
  const bool troubled = !outcome.troubles.empty();
  try {
    session.write_reports();
  } catch (const BookError&) {
    if (troubled) tell_troubles(outcome.troubles, settings.again, style);
    throw;
  }
  session.write_record();
  if (options.json)
    tell_as_json(outcome, session.folder().results(), settings.again);
  else
    tell(outcome, session.folder().results(), style);
  if (troubled) {
    tell_troubles(outcome.troubles, settings.again, style);
    return exit_trouble;
  }
  const bool refused = outcome.summary.refused + outcome.summary.refused_files > 0;
  return refused ? exit_not_passed : exit_passed;
}

// Packs this book and what is asked for into an archive that a school's system grades with. The
// reports' Python does it, which also runs there.
int pack_autograder(Context& context, const Options& options) {
  const Book& book = context.book();
  if (book.base() != nullptr)
    throw BookError("--autograder can only hold the book's exercises yet, not those of a pack");
  const grading::SessionSettings& asked = options.session;
  grading::ProcessSpec spec = grading::report_module(book, "reports.autograder");
  spec.command.push_back(fs::absolute(options.autograder).lexically_normal().string());
  const auto give = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) spec.command.insert(spec.command.end(), {name, value});
  };
  std::string exercises;
  if (!asked.exercises.empty()) {
    for (const grading::Exercise* exercise : book.chosen(asked.exercises))
      exercises += (exercises.empty() ? "" : ",") + exercise->id();
  }
  const auto file = [](const std::string& name) {
    return name.empty() ? name : fs::absolute(name).lexically_normal().string();
  };
  give("--exercises", exercises);
  give("--private", file(asked.private_tests));
  give("--profile", file(asked.profile));
  give("--seed", asked.seed);
  give("--due", asked.reports.due);
  if (asked.accept_weak) spec.command.emplace_back("--accept-weak");
  spec.environment.emplace_back("CONTACT_ROOT", book.root().string());
  const grading::ProcessResult result = grading::run_process(context.loop(), spec);
  std::string words = result.errors;
  while (!words.empty() && words.back() == '\n') words.pop_back();
  note(words);
  return result.exit_code;
}

// Runs a report that is not of the results alone, and passes on what it says.
int pass_on(Context& context, const grading::ProcessSpec& spec) {
  const auto without_newline = [](std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
  };
  const grading::ProcessResult result = grading::run_process(context.loop(), spec);
  if (!result.output.empty()) say(without_newline(result.output));
  if (!result.errors.empty()) note(without_newline(result.errors));
  return result.exit_code;
}

std::string results_of(const Options& options) {
  return fs::absolute(options.session.results).lexically_normal().string();
}

// Tells what an instructor needs to answer a request for a regrade. It only reads.
int tell_why(Context& context, const Options& options) {
  grading::ProcessSpec spec = grading::report_module(context.book(), "reports.why");
  if (!options.session.reports.due.empty())
    spec.command.insert(spec.command.end(), {"--due", options.session.reports.due});
  spec.command.insert(spec.command.end(), {"--", results_of(options)});
  spec.command.insert(spec.command.end(), options.why.begin(), options.why.end());
  return pass_on(context, spec);
}

// Writes which answers are alike where few others are.
int tell_similar(Context& context, const Options& options) {
  grading::ProcessSpec spec = grading::report_module(context.book(), "reports.similar");
  spec.command.insert(spec.command.end(),
                      {"--", results_of(options), context.book().root().string()});
  return pass_on(context, spec);
}

int run(Context& context, const Options& options) {
  if (!options.why.empty()) return tell_why(context, options);
  if (options.similar) return tell_similar(context, options);
  if (!options.autograder.empty()) return pack_autograder(context, options);
  try {
    return grade(context, options);
  } catch (const grading::Interrupted&) {
    note("Stopped. Finished units are kept: the same command continues.");
    throw;
  }
}

}  // namespace

void add_grade(Command app, Action& action) {
  auto options = std::make_shared<Options>();
  const Command command = app.add_subcommand(grade_command);
  const Option submissions =
      command.add_option("submissions", options->session.submissions,
                         "A folder; each entry is a student's folder, .zip, .tar.gz or .cpp");
  const Option output = command.add_option(
      "-o,--output", options->session.results,
      "Folder for the results; run again with the same folder to continue or to regrade");
  command
      .add_option("--exercises", options->session.exercises,
                  "Exercises or chapters, separated by commas; by default the whole book")
      .separated_by(',');
  command.add_option("--ids", options->session.ids,
                     "CSV with columns entry, id and optionally name: the student of each entry");
  command
      .add_option("--workers", options->session.workers,
                  "Units in parallel; by default one per core")
      .between(1, 1024);
  command
      .add_option("--engine", options->session.engine, "local (this machine) or slurm (a cluster)")
      .one_of({"local", "slurm"});
  command.add_option("--seed", options->session.seed,
                     "Seed of the random cases; by default the folder's, drawn in the first run");
  command.add_option("--private", options->session.private_tests,
                     "Folder of tests that are not in the book");
  command.add_option("--profile", options->session.profile, "TOML file that sets limits");
  command.add_option("--due", options->session.reports.due,
                     "Due date: tests with after_due are shown only after it");
  command
      .add_option("--formats", options->session.reports.formats,
                  "Reports to write; all if not given")
      .separated_by(',');
  command
      .add_option("--autograder", options->autograder,
                  "Grade nothing: write FILE.zip, an autograder for Gradescope or PrairieLearn")
      .excludes(submissions)
      .excludes(output);
  command
      .add_option("--why", options->why,
                  "Grade nothing: tell why STUDENT has this mark in EXERCISE, with all values")
      .values(2)
      .type_name("STUDENT EXERCISE")
      .excludes(submissions);
  command
      .add_flag("--similar", options->similar,
                "Grade nothing: list answers that are alike where few others are")
      .excludes(submissions);
  command.add_flag("--accept-weak", options->session.accept_weak,
                   "Grade although this machine cannot isolate submissions");
  command.add_flag("--recalibrate", options->session.recalibrate,
                   "Measure the times of the solutions again; the time limits depend on them");
  command.add_flag("--json", options->json, "Print JSON");
  command.add_option("--partition", options->session.slurm.partition, "Slurm: the partition");
  command.add_option("--account", options->session.slurm.account, "Slurm: the account");
  command.add_option("--time", options->session.slurm.time, "Slurm: a task's time limit");
  command.add_option("--units-a-task", options->session.slurm.units_a_task,
                     "Slurm: units in one task");
  command.add_option("--slurm-options", options->session.slurm.more,
                     "Slurm: more options of sbatch");
  const std::string usage =
      ": `contact grade FOLDER --output RESULTS` grades the submissions in FOLDER and writes the "
      "results and reports to the folder RESULTS.";
  command.callback([&action, options, usage] {
    const bool grades = options->autograder.empty() && options->why.empty() && !options->similar;
    if (grades && options->session.submissions.empty())
      throw MissingOption("A folder of submissions is required" + usage);
    if (options->autograder.empty() && options->session.results.empty())
      throw MissingOption("--output is required" + usage);
    action = [options](Context& context) { return run(context, *options); };
  });
}

}  // namespace contact::cli
